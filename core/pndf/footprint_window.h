#pragma once
// The part of the plane that a truncated footprint covers, in offsets from its centre.

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/vec2.hpp>

#include "core/math/gaussian.h"
#include "core/pndf/footprint.h"

namespace glint {

struct Interval {
  double lo;
  double hi;
};

/// An axis-aligned box of offsets from the footprint's centre, texels.
struct OffsetBox {
  Interval x;
  Interval y;
};

class FootprintWindow {
 public:
  explicit FootprintWindow(const SymmetricMatrix2& covariance)
      : covariance_(covariance),
        whitening_(glint::whitening(covariance)),
        root_(std::sqrt(determinant(covariance) / covariance.yy)) {}

  [[nodiscard]] const Whitening& whitening() const { return whitening_; }

  /// The offsets |y| reached within `cut` standard deviations.
  [[nodiscard]] double reach_x(double cut) const { return cut * std::sqrt(covariance_.xx); }
  [[nodiscard]] double reach_y(double cut) const { return cut * std::sqrt(covariance_.yy); }

  /// The x offsets of the ellipse |W d| <= cut within a band of y offsets; nothing if it does not meet the band.
  [[nodiscard]] std::optional<Interval> columns(Interval y, double cut) const {
    const double top = reach_y(cut);
    const Interval band{std::max(y.lo, -top), std::min(y.hi, top)};
    if (!(band.lo <= band.hi)) return std::nullopt;
    const auto half_width = [&](double at) {
      return root_ * std::sqrt(std::max(0.0, cut * cut - at * at / covariance_.yy));
    };
    const double shear = covariance_.xy / covariance_.yy;
    // The ellipse is widest to the right at y = +extreme and to the left at y = -extreme.
    const double extreme = cut * covariance_.xy / std::sqrt(covariance_.xx);
    const double right = std::clamp(extreme, band.lo, band.hi);
    const double left = std::clamp(-extreme, band.lo, band.hi);
    return Interval{shear * left - half_width(left), shear * right + half_width(right)};
  }

  /// The smallest squared distance, in standard deviations, from the centre to a box: 0 if the centre is inside.
  [[nodiscard]] double squared_distance(const OffsetBox& box) const {
    if (box.x.lo <= 0 && box.x.hi >= 0 && box.y.lo <= 0 && box.y.hi >= 0) return 0;
    // On an edge x = const the form is smallest at y = x xy / xx, brought into the edge; likewise for y = const.
    const double slope_y = covariance_.xy / covariance_.xx;
    const double slope_x = covariance_.xy / covariance_.yy;
    double least = form({box.x.lo, std::clamp(slope_y * box.x.lo, box.y.lo, box.y.hi)});
    least = std::min(least, form({box.x.hi, std::clamp(slope_y * box.x.hi, box.y.lo, box.y.hi)}));
    least = std::min(least, form({std::clamp(slope_x * box.y.lo, box.x.lo, box.x.hi), box.y.lo}));
    return std::min(least, form({std::clamp(slope_x * box.y.hi, box.x.lo, box.x.hi), box.y.hi}));
  }

 private:
  [[nodiscard]] double form(glm::dvec2 d) const {
    const glm::dvec2 w = whitening_.apply(d);
    return w.x * w.x + w.y * w.y;
  }

  SymmetricMatrix2 covariance_;
  Whitening whitening_;
  double root_;
};

/// False for a footprint so long and so far from the axes that whitening its offsets in single precision loses more
/// than some 5e-5 deviations.
inline bool suits_single_precision(const FootprintWindow& window, double cut) {
  constexpr double k_most = 400;  // deviations that cancel
  return std::abs(window.whitening().w12) * window.reach_y(cut) <= k_most;
}

}  // namespace glint
