#include "viewers/widgets/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace glint::view {
namespace {

constexpr std::string_view k_minus = "−";
constexpr std::size_t k_plain_up_to = 5;  // characters of a short number that never becomes a power of ten
constexpr std::array<std::string_view, 10> k_superscripts = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

std::string for_people(std::string_view ascii) {
  std::string text;
  for (const char c : ascii) {
    if (c == '-') {
      text += k_minus;
    } else {
      text += c;
    }
  }
  return text;
}

std::optional<std::string> special_text(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  if (value == 0) return "0";
  return std::nullopt;
}

// value = lead x 10^exponent with 1 <= |lead| < 10, once it is rounded to `digits`.
struct Scientific {
  std::string lead;
  int exponent;
};

Scientific scientific(double value, int digits) {
  const std::string text = fmt::format("{:.{}e}", value, digits - 1);
  const std::size_t e = text.find('e');
  return {text.substr(0, e), std::atoi(text.c_str() + e + 1)};
}

// The number that the digits say; strtod would ask the locale.
double without_power(const std::string& lead, int exponent) {
  const std::string text = fmt::format("{}e{}", lead, exponent);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::string superscript(int number) {
  std::string text = number < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(number))) text += k_superscripts[static_cast<std::size_t>(c - '0')];
  return text;
}

std::string without_trailing_zeros(std::string text) {
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

std::string number_text(double value, int digits) {
  if (const std::optional<std::string> special = special_text(value)) return *special;
  const auto [lead, exponent] = scientific(value, digits);
  if (exponent < -3 || exponent > 4) return for_people(lead) + "×10" + superscript(exponent);
  return for_people(fmt::format("{:.{}f}", without_power(lead, exponent), std::max(0, digits - 1 - exponent)));
}

std::string short_number_text(double value, int digits) {
  if (const std::optional<std::string> special = special_text(value)) return *special;
  const auto [lead, exponent] = scientific(value, digits);
  const std::string plain =
      without_trailing_zeros(fmt::format("{:.{}f}", without_power(lead, exponent), std::max(0, digits - 1 - exponent)));
  const std::string power = without_trailing_zeros(lead) + "e" + std::to_string(exponent);
  // Few digits are read at a glance; a power of ten has to earn its place.
  const bool plain_is_best = plain.size() <= k_plain_up_to || plain.size() <= power.size();
  return for_people(plain_is_best ? plain : power);
}

std::string decimal_text(double value, int decimals) {
  if (!std::isfinite(value)) return *special_text(value);
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find_first_not_of("-0.") == std::string::npos && text.front() == '-') text.erase(0, 1);  // no minus zero
  return for_people(text);
}

Quantity time_text(double milliseconds) {
  if (milliseconds != 0 && std::abs(milliseconds) < 0.09995) return {number_text(milliseconds * 1e3), "µs"};
  if (std::abs(milliseconds) < 999.5) return {number_text(milliseconds), "ms"};
  return {number_text(milliseconds * 1e-3), "s"};
}

Quantity percent_text(double share) {
  const double percent = 100 * share;
  if (!std::isfinite(percent) || percent == 0) return {number_text(percent), "%"};
  const double size = std::abs(percent);
  if (size < 0.095) return {number_text(percent, 1), "%"};
  return {size < 99.95 ? decimal_text(percent, 1) : number_text(percent), "%"};
}

std::string count_text(std::uint64_t count) {
  const auto value = static_cast<double>(count);
  const auto scaled = [](double shown, std::string_view unit) {
    return without_trailing_zeros(number_text(shown)) + std::string(unit);
  };
  if (value < 1e3) return std::to_string(count);
  if (value < 999.5e3) return scaled(value / 1e3, " k");
  if (value < 999.5e6) return scaled(value / 1e6, " M");
  return scaled(value / 1e9, " G");
}

std::string copy_text(double value) {
  return fmt::format("{}", value);
}

std::optional<double> parsed_number(std::string_view text) {
  std::string ascii;
  for (std::size_t at = 0; at < text.size();) {
    if (text.substr(at, k_minus.size()) == k_minus) {
      ascii += '-';
      at += k_minus.size();
    } else {
      ascii += text[at++];
    }
  }
  const std::size_t first = ascii.find_first_not_of(' ');
  if (first == std::string::npos) return std::nullopt;
  ascii = ascii.substr(first, ascii.find_last_not_of(' ') + 1 - first);
  if (ascii.front() == '+' && ascii.size() > 1 && ascii[1] != '-') ascii.erase(0, 1);
  double value = 0;
  const char* end = ascii.data() + ascii.size();
  const auto [stop, fault] = std::from_chars(ascii.data(), end, value);
  if (fault != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace glint::view
