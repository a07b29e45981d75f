#include "viewers/inspector/field_edits.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "core/document/value_words.h"
#include "viewers/widgets/number_text.h"

namespace glint::view {
namespace {

std::string capitalised(std::string text) {
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') text.front() = static_cast<char>(text.front() - 32);
  return text;
}

struct EditText {
  std::string operator()(std::monostate) const { return "none"; }
  std::string operator()(bool flag) const { return flag ? "on" : "off"; }
  std::string operator()(double number) const { return short_number_text(number); }
  std::string operator()(std::uint64_t number) const { return fmt::format("{}", number); }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(const std::vector<double>& numbers) const {
    std::string text;
    for (const double number : numbers) text += (text.empty() ? "" : ", ") + short_number_text(number);
    return text;
  }
  std::string operator()(const std::vector<std::string>& texts) const {
    std::string text;
    for (const std::string& part : texts) text += (text.empty() ? "" : ", ") + part;
    return text;
  }
};

// The field's name in front of what is wrong with it.
Error explained_error(const Error& error) {
  const Parameter* const parameter = find_parameter(error.subject);
  const std::string subject = parameter && error.sentence.starts_with("is ") ? std::string(parameter->label) : "";
  return {error.kind, error.subject, capitalised(subject.empty() ? error.sentence : subject + " " + error.sentence)};
}

std::uint64_t nearest_power_of_two(double value) {
  return std::uint64_t{1} << static_cast<unsigned>(std::clamp(std::round(std::log2(std::max(1.0, value))), 0.0, 40.0));
}

// The other fields of the generators, so that the one of `fault` fits.
void fit(Document& document, const Error& fault) {
  NoiseSettings& noise = document.surface.noise;
  ScratchSettings& scratches = document.surface.scratches;
  FlakeSettings& flakes = document.surface.flakes;
  if (fault.subject == "surface.generator.size") {
    const double size = slider_number(find_parameter(fault.subject)->get(document)).value_or(32);
    noise.size = scratches.size = flakes.size = std::max(32, static_cast<int>(nearest_power_of_two(size)));
  } else if (fault.subject == "surface.generator.correlation_length") {
    noise.correlation_length = noise.size / 4.0;
  } else if (fault.subject == "surface.generator.wavelengths") {
    noise.wavelengths.y = std::min<double>(noise.wavelengths.y, noise.size);
    noise.wavelengths.x = std::min(noise.wavelengths.x, noise.wavelengths.y);
  } else if (fault.subject == "surface.generator.radius") {
    const glm::dvec2 radii = flake_radii(flakes.size);
    flakes.radius = std::clamp(flakes.radius, radii.x, radii.y);
  }
}

void replace(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

// Without the unit and with an ASCII minus; a count's letter becomes its power of ten.
std::string plain_words(const Parameter& parameter, std::string_view text) {
  std::string words(text);
  replace(words, "−", "-");
  for (const std::string_view unit : {parameter.unit, std::string_view("°"), std::string_view("tx")}) {
    if (!unit.empty()) replace(words, unit, "");
  }
  const std::size_t end = words.find_last_not_of(' ');
  if (end == std::string::npos) return {};
  words.erase(end + 1);
  if (parameter.kind != ParameterKind::integer) return words;
  constexpr std::array k_letters{std::pair{'k', 1e3}, std::pair{'M', 1e6}, std::pair{'G', 1e9}};
  for (const auto& [letter, factor] : k_letters) {
    if (words.back() != letter) continue;
    const std::optional<double> number = parsed_number(std::string_view(words).substr(0, words.size() - 1));
    if (number) return copy_text(std::round(*number * factor));
  }
  return words;
}

Result<ParameterValue> typed_value(const Parameter& parameter, const std::vector<double>& shown, std::size_t component,
                                   std::string_view text) {
  if (parameter.kind == ParameterKind::text || parameter.kind == ParameterKind::path) {
    return value_from_words(parameter, text);
  }
  const std::string words = plain_words(parameter, text);
  const std::optional<double> number = parsed_number(words);
  if (parameter.kind != ParameterKind::numbers || !number || component >= shown.size()) {
    return value_from_words(parameter, words);
  }
  std::vector<double> changed = shown;
  changed[component] = *number;
  return parameter.checked(changed);
}

bool is_allowed(const Document& document, const Parameter& parameter, const ParameterValue& value) {
  Document changed = document;
  return parameter.set(changed, value) && !document_fault(changed);
}

double rounded_number(const SliderRange& slider, double value) {
  const double size = slider.logarithmic ? std::abs(value) : slider.highest - slider.lowest;
  if (!(size > 0)) return value;
  const double step = std::pow(10, std::floor(std::log10(size)) - 2);
  // Through the decimal digits: 3 steps of 0.1 are 0.3, not 0.30000000000000004.
  const double steps = std::round(value / step);
  return std::strtod(fmt::format("{}e{}", static_cast<std::int64_t>(steps), std::lround(std::log10(step))).c_str(),
                     nullptr);
}

bool counts_in_powers_of_two(const Parameter& parameter) {
  const ParameterValue value = parameter.default_value();
  const auto* count = std::get_if<std::uint64_t>(&value);
  return count && *count > 1 && std::has_single_bit(*count) && parameter.slider.logarithmic;
}

// The round values at a slider's place, the best first.
std::vector<ParameterValue> round_values(const Parameter& parameter, double wanted) {
  const SliderRange& slider = parameter.slider;
  const double inside = std::clamp(wanted, slider.lowest, slider.highest);
  if (parameter.kind != ParameterKind::integer) return {rounded_number(slider, inside)};
  if (counts_in_powers_of_two(parameter)) {
    const auto power = static_cast<double>(nearest_power_of_two(inside));
    const double halfway = power * (inside > power ? 1.5 : 0.75);
    const bool is_halfway = std::abs(std::log2(inside / halfway)) < std::abs(std::log2(inside / power));
    return {static_cast<std::uint64_t>(is_halfway ? halfway : power), static_cast<std::uint64_t>(power)};
  }
  const double step = slider.logarithmic && inside >= 100 ? std::pow(10, std::floor(std::log10(inside)) - 1) : 1;
  return {static_cast<std::uint64_t>(std::round(inside / step) * step)};
}

std::optional<ParameterValue> round_and_allowed(const Document& document, const Parameter& parameter, double wanted) {
  for (ParameterValue& value : round_values(parameter, wanted)) {
    if (is_allowed(document, parameter, value)) return std::move(value);
  }
  return std::nullopt;
}

}  // namespace

std::string_view narrow_label(const Parameter& parameter) {
  return parameter.short_label.empty() ? parameter.label : parameter.short_label;
}

std::string symbol_text(std::string_view symbol) {
  constexpr std::array k_letters{std::pair{std::string_view("sigma"), "σ"}, std::pair{std::string_view("Sigma"), "Σ"},
                                 std::pair{std::string_view("alpha"), "α"}, std::pair{std::string_view("kappa"), "κ"}};
  for (const auto& [name, letter] : k_letters) {
    if (symbol.starts_with(name)) return letter + std::string(symbol.substr(name.size()));
  }
  return std::string(symbol);
}

std::string full_label(const Parameter& parameter) {
  std::string label = capitalised(std::string(parameter.label));
  if (!parameter.symbol.empty()) label += "  " + symbol_text(parameter.symbol);
  return label;
}

std::string sentence_text(std::string_view note) {
  std::string text = capitalised(std::string(note));
  replace(text, "`--", "“");
  replace(text, "`", "”");
  if (!text.empty() && text.back() != '.') text += '.';
  return text;
}

std::string edit_text(const ParameterValue& value) {
  return std::visit(EditText(), value);
}

Result<Edit> proposed(const Document& document, const Parameter& parameter, const ParameterValue& value) {
  Edit edit{document, {}, true};
  if (const Status done = parameter.set(edit.document, value); !done) return explained_error(done.error());
  if (std::optional<Error> fault = document_fault(edit.document)) return explained_error(*std::move(fault));
  edit.label = fmt::format("{} to {}", narrow_label(parameter), edit_text(value));
  return edit;
}

Result<Edit> proposed_choice(const Document& document, const Parameter& parameter, const std::string& choice) {
  Document fitted = document;
  if (!parameter.set(fitted, choice)) return proposed(document, parameter, choice);
  for (int tries = 0; tries < 3; ++tries) {
    const std::optional<Error> fault = document_fault(fitted);
    if (!fault) break;
    fit(fitted, *fault);
  }
  return proposed(fitted, parameter, choice);
}

Result<Edit> typed_edit(const Document& document, const Parameter& parameter, const std::vector<double>& shown,
                        std::size_t component, std::string_view text) {
  const Result<ParameterValue> value = typed_value(parameter, shown, component, text);
  if (!value) return explained_error(value.error());
  return proposed(document, parameter, *value);
}

std::optional<ParameterValue> slid_value(const Document& document, const Parameter& parameter, double wanted,
                                         bool by_key) {
  std::optional<ParameterValue> value = round_and_allowed(document, parameter, wanted);
  const ParameterValue now = parameter.get(document);
  const std::optional<double> from = slider_number(now);
  if (!by_key || !from || (value && *value != now)) return value;
  const SliderRange& slider = parameter.slider;
  const double step = slider.logarithmic ? wanted / *from : wanted - *from;
  for (int k = 2; k <= 100; ++k) {  // one step is a hundredth of the slider
    const double further = slider.logarithmic ? *from * std::pow(step, k) : *from + k * step;
    value = round_and_allowed(document, parameter, further);
    if (value && *value != now) return value;
  }
  return std::nullopt;
}

std::optional<double> slider_number(const ParameterValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* whole = std::get_if<std::uint64_t>(&value)) return static_cast<double>(*whole);
  return std::nullopt;
}

}  // namespace glint::view
