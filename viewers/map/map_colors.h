#pragma once
// How texels of a normal map become colours: the normal itself, how steep it is, or how fast it turns. Pure functions
// of a pyramid level; display values, 8 bits.

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "core/document/document.h"
#include "core/image/color_map.h"
#include "core/surface/normal_pyramid.h"

namespace glint::view {

/// Values at the ends of the colours of slope and curvature; above and below are the colours of over- and underflow.
inline constexpr double k_steepest_slope = 1;
inline constexpr LogScale k_curvature_scale{1e-4, 1};  ///< per texel

/// sqrt(s^2 + t^2) / z; infinite on the rim of the disk and beyond.
double slope_of(glm::vec2 normal);
/// The Frobenius norm of dn/du per texel of the map, by central differences between the texels of that level.
double curvature_of(const NormalPyramid& pyramid, int level, std::int64_t i, std::int64_t j);

/// (s, t, z) / 2 + 1 / 2 in 8 bits: what a normal map stores, green up.
DisplayColor normal_color(glm::vec2 normal);
/// The colour of texel (i, j) of a level.
DisplayColor texel_color(const NormalPyramid& pyramid, MapColors colors, int level, std::int64_t i, std::int64_t j);

/// size.x x size.y texels of a level from `first` on, 4 bytes each (alpha 255), rows from the top. Positions beyond the
/// border follow the map's wrap.
std::vector<std::uint8_t> colored_texels(const NormalPyramid& pyramid, MapColors colors, int level, glm::ivec2 first,
                                         glm::ivec2 size);

/// A small picture of the whole map whose contrast is stretched to what the map has, for finding one's way.
struct Overview {
  glm::ivec2 size{0, 0};
  std::vector<std::uint8_t> texels;  ///< 4 bytes each
};
/// From the smallest level with at least `side` texels along its longer side.
Overview overview_of(const NormalPyramid& pyramid, MapColors colors, int side);

}  // namespace glint::view
