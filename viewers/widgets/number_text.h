#pragma once
// Numbers as text: for people (three significant digits, a real minus, units that keep them short) and for copies
// (every digit, ASCII). Pure functions; no locale changes anything.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace glint::view {

/// A figure and its unit, which is drawn smaller; `unit` may be empty.
struct Quantity {
  std::string value;
  std::string unit;

  friend bool operator==(const Quantity&, const Quantity&) = default;
};

/// `digits` significant ones: "0.0648", "1.07", "203", "−0.0034"; "1.23×10⁻⁵" below 0.001 and from 100 000 on; "0",
/// "∞", "NaN".
std::string number_text(double value, int digits = 3);

/// The same number as it would be typed, without zeros at its end, at most `digits` significant ones: "100", "0.01",
/// "2e−5", "1.25".
/// For entries and ends of axes: parsed_number() reads it.
std::string short_number_text(double value, int digits = 4);

/// With a fixed number of decimals: "−0.50", "1". Ticks of one axis agree in it.
std::string decimal_text(double value, int decimals);

/// "203 ms", "1.07 ms", "50.3 µs", "1.24 s".
Quantity time_text(double milliseconds);

/// A share as a percentage, one decimal from 0.1 % to 100 %, one significant digit below: "0.8 %", "13.4 %", "0.004 %".
Quantity percent_text(double share);

/// "100", "12.5 k", "1 M", "1.5 M".
std::string count_text(std::uint64_t count);

/// Shortest text that reads back as the same double: "-0.0034", "1e-05". For the clipboard and files.
std::string copy_text(double value);

/// What a person typed: a number with . as decimal point, an exponent, a sign (also U+2212), spaces around. None if it
/// is anything else or not finite.
std::optional<double> parsed_number(std::string_view text);

}  // namespace glint::view
