#include "core/surface/generator_checks.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/surface/normal_map.h"

namespace glint {

std::string number_text(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6);
  return {text.data(), end.ptr};
}

Error generator_error(std::string_view field, std::string sentence) {
  return request_error("surface.generator." + std::string(field), std::move(sentence));
}

Error cancelled_error() {
  return content_error("surface.generator", "the generation was cancelled");
}

Error memory_error(int size) {
  return content_error("surface.generator.size", "there is not enough memory for a map of " + std::to_string(size) +
                                                     " x " + std::to_string(size) + " texels");
}

std::optional<Error> check_number(std::string_view field, double value, double low, double high) {
  if (value >= low && value <= high) return std::nullopt;  // NaN is in no interval
  return generator_error(
      field, "must be from " + number_text(low) + " to " + number_text(high) + ", not " + number_text(value));
}

std::optional<Error> check_interval(std::string_view field, glm::dvec2 interval, double low, double high) {
  if (low <= interval.x && interval.x <= interval.y && interval.y <= high) return std::nullopt;
  return generator_error(field, "must be two numbers from " + number_text(low) + " to " + number_text(high) +
                                    ", the smaller first, not " + number_text(interval.x) + " and " +
                                    number_text(interval.y));
}

std::optional<Error> check_size(int size, int smallest, bool power_of_two) {
  const bool shape_is_right = !power_of_two || std::has_single_bit(static_cast<unsigned>(size));
  if (size >= smallest && size <= k_largest_map_side && shape_is_right) return std::nullopt;
  return generator_error("size", std::string("must be ") + (power_of_two ? "a power of two " : "") + "from " +
                                     std::to_string(smallest) + " to " + std::to_string(k_largest_map_side) + ", not " +
                                     std::to_string(size));
}

}  // namespace glint
