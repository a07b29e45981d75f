#include "core/document/value_words.h"

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace glint {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

std::vector<std::string_view> split(std::string_view words) {
  std::vector<std::string_view> parts;
  for (std::size_t comma = words.find(','); comma != std::string_view::npos; comma = words.find(',')) {
    parts.push_back(trimmed(words.substr(0, comma)));
    words.remove_prefix(comma + 1);
  }
  parts.push_back(trimmed(words));
  return parts;
}

// The whole text as a number, whatever the locale.
template <class Number>
std::optional<Number> number_from(std::string_view text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, value);
  if (fault != std::errc() || stop != end || text.empty()) return std::nullopt;
  return value;
}

std::optional<ParameterValue> whole_number_from(std::string_view words) {
  if (const auto whole = number_from<std::uint64_t>(words)) return *whole;
  if (const auto written = number_from<double>(words)) return *written;  // 1e7
  return std::nullopt;
}

// "0.25" or "1/4".
std::optional<ParameterValue> fraction_from(std::string_view words) {
  const std::size_t bar = words.find('/');
  const std::optional<double> above = number_from<double>(trimmed(words.substr(0, bar)));
  if (bar == std::string_view::npos || !above) return above ? std::optional<ParameterValue>(*above) : std::nullopt;
  const std::optional<double> below = number_from<double>(trimmed(words.substr(bar + 1)));
  if (!below || *below == 0) return std::nullopt;
  return *above / *below;
}

std::optional<ParameterValue> numbers_from(std::string_view words) {
  std::vector<double> values;
  for (const std::string_view part : split(words)) {
    const std::optional<double> value = number_from<double>(part);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

std::optional<ParameterValue> typed_value(const Parameter& parameter, std::string_view words) {
  switch (parameter.kind) {
    case ParameterKind::number:
      return fraction_from(words);
    case ParameterKind::integer:
      return whole_number_from(words);
    case ParameterKind::flag:
      if (words == "true" || words == "false") return words == "true";
      return std::nullopt;
    case ParameterKind::numbers:
      return numbers_from(words);
    case ParameterKind::choices: {
      const std::vector<std::string_view> names = split(words);
      return std::vector<std::string>(names.begin(), names.end());
    }
    case ParameterKind::text:
    case ParameterKind::path:
    case ParameterKind::choice:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

Result<ParameterValue> value_from_words(const Parameter& parameter, std::string_view words) {
  const std::string_view typed = trimmed(words);
  if (parameter.may_be_none && (typed == "none" || typed == "auto")) return ParameterValue(std::monostate());
  std::optional<ParameterValue> value = typed_value(parameter, typed);
  return parameter.checked(value ? *std::move(value) : ParameterValue(std::string(typed)));
}

}  // namespace glint
