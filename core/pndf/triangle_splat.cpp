// Splatting one triangle: a QR factorisation shared by all cells, then for tiles of cells either a symmetric cubature
// (short triangles; where they reach many cells, point by point) or rays from the vertex opposite the shortest whitened
// edge to Gauss points of that edge, each integrated in closed form. With V the apex relative to a cell, d a ray, b =
// V.d/|d|, c = b + |d| and p the distance of the ray's line:
//   integral over z in [0, 1] of z exp(-|V + z d|^2 / 2)
//     = exp(-p^2 / 2) / |d|^2 (exp(-b^2 / 2) - exp(-c^2 / 2) - b sqrt(2 pi) (Phi(c) - Phi(b))).

#include "core/pndf/triangle_splat.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/pndf/splat_triangle.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/pndf/triangle_splat.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/math/simd_math-inl.h"
#include "core/pndf/ray_integral-inl.h"
#include "core/pndf/splat_points-inl.h"
#include "core/pndf/splat_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

constexpr int k_tile_width = k_lanes < 4 ? k_lanes : 4;
constexpr int k_tile_height = k_lanes / k_tile_width;

// Adds a tile to the image's rows.
HWY_INLINE void add_tile(V values, float* out, std::ptrdiff_t stride, int rows) {
  const Floats d;
  const hn::CappedTag<float, k_tile_width> row_tag;
  alignas(64) std::array<float, static_cast<std::size_t>(k_lanes)> lanes;
  hn::Store(values, d, lanes.data());
  for (int row = 0; row < rows; ++row) {
    float* at = out + row * stride;
    const auto added = hn::Load(row_tag, lanes.data() + static_cast<std::ptrdiff_t>(row) * k_tile_width);
    hn::StoreU(hn::Add(hn::LoadU(row_tag, at), added), row_tag, at);
  }
}

class TriangleSplat {
 public:
  TriangleSplat(const SplatFrame& frame, const SplatCell& cell, const SplatBand& band, SplatScratch::Arrays& arrays)
      : frame_(frame), cell_(cell), band_(band), arrays_(arrays) {
    for (int k = 0; k < k_lanes; ++k) {
      const int row = k / k_tile_width;
      lane_x_[static_cast<std::size_t>(k)] = static_cast<float>(k % k_tile_width);
      lane_y_[static_cast<std::size_t>(k)] = static_cast<float>(row);
    }
  }

  // False where single precision does not do.
  bool add(float ox, float oy, float du, float dv, const std::array<float, 3>& x, const std::array<float, 3>& y,
           float room) {
    const Reach reach = find_reach(frame_, cell_, band_, std::sqrt(room), x, y, arrays_);
    if (reach.first_row > reach.last_row || reach.first_column > reach.last_column) return true;
    // Counted from a cell near this triangle, for what is far away cancels.
    origin_column_ = static_cast<int>(std::clamp(x[0], static_cast<float>(-cell_.origin_column),
                                                 static_cast<float>(frame_.columns - 1 - cell_.origin_column)));
    origin_row_ =
        static_cast<int>(std::clamp(y[0], static_cast<float>(reach.first_row), static_cast<float>(reach.last_row)));
    const auto from_origin = [](const std::array<float, 3>& from, int origin) {
      const auto by = static_cast<float>(origin);
      return std::array<float, 3>{from[0] - by, from[1] - by, from[2] - by};
    };
    const SplatTriangle t =
        factorise(frame_, ox, oy, du, dv, from_origin(x, origin_column_), from_origin(y, origin_row_));
    const SplatEdges edges = edges_of(t);
    const float longest = std::max({edges.to_du, edges.to_dv, edges.between});
    if (!(longest < k_longest_edge * k_longest_edge) ||
        std::min({edges.to_du, edges.to_dv, edges.between}) > k_longest_splat_edge * k_longest_splat_edge) {
      return false;
    }
    const Cubature* rule = cubature_for(longest);
    if (rule != nullptr && reach.last_column - reach.first_column + 1 >= k_lanes) {
      splat_points(frame_, cell_, band_, *rule, {ox, oy, du, dv}, x, y, reach, arrays_);
    } else if (rule != nullptr) {
      for_tiles(t, reach, [&](V x_at, V y_at, V residual, float, float, float, float) HWY_ATTR {
        return cubature(t, *rule, x_at, y_at, residual);
      });
    } else {
      const Rays rays = make_rays(t, edges, arrays_);
      for_tiles(t, reach, [&](V x_at, V y_at, V residual, float xc, float yc, float half_x, float half_y) HWY_ATTR {
        return sum_rays(t, rays, x_at, y_at, residual, {xc, yc, half_x, half_y});
      });
    }
    return true;
  }

 private:
  struct TileBox {
    float x, y, half_x, half_y;
  };

  template <class Body>
  HWY_INLINE void for_tiles(const SplatTriangle& t, const Reach& reach, Body body) {
    const Floats d;
    const V lane_x = hn::LoadU(d, lane_x_.data());
    const V lane_y = hn::LoadU(d, lane_y_.data());
    const std::ptrdiff_t stride = SplatBand::stride_for(frame_.columns);
    const int rows = reach.last_row - reach.first_row + 1;
    for (int row = 0; row < rows; row += k_tile_height) {
      const int height = std::min(k_tile_height, rows - row);
      const auto at = static_cast<std::size_t>(row);
      std::int32_t first = arrays_.first[at];
      std::int32_t last = arrays_.last[at];
      for (std::size_t k = 1; k < static_cast<std::size_t>(height); ++k) {
        first = std::min(first, arrays_.first[at + k]);
        last = std::max(last, arrays_.last[at + k]);
      }
      if (first > last) continue;
      const auto top = static_cast<float>(reach.first_row + row - origin_row_);
      const V y = hn::Add(lane_y, hn::Set(d, top));
      const V row_u = hn::MulAdd(y, hn::Set(d, t.uy), hn::Set(d, t.u0));
      const V row_v = hn::MulAdd(y, hn::Set(d, t.vy), hn::Set(d, t.v0));
      // Of the whole tile, for its columns beyond the last are added too.
      const float half_x = 0.5F * static_cast<float>(k_tile_width - 1);
      const float half_y = 0.5F * static_cast<float>(k_tile_height - 1);
      float* out = band_.row(cell_.origin_row + reach.first_row + row - band_.first_row()) + cell_.origin_column;
      for (std::int32_t column = first; column <= last; column += k_tile_width) {
        const auto left = static_cast<float>(column - origin_column_);
        const V x = hn::Add(lane_x, hn::Set(d, left));
        const V u = hn::MulAdd(x, hn::Set(d, t.ux), row_u);
        const V v = hn::MulAdd(x, hn::Set(d, t.vx), row_v);
        const V residual = hn::NegMulAdd(u, u, hn::Neg(hn::Mul(v, v)));
        const V sum = body(x, y, residual, left + half_x, top + half_y, half_x, half_y);
        add_tile(sum, out + column, stride, height);
      }
    }
  }

  // k_unit (at + along_x x + along_y y)
  static HWY_INLINE V in_units(float at, float along_x, float along_y, V x, V y) {
    const Floats d;
    const V sum = hn::MulAdd(x, hn::Set(d, along_x), hn::MulAdd(y, hn::Set(d, along_y), hn::Set(d, at)));
    return hn::Mul(hn::Set(d, k_unit), sum);
  }

  HWY_INLINE V cubature(const SplatTriangle& t, const Cubature& rule, V x, V y, V residual) const {
    const Floats d;
    const V corner_x = in_units(t.wx0, t.wxx, t.wxy, x, y);
    const V corner_y = in_units(t.wy0, t.wyx, t.wyy, x, y);
    V sum = hn::Zero(d);
    for (int k = 0; k < rule.count; ++k) {
      const auto& [a, b, weight] = rule.points[static_cast<std::size_t>(k)];
      const V px = hn::Add(corner_x, hn::Set(d, k_unit * (a * t.r11 + b * t.r12)));
      const V py = hn::Add(corner_y, hn::Set(d, k_unit * b * t.r22));
      const V exponent = hn::NegMulAdd(px, px, hn::NegMulAdd(py, py, residual));
      sum = hn::MulAdd(hn::Set(d, weight), exp2_of_negative(exponent), sum);
    }
    return hn::Mul(sum, hn::Set(d, t.factor));
  }

  // The rays from `first` on that matter for a tile, by what of them is beyond the cut for all of its cells.
  struct RayMasks {
    std::uint32_t near_both_ends;
    std::uint32_t far_start;  // the apex is too far away to matter
    std::uint32_t far_end;
    std::uint32_t far_both;
  };

  HWY_INLINE V sum_rays(const SplatTriangle& t, const Rays& rays, V x, V y, V residual, const TileBox& tile) const {
    const Floats d;
    const V apex_x = in_units(rays.apex_x, t.wxx, t.wxy, x, y);
    const V apex_y = in_units(rays.apex_y, t.wyx, t.wyy, x, y);
    const V at_apex = exp2_of_negative(hn::NegMulAdd(apex_x, apex_x, hn::NegMulAdd(apex_y, apex_y, residual)));
    V sum = hn::Zero(d);
    for (int first = 0; first < rays.count; first += k_lanes) {
      const RayMasks masks = classify(first, tile);
      const auto add = [&](std::uint32_t active, auto body) HWY_ATTR {
        while (active != 0) {
          const std::size_t k = static_cast<std::size_t>(first) + static_cast<std::size_t>(__builtin_ctz(active));
          active &= active - 1;
          sum = hn::Add(sum, body(k));
        }
      };
      add(masks.near_both_ends, [&](std::size_t k) HWY_ATTR { return ray<true, true>(k, x, y, residual, at_apex); });
      add(masks.far_start, [&](std::size_t k) HWY_ATTR { return ray<false, true>(k, x, y, residual, at_apex); });
      add(masks.far_end, [&](std::size_t k) HWY_ATTR { return ray<true, false>(k, x, y, residual, at_apex); });
      add(masks.far_both, [&](std::size_t k) HWY_ATTR { return ray<false, false>(k, x, y, residual, at_apex); });
    }
    return sum;
  }

  HWY_INLINE RayMasks classify(int first, const TileBox& tile) const {
    const Floats d;
    const auto at = static_cast<std::size_t>(first);
    const V half_x = hn::Set(d, tile.half_x);
    const V half_y = hn::Set(d, tile.half_y);
    const V cut = hn::Set(d, frame_.cut * k_unit);
    const auto middle = [&](const auto& c0, const auto& cx, const auto& cy) HWY_ATTR {
      return hn::MulAdd(hn::LoadU(d, cx.data() + at), hn::Set(d, tile.x),
                        hn::MulAdd(hn::LoadU(d, cy.data() + at), hn::Set(d, tile.y), hn::LoadU(d, c0.data() + at)));
    };
    const auto spread = [&](const auto& cx, const auto& cy) HWY_ATTR {
      return hn::MulAdd(hn::Abs(hn::LoadU(d, cx.data() + at)), half_x,
                        hn::Mul(hn::Abs(hn::LoadU(d, cy.data() + at)), half_y));
    };
    const V p = hn::Sub(hn::Abs(middle(arrays_.p0, arrays_.px, arrays_.py)), spread(arrays_.px, arrays_.py));
    const V start = middle(arrays_.b0, arrays_.bx, arrays_.by);
    const V end = hn::Add(start, hn::LoadU(d, arrays_.length.data() + at));
    const V along = spread(arrays_.bx, arrays_.by);
    const std::uint32_t near = mask_bits(hn::And(
        hn::Lt(p, cut), hn::And(hn::Lt(hn::Sub(start, along), cut), hn::Lt(hn::Neg(cut), hn::Add(end, along)))));
    const std::uint32_t far_start = mask_bits(hn::Lt(hn::Add(start, along), hn::Neg(cut)));
    const std::uint32_t far_end = mask_bits(hn::Lt(cut, hn::Sub(end, along)));
    return {near & ~far_start & ~far_end, near & far_start & ~far_end, near & ~far_start & far_end,
            near & far_start & far_end};
  }

  template <bool near_start, bool near_end>
  HWY_INLINE V ray(std::size_t k, V x, V y, V residual, V at_apex) const {
    const Floats d;
    const auto affine = [&](const auto& c0, const auto& cx, const auto& cy) HWY_ATTR {
      return hn::MulAdd(hn::Set(d, cx[k]), x, hn::MulAdd(hn::Set(d, cy[k]), y, hn::Set(d, c0[k])));
    };
    const V p = affine(arrays_.p0, arrays_.px, arrays_.py);
    const V b = affine(arrays_.b0, arrays_.bx, arrays_.by);
    const V exponent = hn::NegMulAdd(p, p, residual);
    const V weight = hn::Set(d, arrays_.weight[k]);
    const V on_line = exp2_of_negative(exponent);
    const V c = hn::Add(b, hn::Set(d, arrays_.length[k]));
    const V at_end = near_end ? exp2_of_negative(hn::NegMulAdd(c, c, exponent)) : hn::Zero(d);
    return hn::Mul(weight, ray_integral<near_start, near_end>(b, c, on_line, at_apex, at_end));
  }

  const SplatFrame& frame_;
  const SplatCell& cell_;
  const SplatBand& band_;
  SplatScratch::Arrays& arrays_;
  int origin_column_ = 0;
  int origin_row_ = 0;
  std::array<float, static_cast<std::size_t>(k_lanes)> lane_x_{};
  std::array<float, static_cast<std::size_t>(k_lanes)> lane_y_{};
};

}  // namespace

void splat_cell(const SplatFrame& frame, const SplatCell& cell, const SplatBand& band, SplatScratch& scratch,
                std::vector<RefusedTriangle>& refused) {
  TriangleSplat splat(frame, cell, band, scratch.arrays());
  const float cut = frame.cut * frame.cut;
  const std::ptrdiff_t stride = cell.columns + 1;
  const auto squared_distance = [&](float left, float top) {
    // From the centre to the sub-cell, at least: by the box of the whitened sub-cell.
    const float y0 = frame.w22 * top;
    const float y1 = frame.w22 * (top + cell.height);
    const float lean0 = frame.w12 * top;
    const float lean1 = frame.w12 * (top + cell.height);
    const float x0 = frame.w11 * left + std::min(lean0, lean1);
    const float x1 = frame.w11 * (left + cell.width) + std::max(lean0, lean1);
    const float dx = std::max({0.0F, x0, -x1});
    const float dy = std::max({0.0F, y0, -y1});
    return dx * dx + dy * dy;
  };
  for (int row = 0; row < cell.rows; ++row) {
    for (int column = 0; column < cell.columns; ++column) {
      const float left = cell.left + static_cast<float>(column) * cell.width;
      const float top = cell.top + static_cast<float>(row) * cell.height;
      const float room = cut - squared_distance(left, top);
      if (room <= 0) continue;
      const std::ptrdiff_t k = row * stride + column;
      const float* x = cell.x + k;
      const float* y = cell.y + k;
      if (!splat.add(left, top, cell.width, cell.height, {x[0], x[1], x[stride]}, {y[0], y[1], y[stride]}, room)) {
        refused.push_back({column, row, 0});
      }
      if (!splat.add(left + cell.width, top + cell.height, -cell.width, -cell.height, {x[stride + 1], x[stride], x[1]},
                     {y[stride + 1], y[stride], y[1]}, room)) {
        refused.push_back({column, row, 1});
      }
    }
  }
}

}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glint {

HWY_EXPORT(splat_cell);

SplatScratch::SplatScratch() : arrays_(std::make_unique<Arrays>()) {}
SplatScratch::~SplatScratch() = default;

void splat(const SplatFrame& frame, const SplatCell& cell, const SplatBand& band, SplatScratch& scratch,
           std::vector<RefusedTriangle>& refused) {
  const auto rows = static_cast<std::size_t>(band.rows()) + 16;
  if (scratch.arrays().first.size() < rows) {
    scratch.arrays().first.resize(rows);
    scratch.arrays().last.resize(rows);
  }
  HWY_DYNAMIC_DISPATCH(splat_cell)(frame, cell, band, scratch, refused);
}

}  // namespace glint

#endif  // once
