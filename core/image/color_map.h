#pragma once
// The default colour map of densities: viridis, with colours of their own for what lies outside its range, so that
// false colour never hides clipping. And the map of signed differences.

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

namespace glint {

/// 8-bit display (sRGB-encoded) colour.
using DisplayColor = glm::vec<3, std::uint8_t>;

inline constexpr DisplayColor k_underflow_color{0x0b, 0x0b, 0x0b};
inline constexpr DisplayColor k_overflow_color{0xff, 0x4d, 0xf0};

/// Viridis (S. van der Walt and N. Smith, CC0) at x in [0, 1]; underflow below, overflow above.
DisplayColor viridis(double x);

/// Blue below 0, near black at 0, red above; for x outside [-1, 1] the colour of that end, for NaN pure red.
DisplayColor difference_color(double x);

/// The maps as textures: entry k is the colour at k / 255 of the way from the lowest value to the highest.
std::array<DisplayColor, 256> viridis_table();
std::array<DisplayColor, 256> difference_table();

/// A range of densities shown logarithmically. Zero is underflow, not the lowest colour.
struct LogScale {
  double lo = 1e-3;
  double hi = 1;

  [[nodiscard]] double position(double density) const;
  [[nodiscard]] DisplayColor color(double density) const;
};

/// Four decades below the largest density, rounded up to 1, 2 or 5 x 10^n.
LogScale fitted_scale(double largest_density);

}  // namespace glint
