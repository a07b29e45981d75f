#pragma once
// A footprint wider than a map that repeats, folded into one period: F(u) = sum over all periods of G_p(u + k L). Then
// width x height cells are visited, however wide the footprint is.

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "core/pndf/footprint.h"
#include "core/surface/normal_map.h"

namespace glint {

/// F over one cell as a polynomial of degree 5 in each coordinate, relative to the cell's middle. Never negative; its
/// error is a share of F's largest value, not of F there.
class CellPolynomial {
 public:
  static constexpr std::size_t k_terms = 6;
  using Coefficients = std::array<std::array<double, k_terms>, k_terms>;

  explicit CellPolynomial(const Coefficients& coefficients) : coefficients_(coefficients) {}

  /// F per square texel at a position inside the cell, both coordinates in [0, 1].
  [[nodiscard]] double operator()(glm::dvec2 position) const;

 private:
  Coefficients coefficients_;
};

class FoldedFootprint {
 public:
  /// True where folding is both cheaper than visiting the periods one by one and accurate: the map repeats, the ellipse
  /// of `cut` deviations covers it four times over, and its narrowest deviation is at least 20 texels (then the
  /// polynomial's error is below 2e-11 of F's largest value).
  static bool pays(const NormalMap& map, const SymmetricMatrix2& covariance, double cut);

  /// F at the corners of all cells, from its Fourier series (Poisson's summation): terms below exp(-45) are dropped.
  /// `border` is the position of cell 0 in texels (SurfaceCells::border).
  FoldedFootprint(const NormalMap& map, const Footprint& footprint, double border);

  /// F over the cell (i, j) of the first period.
  [[nodiscard]] CellPolynomial over_cell(std::int64_t i, std::int64_t j) const;

 private:
  std::int64_t width_;
  std::int64_t height_;
  std::vector<double> corners_;
};

}  // namespace glint
