#pragma once
// What an exact image starts from, in either precision.

#include <algorithm>
#include <cmath>

#include "core/pndf/cell_visit.h"
#include "core/pndf/exact_pndf.h"

namespace glint {

class ExactImageSetup {
 protected:
  ExactImageSetup(const ExactPndf& model, const Footprint& footprint, const PndfGrid& grid)
      : cells_(model.cells()),
        footprint_{reduced_center(cells_.surface().map(), footprint.center), footprint.covariance},
        window_(footprint_.covariance),
        grid_(grid),
        cut_(model.image_cut()),
        widening_(model.cell_means() ? mean_widening(grid) : widening_for(grid, model.intrinsic_roughness())) {
    const double variance = model.intrinsic_roughness() * model.intrinsic_roughness();
    roughness_ = {std::sqrt(variance + widening_.x), std::sqrt(variance + widening_.y)};
  }

  /// Squared distance between two boxes of normals, in units of the roughness.
  [[nodiscard]] double squared_gap(const NormalBox& a, const NormalBox& b) const {
    const auto gap = [](double lo, double hi, double other_lo, double other_hi) {
      return std::max({lo - other_hi, other_lo - hi, 0.0});
    };
    const double x = gap(a.lo.x, a.hi.x, b.lo.x, b.hi.x) / roughness_.x;
    const double y = gap(a.lo.y, a.hi.y, b.lo.y, b.hi.y) / roughness_.y;
    return x * x + y * y;
  }

  /// What the cut loses is bounded as a share of the whole mass; the error is relative to what the window holds.
  [[nodiscard]] PndfError cut_error(double held) const {
    const double half = 0.5 * cut_ * cut_;
    return held > 0 ? PndfError{std::exp(-half) * (1 + half) / held, 0} : PndfError{};
  }

  const SurfaceCells& cells_;
  Footprint footprint_;
  FootprintWindow window_;
  PndfGrid grid_;
  double cut_;
  glm::dvec2 widening_;
  glm::dvec2 roughness_{0, 0};  ///< widened
};

}  // namespace glint
