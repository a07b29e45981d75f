#pragma once
// The moments of slopes under a footprint, texel by texel in double precision: a plain twin of the LEAN method.

#include <cmath>
#include <cstdint>

#include <glm/vec2.hpp>

#include "core/pndf/footprint.h"
#include "core/surface/normal_map.h"

namespace glint::test {

struct SlowMoments {
  double weight = 0;
  double x = 0;
  double y = 0;
  double xx = 0;
  double xy = 0;
  double yy = 0;
};

inline glm::dvec2 slow_slope(glm::vec2 normal) {
  const double s = static_cast<double>(normal.x);
  const double t = static_cast<double>(normal.y);
  const double z = std::sqrt(1 - s * s - t * t);
  return {-s / z, -t / z};
}

/// The mean and centred covariance of the slopes of all texels within 8.5 deviations, in two passes. A texel weighs the
/// footprint's density at its centre, or, with `points` > 1, that at points x points of its square.
inline SlowMoments slow_moments(const NormalMap& map, const Footprint& footprint, int points = 1) {
  const SymmetricMatrix2& c = footprint.covariance;
  const double det = c.xx * c.yy - c.xy * c.xy;
  const auto first = [](double center, double variance) {
    return static_cast<std::int64_t>(std::floor(center - 8.5 * std::sqrt(variance)));
  };
  const auto last = [](double center, double variance) {
    return static_cast<std::int64_t>(std::ceil(center + 8.5 * std::sqrt(variance)));
  };
  SlowMoments sum;
  for (int pass = 0; pass < 2; ++pass) {
    for (std::int64_t j = first(footprint.center.y, c.yy); j <= last(footprint.center.y, c.yy); ++j) {
      for (std::int64_t i = first(footprint.center.x, c.xx); i <= last(footprint.center.x, c.xx); ++i) {
        double weight = 0;
        for (int b = 0; b < points; ++b) {
          for (int a = 0; a < points; ++a) {
            const double x = static_cast<double>(i) + (a + 0.5) / points - footprint.center.x;
            const double y = static_cast<double>(j) + (b + 0.5) / points - footprint.center.y;
            weight += std::exp(-0.5 * (c.yy * x * x - 2 * c.xy * x * y + c.xx * y * y) / det);
          }
        }
        const glm::dvec2 m = slow_slope(map.texel(i, j));
        if (pass == 0) {
          sum.weight += weight;
          sum.x += weight * m.x;
          sum.y += weight * m.y;
        } else {
          sum.xx += weight * (m.x - sum.x) * (m.x - sum.x);
          sum.xy += weight * (m.x - sum.x) * (m.y - sum.y);
          sum.yy += weight * (m.y - sum.y) * (m.y - sum.y);
        }
      }
    }
    for (double* value : {&sum.x, &sum.y}) *value /= pass == 0 ? sum.weight : 1;
    for (double* value : {&sum.xx, &sum.xy, &sum.yy}) *value /= sum.weight;
  }
  return sum;
}

}  // namespace glint::test
