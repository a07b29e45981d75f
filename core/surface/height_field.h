#pragma once
// Heights to normals (conventions: s = -h_u / w, t = +h_v / w, w = sqrt(1 + h_u^2 + h_v^2), u right and v down).

#include <cstddef>
#include <span>

#include <glm/vec2.hpp>

#include "core/surface/normal_map.h"

namespace glint {

/// The projected normal of a surface with slopes h_u and h_v (dimensionless, along right and down), in double.
glm::dvec2 normal_from_slopes(double h_u, double h_v);

struct HeightFieldNormals {
  NormalMap map;
  std::size_t bad_slopes = 0;  ///< texels whose slope was not finite or above 1000: made flat
  glm::ivec2 first_bad{0, 0};  ///< column and row of the first of them
};

/// Normals of a height field by central differences; one-sided at the border of a map that clamps.
/// `heights` holds width x height values, rows from the top; heights * scale are in texels.
HeightFieldNormals normals_from_heights(std::span<const float> heights, int width, int height, double scale, Wrap wrap);

}  // namespace glint
