#include "core/surface/height_field.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

namespace glint {
namespace {

constexpr double k_steepest_slope = 1000;

// Central difference along a line of `size` samples; `at` returns the height of sample k of the line.
template <class At>
double difference(At at, int k, int size, Wrap wrap) {
  if (size == 1) return 0;
  int before = k - 1;
  int after = k + 1;
  if (wrap == Wrap::repeat) {
    before = (before + size) % size;
    after = after % size;
    return 0.5 * (at(after) - at(before));
  }
  before = std::max(before, 0);
  after = std::min(after, size - 1);
  return (at(after) - at(before)) / (after - before);
}

}  // namespace

glm::dvec2 normal_from_slopes(double h_u, double h_v) {
  const double w = std::sqrt(1 + h_u * h_u + h_v * h_v);
  return {(0 - h_u) / w, h_v / w};  // not -h_u: level ground is +0, never a "-0" on screen
}

HeightFieldNormals normals_from_heights(std::span<const float> heights, int width, int height, double scale,
                                        Wrap wrap) {
  assert(heights.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  std::vector<glm::vec2> normals(heights.size());
  std::size_t bad = 0;
  glm::ivec2 first{0, 0};
  const auto at = [&](int i, int j) {
    return scale *
           static_cast<double>(
               heights[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)]);
  };
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      const double h_u = difference([&](int k) { return at(k, j); }, i, width, wrap);
      const double h_v = difference([&](int k) { return at(i, k); }, j, height, wrap);
      glm::vec2 normal{0, 0};
      if (std::hypot(h_u, h_v) <= k_steepest_slope) {  // false for NaN and infinity too
        normal = glm::vec2(normal_from_slopes(h_u, h_v));
      } else if (bad++ == 0) {
        first = {i, j};
      }
      normals[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)] = normal;
    }
  }
  return {NormalMap(width, height, std::move(normals), wrap), bad, first};
}

}  // namespace glint
