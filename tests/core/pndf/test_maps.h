#pragma once
// Small maps and footprints that the tests of the P-NDF share.

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "core/math/random.h"
#include "core/pndf/footprint.h"
#include "core/pndf/pndf_model.h"
#include "core/surface/normal_map.h"

namespace glint::test {

using MapPointer = std::shared_ptr<const NormalMap>;

inline MapPointer map_of(int width, int height, Wrap wrap, const std::function<glm::dvec2(int, int)>& normal) {
  std::vector<glm::vec2> normals;
  normals.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) normals.emplace_back(normal(i, j));
  }
  return std::make_shared<NormalMap>(width, height, std::move(normals), wrap);
}

inline MapPointer constant_map(glm::dvec2 normal, Wrap wrap = Wrap::repeat, int size = 8) {
  return map_of(size, size, wrap, [&](int, int) { return normal; });
}

/// Independent normals in [-range, range]^2: nothing is rougher.
inline MapPointer rough_map(int width, int height, Wrap wrap, double range = 0.3, std::uint64_t seed = 1) {
  RandomStream random(seed, 0);
  return map_of(width, height, wrap, [&](int, int) {
    const double s = random.next_uniform();
    return range * glm::dvec2(2 * s - 1, 2 * random.next_uniform() - 1);
  });
}

/// Two waves that repeat with the map.
inline MapPointer wavy_map(int width, int height, Wrap wrap, double range = 0.2) {
  return map_of(width, height, wrap, [&](int i, int j) {
    const double x = 2 * std::numbers::pi * (i + 0.5) / width;
    const double y = 2 * std::numbers::pi * (j + 0.5) / height;
    return range * glm::dvec2(std::sin(x + 0.4) + 0.3 * std::cos(2 * y), std::cos(y - x) - 0.2 * std::sin(y));
  });
}

/// The same as 8-bit files hold it: steps of 2 / 255, and so, on gentle slopes, many equal normals side by side.
inline MapPointer quantised(const NormalMap& map) {
  return map_of(map.width(), map.height(), map.wrap(), [&](int i, int j) {
    const glm::dvec2 n(map.texel(i, j));
    return glm::dvec2(std::round((n.x + 1) * 127.5), std::round((n.y + 1) * 127.5)) / 127.5 - 1.0;
  });
}

/// The map repeated `columns` x `rows` times in one.
inline MapPointer tiled(const NormalMap& map, int columns, int rows) {
  return map_of(map.width() * columns, map.height() * rows, map.wrap(),
                [&](int i, int j) { return glm::dvec2(map.texel(i % map.width(), j % map.height())); });
}

/// Deviations `large` along `angle` and `small` across.
inline Footprint turned_footprint(glm::dvec2 center, double large, double small, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double a = large * large;
  const double b = small * small;
  return {center, {a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c}};
}

inline double density_of(const PndfModel& model, const Footprint& footprint, glm::dvec2 s) {
  PndfWorkspace workspace;
  return model.at(footprint, workspace).pdf(s);
}

inline PndfImage image_of(const PndfModel& model, const Footprint& footprint, const PndfGrid& grid) {
  JobControl control;
  return model.image(footprint, grid, control).value();
}

/// Integral of |a - b| over that of b.
inline double relative_l1(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0;
  double sum = 0;
  for (std::size_t k = 0; k < b.size(); ++k) {
    difference += std::abs(a[k] - b[k]);
    sum += b[k];
  }
  return difference / sum;
}

}  // namespace glint::test
