#pragma once
// One Gaussian over slopes, seen as a density over the disk of projected normals.

#include <glm/vec2.hpp>

#include "core/math/gaussian.h"
#include "core/pndf/lean_moments.h"
#include "core/pndf/pndf_grid.h"

namespace glint {

/// D(s) = N(m(s); mu, C + diag(base)) / z^4; 0 outside the unit disk, where no slope is.
class SlopeGaussian {
 public:
  /// `base` are the variances of what no texel resolves, both positive. C may be singular: the determinant is summed
  /// from what each part adds, so that a small base is not lost beside it.
  SlopeGaussian(const SlopeMoments& moments, glm::dvec2 base);

  /// Never negative, NaN or infinite, towards the rim either.
  [[nodiscard]] double density(glm::dvec2 s) const;
  /// The normal of the slope mu + L xi, of a standard normal deviate xi.
  [[nodiscard]] glm::dvec2 normal(glm::dvec2 deviate) const;

  [[nodiscard]] const glm::dvec2& mean() const { return mean_; }
  [[nodiscard]] const SymmetricMatrix2& covariance() const { return covariance_; }
  [[nodiscard]] const Whitening& whitening() const { return white_; }
  /// Of N, at its mean.
  [[nodiscard]] double peak() const { return peak_; }

 private:
  glm::dvec2 mean_;
  SymmetricMatrix2 covariance_;
  Whitening white_;
  CholeskyFactor factor_;
  double peak_;
};

/// Images leave out what lies further off in slopes: 7e-10 of the mass.
inline constexpr double k_slope_cut = 6.5;

/// Writes the density at the centres of the cells of rows first, first + 1, … last; `density` are all cells of the
/// grid, zero before. With vector instructions, in double precision.
void draw_slope_gaussian(const SlopeGaussian& gaussian, const PndfGrid& grid, int first, int last, double* density);

}  // namespace glint
