#include "core/pndf/slope_gaussian.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/pndf/slope_space.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/pndf/slope_gaussian.cpp"
// In this order.
// clang-format off
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include <hwy/contrib/math/math-inl.h>
// clang-format on

#ifndef GLINT_SLOPE_CELLS
#define GLINT_SLOPE_CELLS
namespace glint {

// Cells of a grid, both ends included; none where last < first.
struct SlopeCells {
  int first_column;
  int last_column;
  int first_row;
  int last_row;
};

}  // namespace glint
#endif

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void draw_cells(const SlopeGaussian& gaussian, const PndfGrid& grid, const SlopeCells& cells, double* density) {
  const hn::ScalableTag<double> d;
  using Doubles = hn::Vec<decltype(d)>;
  const auto lanes = static_cast<int>(hn::Lanes(d));
  const Whitening& white = gaussian.whitening();
  const Doubles one = hn::Set(d, 1.0);
  const Doubles w11 = hn::Set(d, white.w11);
  const Doubles w12 = hn::Set(d, white.w12);
  const Doubles w22 = hn::Set(d, white.w22);
  const Doubles mean_x = hn::Set(d, gaussian.mean().x);
  const Doubles mean_y = hn::Set(d, gaussian.mean().y);
  const Doubles peak = hn::Set(d, gaussian.peak());
  const Doubles limit = hn::Set(d, k_slope_cut * k_slope_cut);
  const Doubles pitch = hn::Set(d, grid.pitch().x);
  const Doubles s_min = hn::Set(d, grid.s_min);
  for (int row = cells.first_row; row <= cells.last_row; ++row) {
    const double t = grid.center(0, row).y;
    if (!(t * t < 1)) continue;
    const Doubles minus_t = hn::Set(d, -t);
    const Doubles height = hn::Set(d, 1 - t * t);
    double* out = density + grid.index(0, row);
    for (int column = cells.first_column; column <= cells.last_column; column += lanes) {
      const Doubles s = hn::MulAdd(hn::Iota(d, column + 0.5), pitch, s_min);
      const Doubles squared = hn::NegMulAdd(s, s, height);
      const auto inside = hn::Gt(squared, hn::Zero(d));
      // 1 / z; outside the disk anything finite.
      const Doubles steep = hn::Div(one, hn::Sqrt(hn::IfThenElse(inside, squared, one)));
      const Doubles x = hn::NegMulSub(s, steep, mean_x);
      const Doubles y = hn::MulSub(minus_t, steep, mean_y);
      const Doubles across = hn::MulAdd(w11, x, hn::Mul(w12, y));
      const Doubles down = hn::Mul(w22, y);
      const Doubles form = hn::MulAdd(across, across, hn::Mul(down, down));
      const auto near = hn::And(inside, hn::Lt(form, limit));
      if (hn::AllFalse(d, near)) continue;
      const Doubles squared_steep = hn::Mul(steep, steep);
      const Doubles scale = hn::Mul(peak, hn::Mul(squared_steep, squared_steep));
      const Doubles exponent = hn::Mul(hn::Set(d, -0.5), hn::Min(form, limit));
      const Doubles value = hn::IfThenElseZero(near, hn::Mul(scale, hn::Exp(d, exponent)));
      const int left = cells.last_column - column + 1;
      if (left >= lanes) {
        hn::StoreU(value, d, out + column);
      } else {
        hn::BlendedStore(value, hn::FirstN(d, static_cast<std::size_t>(left)), d, out + column);
      }
    }
  }
}

}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glint {

HWY_EXPORT(draw_cells);

namespace {

struct Range {
  double lo;
  double hi;
};

// The least and the largest of -x / sqrt(1 + x^2 + y^2) over a box: it falls in x, and less steeply the larger |y| is.
Range normals_of(Range x, Range y) {
  const double far = std::max(std::abs(y.lo), std::abs(y.hi));
  const double near = y.lo <= 0 && y.hi >= 0 ? 0 : std::min(std::abs(y.lo), std::abs(y.hi));
  const auto normal = [](double m, double other) { return -m / std::sqrt(1 + m * m + other * other); };
  return {normal(x.hi, x.hi > 0 ? near : far), normal(x.lo, x.lo < 0 ? near : far)};
}

// Cells whose centres lie in a range of positions, counted in cells from the first one's edge; clamped as doubles, for
// they may be anywhere.
Range centers_within(double from, double to, int cells) {
  return {std::clamp(std::ceil(from - 0.5 - 1e-6), 0.0, static_cast<double>(cells)),
          std::clamp(std::floor(to - 0.5 + 1e-6), -1.0, static_cast<double>(cells - 1))};
}

SlopeCells cells_near(const SlopeGaussian& gaussian, const PndfGrid& grid) {
  const glm::dvec2 mean = gaussian.mean();
  const double reach_x = k_slope_cut * std::sqrt(gaussian.covariance().xx);
  const double reach_y = k_slope_cut * std::sqrt(gaussian.covariance().yy);
  const Range x{mean.x - reach_x, mean.x + reach_x};
  const Range y{mean.y - reach_y, mean.y + reach_y};
  const Range s = normals_of(x, y);
  const Range t = normals_of(y, x);
  const glm::dvec2 pitch = grid.pitch();
  const Range columns = centers_within((s.lo - grid.s_min) / pitch.x, (s.hi - grid.s_min) / pitch.x, grid.columns);
  const Range rows = centers_within((grid.t_max - t.hi) / pitch.y, (grid.t_max - t.lo) / pitch.y, grid.rows);
  return {static_cast<int>(columns.lo), static_cast<int>(columns.hi), static_cast<int>(rows.lo),
          static_cast<int>(rows.hi)};
}

}  // namespace

SlopeGaussian::SlopeGaussian(const SlopeMoments& moments, glm::dvec2 base)
    : mean_(moments.mean),
      covariance_{moments.covariance.xx + base.x, moments.covariance.xy, moments.covariance.yy + base.y},
      white_{},
      factor_{},
      peak_(0) {
  const SymmetricMatrix2& c = moments.covariance;
  const double det = std::max(determinant(c), 0.0) + base.x * c.yy + base.y * c.xx + base.x * base.y;
  const double root = std::sqrt(det);
  const double down = std::sqrt(covariance_.yy);
  white_ = {down / root, -covariance_.xy / (down * root), 1 / down};
  const double across = std::sqrt(covariance_.xx);
  factor_ = {across, covariance_.xy / across, root / across};
  peak_ = 1 / (2 * std::numbers::pi * root);
}

double SlopeGaussian::density(glm::dvec2 s) const {
  const double squared = squared_height(s);
  if (!(squared > 0)) return 0;
  const glm::dvec2 w = white_.apply(slope_of_normal(s) - mean_);
  // The exponential vanishes long before z^-4 overflows: |m| grows as 1 / z.
  return peak_ * std::exp(-0.5 * (w.x * w.x + w.y * w.y)) / (squared * squared);
}

glm::dvec2 SlopeGaussian::normal(glm::dvec2 deviate) const {
  return normal_of_slope(mean_ + factor_.apply(deviate));
}

void draw_slope_gaussian(const SlopeGaussian& gaussian, const PndfGrid& grid, int first, int last, double* density) {
  SlopeCells cells = cells_near(gaussian, grid);
  cells.first_row = std::max(cells.first_row, first);
  cells.last_row = std::min(cells.last_row, last);
  HWY_DYNAMIC_DISPATCH(draw_cells)(gaussian, grid, cells, density);
}

}  // namespace glint

#endif  // once
