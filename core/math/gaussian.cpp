#include "core/math/gaussian.h"

#include <cmath>
#include <numbers>

namespace glint {
namespace {

// a b - c d without cancellation: the rounding error of c d is computed and given back.
double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  const double error = std::fma(-c, d, cd);
  return std::fma(a, b, -cd) + error;
}

}  // namespace

double determinant(const SymmetricMatrix2& m) {
  return difference_of_products(m.xx, m.yy, m.xy, m.xy);
}

glm::dvec2 eigenvalues(const SymmetricMatrix2& m) {
  const double mean = 0.5 * (m.xx + m.yy);
  const double largest = mean + std::hypot(0.5 * (m.xx - m.yy), m.xy);
  return {largest, largest > 0 ? determinant(m) / largest : mean};
}

Whitening whitening(const SymmetricMatrix2& covariance) {
  const double det = determinant(covariance);
  const double root = std::sqrt(covariance.yy * det);
  return {std::sqrt(covariance.yy / det), -covariance.xy / root, 1 / std::sqrt(covariance.yy)};
}

CholeskyFactor cholesky(const SymmetricMatrix2& covariance) {
  const double l11 = std::sqrt(covariance.xx);
  return {l11, covariance.xy / l11, std::sqrt(determinant(covariance) / covariance.xx)};
}

double normal_density(glm::dvec2 d, const SymmetricMatrix2& covariance) {
  const Whitening white = whitening(covariance);
  const glm::dvec2 w = white.apply(d);
  return white.determinant() / (2 * std::numbers::pi) * std::exp(-0.5 * (w.x * w.x + w.y * w.y));
}

double normal_cdf(double x) {
  return 0.5 * std::erfc(-x / std::numbers::sqrt2);
}

}  // namespace glint
