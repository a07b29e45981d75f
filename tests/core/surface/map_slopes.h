#pragma once
// What the tests of the generators ask of a normal map: its slopes, and whether two maps are the same bytes.

#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

#include <glm/vec2.hpp>

#include "core/surface/normal_map.h"

namespace glint::test {

/// Where a square map or field keeps column i of row j, and how many texels it has.
inline std::size_t index_of(int i, int j, int size) {
  return static_cast<std::size_t>(j) * static_cast<std::size_t>(size) + static_cast<std::size_t>(i);
}
inline std::size_t texel_count(int size) {
  return index_of(0, size, size);
}

/// The slopes (h_u, h_v) behind a projected normal: the conventions' signs undone.
inline glm::dvec2 slope_of(glm::dvec2 normal) {
  const double z = std::sqrt(1 - normal.x * normal.x - normal.y * normal.y);
  return {-normal.x / z, normal.y / z};
}

inline std::vector<glm::dvec2> slopes_of(const NormalMap& map) {
  std::vector<glm::dvec2> slopes;
  slopes.reserve(map.normals().size());
  for (const glm::vec2 normal : map.normals()) slopes.push_back(slope_of(normal));
  return slopes;
}

/// Root mean square along u and along v.
inline glm::dvec2 rms_per_axis(const NormalMap& map) {
  glm::dvec2 sum{0, 0};
  for (const glm::dvec2 slope : slopes_of(map)) sum += slope * slope;
  const auto count = static_cast<double>(map.normals().size());
  return {std::sqrt(sum.x / count), std::sqrt(sum.y / count)};
}

inline double rms_slope(const NormalMap& map) {
  const glm::dvec2 rms = rms_per_axis(map);
  return std::sqrt((rms.x * rms.x + rms.y * rms.y) / 2);
}

inline bool same_bytes(const NormalMap& a, const NormalMap& b) {
  return a.bytes() == b.bytes() && std::memcmp(a.normals().data(), b.normals().data(), a.bytes()) == 0;
}

/// The largest change between a texel and its right or lower neighbour: within the map, and over its border.
struct Jumps {
  double inside = 0;
  double across_border = 0;
};
inline Jumps largest_jumps(const NormalMap& map) {
  Jumps jumps;
  for (int j = 0; j < map.height(); ++j) {
    for (int i = 0; i < map.width(); ++i) {
      const auto note = [&](glm::vec2 neighbour, bool border) {
        const glm::dvec2 change = glm::dvec2(neighbour) - glm::dvec2(map.texel(i, j));
        double& largest = border ? jumps.across_border : jumps.inside;
        largest = std::fmax(largest, std::hypot(change.x, change.y));
      };
      note(map.texel(i + 1, j), i + 1 == map.width());
      note(map.texel(i, j + 1), j + 1 == map.height());
    }
  }
  return jumps;
}

/// How far the slopes are from being those of any height field: RMS of dh_u/dv - dh_v/du by central differences over
/// the border, relative to that of the two derivatives. Near 1 for unrelated components, or where a sign is wrong.
inline double relative_curl(const NormalMap& map) {
  const auto slope = [&](int i, int j) { return slope_of(map.texel(i, j)); };
  double curl = 0;
  double scale = 0;
  for (int j = 0; j < map.height(); ++j) {
    for (int i = 0; i < map.width(); ++i) {
      const double u_along_v = 0.5 * (slope(i, j + 1).x - slope(i, j - 1).x);
      const double v_along_u = 0.5 * (slope(i + 1, j).y - slope(i - 1, j).y);
      curl += (u_along_v - v_along_u) * (u_along_v - v_along_u);
      scale += u_along_v * u_along_v + v_along_u * v_along_u;
    }
  }
  return std::sqrt(curl / scale);
}

}  // namespace glint::test
