#pragma once
// Private to the generators: the checks of numbers a person typed, and their random streams. Every error names its
// field as presets and the command line do ("surface.generator.size"), the number that was given and what is allowed.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "core/math/random.h"
#include "core/math/result.h"

namespace glint {

/// What a random number is for. Each purpose has streams of its own, so that changing one setting reshuffles no other.
/// The values are part of every generated map: append, never renumber.
enum class RandomPurpose : std::uint64_t {
  white_noise = 1,
  wavelengths = 2,
  wave_directions = 3,
  wave_phases = 4,
  scratch_centers = 5,
  scratch_lengths = 6,
  scratch_half_widths = 7,
  scratch_flank_slopes = 8,
  scratch_directions = 9,
  flake_centers = 10,
  flake_slopes = 11,
  flake_flatness = 12,
};

/// Stream number `index` (below 2^32) of a purpose.
inline RandomStream random_stream(std::uint64_t seed, RandomPurpose purpose, std::uint64_t index = 0) {
  return {seed, (static_cast<std::uint64_t>(purpose) << 32U) | index};
}

/// Up to six significant digits, with a point whatever the locale.
std::string number_text(double value);

/// An error about the field surface.generator.`field`.
Error generator_error(std::string_view field, std::string sentence);
/// The error of a job that was cancelled.
Error cancelled_error();
/// The error of a map that does not fit into memory.
Error memory_error(int size);

/// Nothing, or what is wrong with a number that must lie in [low, high].
std::optional<Error> check_number(std::string_view field, double value, double low, double high);
/// Likewise for an interval: finite, its smaller end first, within [low, high].
std::optional<Error> check_interval(std::string_view field, glm::dvec2 interval, double low, double high);
/// Likewise for `size`: from `smallest` to the largest side of a map, and a power of two where an FFT needs it.
std::optional<Error> check_size(int size, int smallest, bool power_of_two);

}  // namespace glint
