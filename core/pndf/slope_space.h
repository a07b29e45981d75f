#pragma once
// Between projected normals and slopes. The slope of a normal is m = -(s, t) / z with z = sqrt(1 - s^2 - t^2); since
// ds = z^4 dm, a density over the disk is that over slopes divided by z^4: D(s) = P22(m) / z^4.

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace glint {

/// z^2 = 1 - |s|^2: positive inside the unit disk only.
inline double squared_height(glm::dvec2 normal) {
  return 1 - normal.x * normal.x - normal.y * normal.y;
}

/// m of a normal inside the unit disk.
inline glm::dvec2 slope_of_normal(glm::dvec2 normal) {
  return (-1 / std::sqrt(squared_height(normal))) * normal;
}

/// s of any slope: at most the rim of the disk.
inline glm::dvec2 normal_of_slope(glm::dvec2 slope) {
  return (-1 / std::sqrt(1 + glm::dot(slope, slope))) * slope;
}

}  // namespace glint
