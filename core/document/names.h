#pragma once
// How the choices of a document are written in presets, options, recipes and reports: one table a choice.

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <string_view>
#include <utility>

#include "core/document/document.h"

namespace glint {

template <class Choice>
struct ChoiceNames;

template <>
struct ChoiceNames<SurfaceSource> {
  static constexpr std::array k_table{std::pair{SurfaceSource::file, std::string_view("file")},
                                      std::pair{SurfaceSource::noise, std::string_view("noise")},
                                      std::pair{SurfaceSource::scratches, std::string_view("scratches")},
                                      std::pair{SurfaceSource::flakes, std::string_view("flakes")}};
};

template <>
struct ChoiceNames<PndfMethod> {
  static constexpr std::array k_table{std::pair{PndfMethod::exact, std::string_view("exact")},
                                      std::pair{PndfMethod::mixture, std::string_view("mixture")},
                                      std::pair{PndfMethod::lean, std::string_view("lean")},
                                      std::pair{PndfMethod::automatic, std::string_view("auto")},
                                      std::pair{PndfMethod::binning, std::string_view("binning")}};
};

template <>
struct ChoiceNames<ExactPrecision> {
  static constexpr std::array k_table{std::pair{ExactPrecision::single_precision, std::string_view("float")},
                                      std::pair{ExactPrecision::double_precision, std::string_view("double")}};
};

template <>
struct ChoiceNames<MixtureElements> {
  static constexpr std::array k_table{std::pair{MixtureElements::flat, std::string_view("flat")},
                                      std::pair{MixtureElements::curved, std::string_view("curved")},
                                      std::pair{MixtureElements::corrected, std::string_view("corrected")}};
};

template <>
struct ChoiceNames<ValueRange> {
  static constexpr std::array k_table{std::pair{ValueRange::automatic, std::string_view("auto")},
                                      std::pair{ValueRange::signed_values, std::string_view("signed")},
                                      std::pair{ValueRange::unsigned_values, std::string_view("unsigned")}};
};

template <>
struct ChoiceNames<GreenDirection> {
  static constexpr std::array k_table{std::pair{GreenDirection::up, std::string_view("up")},
                                      std::pair{GreenDirection::down, std::string_view("down")}};
};

template <>
struct ChoiceNames<Wrap> {
  static constexpr std::array k_table{std::pair{Wrap::repeat, std::string_view("repeat")},
                                      std::pair{Wrap::clamp, std::string_view("clamp")}};
};

template <>
struct ChoiceNames<Interpolation> {
  static constexpr std::array k_table{std::pair{Interpolation::smooth, std::string_view("smooth")},
                                      std::pair{Interpolation::linear, std::string_view("linear")},
                                      std::pair{Interpolation::constant, std::string_view("constant")}};
};

/// None is `auto`: smooth, or constant where the map is flagged piecewise constant.
template <>
struct ChoiceNames<std::optional<Interpolation>> {
  static constexpr std::array k_table{std::pair{std::optional<Interpolation>(), std::string_view("auto")},
                                      std::pair{std::optional(Interpolation::smooth), std::string_view("smooth")},
                                      std::pair{std::optional(Interpolation::linear), std::string_view("linear")},
                                      std::pair{std::optional(Interpolation::constant), std::string_view("constant")}};
};

template <>
struct ChoiceNames<NoiseSettings::Spectrum> {
  static constexpr std::array k_table{std::pair{NoiseSettings::Spectrum::gaussian, std::string_view("gaussian")},
                                      std::pair{NoiseSettings::Spectrum::band, std::string_view("band")}};
};

template <>
struct ChoiceNames<ColorScale> {
  static constexpr std::array k_table{std::pair{ColorScale::logarithmic, std::string_view("log")},
                                      std::pair{ColorScale::linear, std::string_view("linear")}};
};

template <>
struct ChoiceNames<MapColors> {
  static constexpr std::array k_table{std::pair{MapColors::normal, std::string_view("normal")},
                                      std::pair{MapColors::slope, std::string_view("slope")},
                                      std::pair{MapColors::curvature, std::string_view("curvature")}};
};

/// All names of a choice, in the order in which they are offered.
template <class Choice>
inline constexpr auto k_choice_names = [] {
  std::array<std::string_view, ChoiceNames<Choice>::k_table.size()> names;
  std::transform(ChoiceNames<Choice>::k_table.begin(), ChoiceNames<Choice>::k_table.end(), names.begin(),
                 [](const auto& entry) { return entry.second; });
  return names;
}();

/// The name of a value: every value of a choice has one.
template <class Choice>
std::string_view choice_name(Choice value) {
  for (const auto& [known, name] : ChoiceNames<Choice>::k_table) {
    if (known == value) return name;
  }
  assert(false && "a choice without a name");
  return {};
}

/// The name of a method as a title: acronyms in capitals.
inline std::string_view method_title(PndfMethod method) {
  switch (method) {
    case PndfMethod::mixture:
      return "Mixture";
    case PndfMethod::lean:
      return "LEAN";
    case PndfMethod::automatic:
      return "Auto";
    case PndfMethod::binning:
      return "Binning";
    case PndfMethod::exact:
      break;
  }
  return "Exact";
}

/// The value of that name, if there is one.
template <class Choice>
std::optional<Choice> choice_named(std::string_view text) {
  for (const auto& [value, name] : ChoiceNames<Choice>::k_table) {
    if (name == text) return value;
  }
  return std::nullopt;
}

}  // namespace glint
