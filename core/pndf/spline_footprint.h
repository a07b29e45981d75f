#pragma once
// A wide footprint as a sum of cubic B-spline windows over a map: G_p(u) = about sum w_b B3((u - u_b) / H) / H^2. What
// a window sees does not depend on the footprint, so it can be computed once and looked up; what the sum is off G_p has
// a bound that holds for every map and normal.

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "core/pndf/footprint.h"
#include "core/surface/normal_map.h"

namespace glint {

/// Centres of windows: node (i, j) stands at (i pitch.x, j pitch.y) texels. On a map that repeats a whole number of
/// them fits into each period.
struct SplineLattice {
  int level;  ///< lattices of one map with equal levels are equal
  glm::dvec2 pitch;
  glm::ivec2 count;  ///< nodes of one period; those of a map that clamps go on beyond it
  bool periodic;

  /// The coarsest that suits the footprint's narrowest deviation, which must be at least k_least_deviation.
  static SplineLattice for_footprint(const NormalMap& map, const SymmetricMatrix2& covariance);

  static constexpr double k_least_deviation = 16;  ///< texels
  static constexpr double k_least_ratio = 1.45;    ///< deviations to a pitch: the bound is then about 2e-3
};

/// The values at x in [0, 1] of the four cubic B-splines over a cell, centred at -1, 0, 1 and 2.
std::array<double, 4> cubic_b_splines(double x);

/// Immutable; one footprint on one lattice.
class SplineFootprint {
 public:
  struct Node {
    std::int64_t i;  ///< brought into the first period where the lattice is periodic
    std::int64_t j;
    double weight;  ///< w_b: they sum to 1
  };

  SplineFootprint(const SplineLattice& lattice, const NormalMap& map, const Footprint& footprint);

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  /// The integral of |G_p - sum|, by quadrature at four points a pitch with a tenth added: no density D_P moves by more
  /// than this in L1.
  [[nodiscard]] double bound() const { return bound_; }

  /// About how many nodes a footprint has before they are brought into one period.
  static double node_count(const SplineLattice& lattice, const SymmetricMatrix2& covariance);

 private:
  std::vector<Node> nodes_;
  double bound_ = 0;
};

}  // namespace glint
