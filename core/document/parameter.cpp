#include "core/document/parameter.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "core/document/text.h"
#include "core/pndf/pndf_grid.h"

namespace glint {
namespace {

constexpr std::size_t k_longest_text = 4096;          // bytes; no system's paths are longer
constexpr double k_largest_whole = 9007199254740992;  // 2^53: up to here a double is one certain integer

std::string range_text(const NumberRange& range) {
  std::string text = range.open_lowest ? fmt::format("above {} and at most {}", range.lowest, range.highest)
                                       : fmt::format("from {} to {}", range.lowest, range.highest);
  return range.without_zero ? text + ", not 0" : text;
}

bool inside(const NumberRange& range, double value) {  // false for NaN
  if (range.without_zero && value == 0) return false;
  return (range.open_lowest ? value > range.lowest : value >= range.lowest) && value <= range.highest;
}

bool is_known(std::span<const std::string_view> choices, std::string_view text) {
  return std::find(choices.begin(), choices.end(), text) != choices.end();
}

bool is_clean_text(std::string_view text) {
  const bool control =
      std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
  return !control && text.size() <= k_longest_text && !first_invalid_utf8(text);
}

// The functions below give `value` as a parameter of the kind holds it, or nothing where that is not allowed.

std::optional<double> as_number(const NumberRange& range, const ParameterValue& value) {
  double number = std::numeric_limits<double>::quiet_NaN();
  if (const auto* real = std::get_if<double>(&value)) number = *real;
  if (const auto* whole = std::get_if<std::uint64_t>(&value)) number = static_cast<double>(*whole);
  if (!inside(range, number)) return std::nullopt;
  return number + 0.0;  // -0 becomes 0: equal documents are written as equal bytes
}

std::optional<std::uint64_t> as_integer(const IntegerRange& range, const ParameterValue& value) {
  std::uint64_t integer = 0;
  if (const auto* whole = std::get_if<std::uint64_t>(&value)) {
    integer = *whole;
  } else if (const auto* real = std::get_if<double>(&value)) {
    if (!(*real >= 0 && *real <= k_largest_whole)) return std::nullopt;
    integer = static_cast<std::uint64_t>(*real);
    if (static_cast<double>(integer) != *real) return std::nullopt;
  } else {
    return std::nullopt;
  }
  if (integer < range.lowest || integer > range.highest) return std::nullopt;
  return integer;
}

std::optional<ParameterValue> as_numbers(const Parameter& parameter, const ParameterValue& value) {
  if (const auto* word = std::get_if<std::string>(&value)) {
    if (parameter.instead.empty() || *word != parameter.instead) return std::nullopt;
    return value;
  }
  const auto* given = std::get_if<std::vector<double>>(&value);
  if (!given || given->size() != parameter.components.size()) return std::nullopt;
  std::vector<double> numbers;
  for (const double entry : *given) {
    const std::optional<double> number = as_number(parameter.range, entry);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  for (std::size_t k = 0; parameter.ascending && k + 1 < numbers.size(); k += 2) {
    if (parameter.strictly ? numbers[k] >= numbers[k + 1] : numbers[k] > numbers[k + 1]) return std::nullopt;
  }
  return numbers;
}

bool are_choices(std::span<const std::string_view> choices, const ParameterValue& value) {
  const auto* names = std::get_if<std::vector<std::string>>(&value);
  if (!names || names->empty()) return false;
  for (auto name = names->begin(); name != names->end(); ++name) {
    if (!is_known(choices, *name) || std::find(names->begin(), name, *name) != name) return false;
  }
  return true;
}

std::optional<ParameterValue> as_text(const Parameter& parameter, const ParameterValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  if (!text) return std::nullopt;
  const bool allowed = parameter.kind == ParameterKind::choice
                           ? is_known(parameter.choices, *text)
                           : is_clean_text(*text) && (parameter.kind == ParameterKind::path || !text->empty());
  if (!allowed) return std::nullopt;
  return value;
}

std::optional<ParameterValue> as_held(const Parameter& parameter, const ParameterValue& value) {
  if (std::holds_alternative<std::monostate>(value)) {
    return parameter.may_be_none ? std::optional(value) : std::nullopt;
  }
  switch (parameter.kind) {
    case ParameterKind::number:
      return as_number(parameter.range, value);
    case ParameterKind::integer:
      return as_integer(parameter.integer_range, value);
    case ParameterKind::flag:
      return std::holds_alternative<bool>(value) ? std::optional(value) : std::nullopt;
    case ParameterKind::text:
    case ParameterKind::path:
    case ParameterKind::choice:
      return as_text(parameter, value);
    case ParameterKind::numbers:
      return as_numbers(parameter, value);
    case ParameterKind::choices:
      return are_choices(parameter.choices, value) ? std::optional(value) : std::nullopt;
  }
  return std::nullopt;
}

std::string numbers_allowed(const Parameter& parameter) {
  std::string text = fmt::format("{} numbers [{}] {}", parameter.components.size(),
                                 fmt::join(parameter.components, ", "), range_text(parameter.range));
  for (std::size_t k = 0; parameter.ascending && k + 1 < parameter.components.size(); k += 2) {
    text += fmt::format("{} {} {} {}", k == 0 ? "," : " and", parameter.components[k],
                        parameter.strictly ? "below" : "at most", parameter.components[k + 1]);
  }
  if (!parameter.instead.empty()) text += fmt::format(", or \"{}\"", parameter.instead);
  return text;
}

struct ValueText {
  std::string operator()(std::monostate) const { return "null"; }
  std::string operator()(bool flag) const { return flag ? "true" : "false"; }
  std::string operator()(double number) const { return fmt::format("{}", number); }
  std::string operator()(std::uint64_t number) const { return fmt::format("{}", number); }
  std::string operator()(const std::string& text) const { return fmt::format("\"{}\"", one_line(text)); }
  std::string operator()(const std::vector<double>& numbers) const {
    return one_line(fmt::format("[{}]", fmt::join(numbers, ", ")));
  }
  std::string operator()(const std::vector<std::string>& texts) const {
    return one_line(texts.empty() ? "[]" : fmt::format("[\"{}\"]", fmt::join(texts, "\", \"")));
  }
};

// Levenshtein's distance as a share of the longer text: 0 is equal, 1 has nothing in common.
double unlikeness(std::string_view a, std::string_view b) {
  if (a.empty() || b.empty()) return 1;
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return static_cast<double>(row.back()) / static_cast<double>(std::max(a.size(), b.size()));
}

std::string_view last_name(std::string_view path) {
  return path.substr(path.rfind('.') + 1);
}

double unlikeness(std::string_view asked, const Parameter& parameter) {
  constexpr double k_elsewhere = 0.2;  // the right name in the wrong object, or half a path
  double least = std::min({unlikeness(asked, parameter.path), unlikeness(asked, parameter.symbol),
                           unlikeness(asked, parameter.label),
                           k_elsewhere + unlikeness(last_name(asked), last_name(parameter.path))});
  for (std::size_t dot = parameter.path.find('.'); dot != std::string_view::npos;
       dot = parameter.path.find('.', dot + 1)) {
    least = std::min(least, k_elsewhere + unlikeness(asked, parameter.path.substr(0, dot)));
  }
  return least;
}

// What the generators ask of their settings together; their ranges one by one stand in the declarations.
std::optional<Error> noise_fault(const NoiseSettings& noise) {
  const bool gaussian = noise.spectrum == NoiseSettings::Spectrum::gaussian;
  if (gaussian && !std::has_single_bit(static_cast<unsigned>(noise.size))) {
    return request_error("surface.generator.size",
                         fmt::format("is {}; allowed: a power of two for Gaussian noise", noise.size));
  }
  if (gaussian && noise.correlation_length > noise.size / 4.0) {
    return request_error("surface.generator.correlation_length",
                         fmt::format("is {}; allowed: at most a quarter of the map's size, {}",
                                     noise.correlation_length, noise.size / 4.0));
  }
  if (!gaussian && noise.wavelengths.y > noise.size) {
    return request_error("surface.generator.wavelengths",
                         fmt::format("is [{}, {}]; allowed: at most the map's size, {}", noise.wavelengths.x,
                                     noise.wavelengths.y, noise.size));
  }
  return std::nullopt;
}

std::optional<Error> scratches_fault(const ScratchSettings& scratches) {
  constexpr int k_smallest_size = 32;
  if (scratches.size >= k_smallest_size && std::has_single_bit(static_cast<unsigned>(scratches.size))) {
    return std::nullopt;
  }
  return request_error("surface.generator.size", fmt::format("is {}; allowed: a power of two from {} for scratches",
                                                             scratches.size, k_smallest_size));
}

std::optional<Error> flakes_fault(const FlakeSettings& flakes) {
  const glm::dvec2 radii = flake_radii(flakes.size);
  if (flakes.radius >= radii.x && flakes.radius <= radii.y) return std::nullopt;
  return request_error("surface.generator.radius",
                       fmt::format("is {}; allowed: from {} to {} on a map of {} texels a side", flakes.radius, radii.x,
                                   radii.y, flakes.size));
}

std::optional<Error> surface_fault(const SurfaceDescription& surface) {
  switch (surface.source) {
    case SurfaceSource::file:
      if (!surface.path.empty()) return std::nullopt;
      return request_error("surface.path", "is empty; allowed: the path of a file, because surface.source is \"file\"");
    case SurfaceSource::noise:
      return noise_fault(surface.noise);
    case SurfaceSource::scratches:
      return scratches_fault(surface.scratches);
    case SurfaceSource::flakes:
      return flakes_fault(surface.flakes);
  }
  return std::nullopt;
}

}  // namespace

std::string Parameter::allowed() const {
  std::string text;
  switch (kind) {
    case ParameterKind::number:
      text = "a number " + range_text(range);
      break;
    case ParameterKind::integer:
      text = fmt::format("a whole number from {} to {}", integer_range.lowest, integer_range.highest);
      break;
    case ParameterKind::flag:
      text = "true or false";
      break;
    case ParameterKind::text:
      text = "text of one line";
      break;
    case ParameterKind::path:
      text = "the path of a file";
      break;
    case ParameterKind::choice:
      text = fmt::format("\"{}\"", fmt::join(choices, "\", \""));
      break;
    case ParameterKind::numbers:
      text = numbers_allowed(*this);
      break;
    case ParameterKind::choices:
      text = fmt::format("a list of \"{}\", at least one, none twice", fmt::join(choices, "\", \""));
      break;
  }
  return may_be_none ? text + ", or null" : text;
}

Result<ParameterValue> Parameter::checked(const ParameterValue& value) const {
  std::optional<ParameterValue> held = as_held(*this, value);
  if (held) return *std::move(held);
  return request_error(std::string(path), fmt::format("is {}; allowed: {}", value_text(value), allowed()));
}

Status Parameter::set(Document& document, const ParameterValue& value) const {
  const Result<ParameterValue> held = checked(value);
  if (!held) return held.error();
  access.set(document, *held);
  return success();
}

const Parameter* find_parameter(std::string_view path) {
  const std::span<const Parameter> all = parameters();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Parameter& p) { return p.path == path; });
  return found == all.end() ? nullptr : &*found;
}

const Parameter& nearest_parameter(std::string_view path) {
  path = path.substr(0, 200);  // nothing longer is near to anything; keeps the time small
  const Parameter* nearest = &parameters().front();
  double least = std::numeric_limits<double>::infinity();
  for (const Parameter& parameter : parameters()) {
    const double distance = unlikeness(path, parameter);
    if (distance < least) {
      least = distance;
      nearest = &parameter;
    }
  }
  return *nearest;
}

std::optional<Error> document_fault(const Document& document) {
  for (const Parameter& parameter : parameters()) {
    const Result<ParameterValue> held = parameter.checked(parameter.get(document));
    if (!held) return held.error();
  }
  if (std::optional<Error> fault = surface_fault(document.surface)) return fault;
  if (const std::optional<std::string> fault = footprint_fault(document.footprint)) {
    return request_error("footprint.covariance", *fault);
  }
  if (const auto& window = document.grid.window) {
    const int size = document.grid.size;
    const std::optional<std::string> fault = grid_fault({window->x, window->y, window->z, window->w, size, size});
    if (fault) return request_error("grid.window", *fault);
  }
  return std::nullopt;
}

std::string value_text(const ParameterValue& value) {
  return std::visit(ValueText(), value);
}

}  // namespace glint
