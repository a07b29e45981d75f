// Short triangles that reach many cells: the points of their cubature, each a product of a Gaussian of the column and
// one of the row, so that a cell costs one multiplication and addition a point. Built once for each of Highway's
// targets, inside triangle_splat.cpp and nowhere else.

#if defined(GLINT_SPLAT_POINTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_SPLAT_POINTS_INL_H_
#undef GLINT_SPLAT_POINTS_INL_H_
#else
#define GLINT_SPLAT_POINTS_INL_H_
#endif

#include <array>
#include <cmath>
#include <cstdint>

#include <hwy/highway.h>

#include "core/math/simd_math-inl.h"
#include "core/pndf/splat_setup-inl.h"
#include "core/pndf/splat_triangle.h"

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

// out[i] = factor exp(-((first + i - at) k)^2 / 2), i < count, and some more to fill a vector.
HWY_INLINE void fill_gaussian(float at, float k, float factor, int first, int count, float* out) {
  const Floats d;
  const V scale = hn::Set(d, k * k_unit);
  for (int i = 0; i < count; i += k_lanes) {
    const V x = hn::Mul(scale, hn::Sub(hn::Iota(d, static_cast<float>(first + i)), hn::Set(d, at)));
    hn::StoreU(hn::Mul(hn::Set(d, factor), exp2_of_negative(hn::Neg(hn::Mul(x, x)))), d, out + i);
  }
}

// Adds the triangle within `reach`. Positions and cells count from the origin of the surface cell.
inline void splat_points(const SplatFrame& frame, const SplatCell& cell, const SplatBand& band, const Cubature& rule,
                         const std::array<float, 4>& place, const std::array<float, 3>& x,
                         const std::array<float, 3>& y, const Reach& reach, SplatScratch::Arrays& arrays) {
  const Floats d;
  const auto [ox, oy, du, dv] = place;
  const int rows = reach.last_row - reach.first_row + 1;
  const int columns = reach.last_column - reach.first_column + 1;
  const auto row_stride = static_cast<std::size_t>(rows) + k_lanes;
  const auto column_stride = static_cast<std::size_t>(columns) + std::size_t{2} * k_lanes;
  const auto count = static_cast<std::size_t>(rule.count);
  if (arrays.row_factors.size() < count * row_stride) arrays.row_factors.resize(count * row_stride);
  if (arrays.column_factors.size() < count * column_stride) arrays.column_factors.resize(count * column_stride);
  const float scale = std::abs(du * dv) * frame.scale;
  for (std::size_t k = 0; k < count; ++k) {
    const auto [a, b, weight] = rule.points[k];
    const float u = ox + a * du;
    const float v = oy + b * dv;
    const float wx = k_unit * (frame.w11 * u + frame.w12 * v);
    const float wy = k_unit * frame.w22 * v;
    const float factor = scale * weight * std::exp2(-(wx * wx + wy * wy));
    fill_gaussian(y[0] + a * (y[1] - y[0]) + b * (y[2] - y[0]), frame.ky, factor, reach.first_row, rows,
                  arrays.row_factors.data() + k * row_stride);
    fill_gaussian(x[0] + a * (x[1] - x[0]) + b * (x[2] - x[0]), frame.kx, 1, reach.first_column, columns + k_lanes,
                  arrays.column_factors.data() + k * column_stride);
  }
  for (int row = 0; row < rows; ++row) {
    const auto at = static_cast<std::size_t>(row);
    float* out = band.row(cell.origin_row + reach.first_row + row - band.first_row()) + cell.origin_column;
    for (std::int32_t column = arrays.first[at]; column <= arrays.last[at]; column += k_lanes) {
      const float* of_column = arrays.column_factors.data() + (column - reach.first_column);
      V sum = hn::LoadU(d, out + column);
      for (std::size_t k = 0; k < count; ++k) {
        sum = hn::MulAdd(hn::Set(d, arrays.row_factors[k * row_stride + at]),
                         hn::LoadU(d, of_column + static_cast<std::ptrdiff_t>(k * column_stride)), sum);
      }
      hn::StoreU(sum, d, out + column);
    }
  }
}

}  // namespace
}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
