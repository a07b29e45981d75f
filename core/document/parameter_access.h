#pragma once
// Values in and out of the members of a document, for the declarations and nothing else. "In"
// expects what Parameter::checked() has let through.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "core/document/names.h"
#include "core/document/parameter.h"

namespace glint {

inline ParameterValue out_of(bool member) {
  return member;
}
inline ParameterValue out_of(double member) {
  return member;
}
inline ParameterValue out_of(int member) {
  return member < 0 ? ParameterValue(static_cast<double>(member)) : ParameterValue(static_cast<std::uint64_t>(member));
}
inline ParameterValue out_of(std::uint64_t member) {
  return member;
}
inline ParameterValue out_of(const std::string& member) {
  return member;
}
inline ParameterValue out_of(const std::filesystem::path& member) {
  return member.generic_string();
}
inline ParameterValue out_of(glm::dvec2 member) {
  return std::vector<double>{member.x, member.y};
}
inline ParameterValue out_of(const SymmetricMatrix2& member) {
  return std::vector<double>{member.xx, member.xy, member.yy};
}
inline ParameterValue out_of(const std::optional<double>& member) {
  return member ? ParameterValue(*member) : ParameterValue(std::monostate());
}
inline ParameterValue out_of(const std::optional<glm::dvec2>& member) {
  if (!member) return std::string("fit");
  return out_of(*member);
}
inline ParameterValue out_of(const std::optional<glm::dvec4>& member) {
  if (!member) return std::string("fit");
  return std::vector<double>{member->x, member->y, member->z, member->w};
}
inline ParameterValue out_of(const std::vector<PndfMethod>& member) {
  std::vector<std::string> names;
  names.reserve(member.size());
  for (const PndfMethod method : member) names.emplace_back(choice_name(method));
  return names;
}
template <class Choice>
inline ParameterValue out_of(const Choice& member) {
  return std::string(choice_name(member));
}

inline void into(bool& member, const ParameterValue& value) {
  member = std::get<bool>(value);
}
inline void into(double& member, const ParameterValue& value) {
  member = std::get<double>(value);
}
inline void into(int& member, const ParameterValue& value) {
  member = static_cast<int>(std::get<std::uint64_t>(value));
}
inline void into(std::uint64_t& member, const ParameterValue& value) {
  member = std::get<std::uint64_t>(value);
}
inline void into(std::string& member, const ParameterValue& value) {
  member = std::get<std::string>(value);
}
inline void into(std::filesystem::path& member, const ParameterValue& value) {
  member = std::get<std::string>(value);
}
inline void into(glm::dvec2& member, const ParameterValue& value) {
  const auto& numbers = std::get<std::vector<double>>(value);
  member = {numbers[0], numbers[1]};
}
inline void into(SymmetricMatrix2& member, const ParameterValue& value) {
  const auto& numbers = std::get<std::vector<double>>(value);
  member = {numbers[0], numbers[1], numbers[2]};
}
inline void into(std::optional<double>& member, const ParameterValue& value) {
  member.reset();
  if (const double* number = std::get_if<double>(&value)) member = *number;
}
inline void into(std::optional<glm::dvec2>& member, const ParameterValue& value) {
  member.reset();
  if (const auto* n = std::get_if<std::vector<double>>(&value)) member = {(*n)[0], (*n)[1]};
}
inline void into(std::optional<glm::dvec4>& member, const ParameterValue& value) {
  member.reset();
  if (const auto* n = std::get_if<std::vector<double>>(&value)) member = {(*n)[0], (*n)[1], (*n)[2], (*n)[3]};
}
inline void into(std::vector<PndfMethod>& member, const ParameterValue& value) {
  member.clear();
  for (const std::string& name : std::get<std::vector<std::string>>(value)) {
    member.push_back(choice_named<PndfMethod>(name).value_or(PndfMethod::exact));
  }
}
template <class Choice>
inline void into(Choice& member, const ParameterValue& value) {
  member = choice_named<Choice>(std::get<std::string>(value)).value_or(member);
}

// Access through a function from the document to the member.
template <auto member>
constexpr ParameterAccess at() {
  return {[](const Document& document) { return out_of(member(document)); },
          [](Document& document, const ParameterValue& value) { into(member(document), value); }};
}

// Access to a setting that all generators have: set together, read from the one in use.
template <auto setting>
constexpr ParameterAccess at_all_generators() {
  return {[](const Document& document) {
            const SurfaceDescription& surface = document.surface;
            switch (surface.source) {
              case SurfaceSource::noise:
                return out_of(setting(surface.noise));
              case SurfaceSource::flakes:
                return out_of(setting(surface.flakes));
              case SurfaceSource::file:
              case SurfaceSource::scratches:
                break;
            }
            return out_of(setting(surface.scratches));
          },
          [](Document& document, const ParameterValue& value) {
            into(setting(document.surface.noise), value);
            into(setting(document.surface.scratches), value);
            into(setting(document.surface.flakes), value);
          }};
}

}  // namespace glint
