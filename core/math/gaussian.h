#pragma once
// 2D Gaussians and the small symmetric matrices that describe them. Double precision, no allocation.

#include <glm/vec2.hpp>

namespace glint {

/// [[xx, xy], [xy, yy]]
struct SymmetricMatrix2 {
  double xx = 1;
  double xy = 0;
  double yy = 1;

  friend bool operator==(const SymmetricMatrix2&, const SymmetricMatrix2&) = default;
};

/// xx yy - xy^2, correct to an ulp or two however nearly singular the matrix is (Kahan's difference of products).
double determinant(const SymmetricMatrix2& m);

/// Eigenvalues, largest first; for standard deviations along the axes of an ellipse take their roots.
glm::dvec2 eigenvalues(const SymmetricMatrix2& m);

/// The upper triangular W = [[w11, w12], [0, w22]] with W^T W = covariance^-1: |W d| is the distance in standard
/// deviations (the Mahalanobis distance) of the offset d.
struct Whitening {
  double w11;
  double w12;
  double w22;

  [[nodiscard]] glm::dvec2 apply(glm::dvec2 d) const { return {w11 * d.x + w12 * d.y, w22 * d.y}; }
  [[nodiscard]] double determinant() const { return w11 * w22; }
};

/// `covariance` must be positive definite.
Whitening whitening(const SymmetricMatrix2& covariance);

/// The lower triangular L = [[l11, 0], [l21, l22]] with L L^T = covariance: L xi of a standard normal xi has it.
struct CholeskyFactor {
  double l11;
  double l21;
  double l22;

  [[nodiscard]] glm::dvec2 apply(glm::dvec2 xi) const { return {l11 * xi.x, l21 * xi.x + l22 * xi.y}; }
};

/// `covariance` must be positive definite.
CholeskyFactor cholesky(const SymmetricMatrix2& covariance);

/// N(d; 0, covariance) per unit area.
double normal_density(glm::dvec2 d, const SymmetricMatrix2& covariance);

/// Phi(x), the standard normal distribution function, with full relative accuracy in the lower tail.
double normal_cdf(double x);

}  // namespace glint
