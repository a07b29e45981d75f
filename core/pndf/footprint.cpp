#include "core/pndf/footprint.h"

#include <cmath>
#include <numbers>

namespace glint {
namespace {
constexpr double k_largest_deviation = 1e5;  // texels
}

Footprint isotropic_footprint(glm::dvec2 center, double radius) {
  return {center, {radius * radius, 0, radius * radius}};
}

glm::dvec2 spread_deviate(int k, int count) {
  const double share = (k + 0.5) / count;
  const double radius = std::sqrt(-2 * std::log1p(-share));
  const double angle = k * std::numbers::pi * (3 - std::sqrt(5.0));
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

std::optional<std::string> footprint_fault(const Footprint& footprint) {
  const SymmetricMatrix2& c = footprint.covariance;
  for (const double value : {footprint.center.x, footprint.center.y, c.xx, c.xy, c.yy}) {
    if (!std::isfinite(value)) return "the footprint must be five finite numbers";
  }
  if (std::abs(footprint.center.x) > 1e9 || std::abs(footprint.center.y) > 1e9) {
    return "the footprint's centre must lie within 1e9 texels";
  }
  if (!(c.xx > 0 && c.yy > 0 && determinant(c) > 0)) {
    return "the footprint's covariance SXX, SXY, SYY must be positive definite (SXX > 0, SYY > 0, SXX SYY > SXY^2)";
  }
  const glm::dvec2 variances = eigenvalues(c);
  if (std::sqrt(variances.x) > k_largest_deviation) return "the footprint's deviation must be at most 100000 texels";
  if (!(std::sqrt(variances.y) >= 1e-6)) return "the footprint's deviation must be at least 1e-6 texels";
  return std::nullopt;
}

}  // namespace glint
