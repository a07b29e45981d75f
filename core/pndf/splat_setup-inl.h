// Of one triangle: its whitened form, its rays, and the cells of the image in its reach. Built once for each of
// Highway's targets, inside triangle_splat.cpp and nowhere else.

#if defined(GLINT_SPLAT_SETUP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_SPLAT_SETUP_INL_H_
#undef GLINT_SPLAT_SETUP_INL_H_
#else
#define GLINT_SPLAT_SETUP_INL_H_
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <hwy/highway.h>

#include "core/math/simd_math-inl.h"
#include "core/pndf/splat_triangle.h"

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

// The QR factorisation, shared by all cells. x, y: of the right angle and of the ends of the legs du and dv, in cells
// of the image; (ox, oy) is the right angle's offset.
inline SplatTriangle factorise(const SplatFrame& frame, float ox, float oy, float du, float dv,
                               const std::array<float, 3>& x, const std::array<float, 3>& y) {
  using Column = std::array<double, 4>;
  const auto dot = [](const Column& a, const Column& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  };
  const double w11 = frame.w11;
  const double w12 = frame.w12;
  const double w22 = frame.w22;
  const double kx = frame.kx;
  const double ky = frame.ky;
  const auto change = [&](std::size_t vertex) {
    return std::array<double, 2>{(static_cast<double>(x[vertex]) - x[0]) * kx,
                                 (static_cast<double>(y[vertex]) - y[0]) * ky};
  };
  Column q{w11 * du, 0, change(1)[0], change(1)[1]};
  Column p{w12 * dv, w22 * dv, change(2)[0], change(2)[1]};
  const double r11 = std::sqrt(dot(q, q));
  for (double& entry : q) entry /= r11;
  const double r12 = dot(q, p);
  for (std::size_t k = 0; k < 4; ++k) p[k] -= r12 * q[k];
  const double r22 = std::sqrt(dot(p, p));
  for (double& entry : p) entry /= r22;

  // Of the right angle relative to a cell: the constant part, and what changes with the cell.
  const Column f{w11 * ox + w12 * oy, w22 * oy, x[0] * kx, y[0] * ky};
  const double wx0 = dot(q, f);
  const double wy0 = dot(p, f);
  // The residual is affine in the cell.
  Column r{};
  Column gx{};
  Column gy{};
  for (std::size_t k = 0; k < 4; ++k) {
    r[k] = f[k] - q[k] * wx0 - p[k] * wy0;
    gx[k] = kx * (q[k] * q[2] + p[k] * p[2]) - (k == 2 ? kx : 0);
    gy[k] = ky * (q[k] * q[3] + p[k] * p[3]) - (k == 3 ? ky : 0);
  }
  // In two coordinates, for no more is left of a plane in 4D: along the larger of its changes, and across it along the
  // other or, where that adds nothing, along r.
  const auto unit_of = [&](Column along) {
    const double length = std::sqrt(dot(along, along));
    for (double& entry : along) entry = length > 0 ? entry / length : 0;
    return along;
  };
  const auto across = [&](const Column& first, Column from) {
    const double share = dot(first, from);
    for (std::size_t k = 0; k < 4; ++k) from[k] -= share * first[k];
    return from;
  };
  const bool x_leads = dot(gx, gx) >= dot(gy, gy);
  const Column& larger = x_leads ? gx : gy;
  constexpr double k_nothing = 1e-18;  // squared: rounding
  const double whole = kx * kx + ky * ky;
  const Column first = unit_of(dot(larger, larger) > k_nothing * whole ? larger : r);
  const Column other = across(first, x_leads ? gy : gx);
  const Column second = unit_of(dot(other, other) > k_nothing * whole ? other : across(first, r));
  const double unit = k_unit;
  const auto narrow = [](double value) { return static_cast<float>(value); };
  SplatTriangle t{};
  t.r11 = narrow(r11);
  t.r12 = narrow(r12);
  t.r22 = narrow(r22);
  t.wx0 = narrow(wx0);
  t.wxx = narrow(-kx * q[2]);
  t.wxy = narrow(-ky * q[3]);
  t.wy0 = narrow(wy0);
  t.wyx = narrow(-kx * p[2]);
  t.wyy = narrow(-ky * p[3]);
  t.u0 = narrow(unit * dot(first, r));
  t.ux = narrow(unit * dot(first, gx));
  t.uy = narrow(unit * dot(first, gy));
  t.v0 = narrow(unit * dot(second, r));
  t.vx = narrow(unit * dot(second, gx));
  t.vy = narrow(unit * dot(second, gy));
  t.factor = std::abs(du * dv) * frame.scale;
  return t;
}

// Rays from the vertex opposite the shortest edge; the apex is (x0 + wxx x + wxy y, …) for each cell.
struct Rays {
  int count;
  float apex_x;
  float apex_y;
};

inline Rays make_rays(const SplatTriangle& t, const SplatEdges& edges, SplatScratch::Arrays& out) {
  const Floats d;
  float ax = 0;
  float ay = 0;
  float bx = 0;
  float by = 0;
  Rays rays{0, t.wx0, t.wy0};
  float squared = 0;
  if (edges.between <= edges.to_du && edges.between <= edges.to_dv) {
    squared = edges.between;
    ax = t.r11;
    bx = t.r12;
    by = t.r22;
  } else if (edges.to_dv <= edges.to_du) {
    squared = edges.to_dv;
    ax = -t.r11;
    bx = t.r12 - t.r11;
    by = t.r22;
    rays.apex_x += t.r11;
  } else {
    squared = edges.to_du;
    ax = -t.r12;
    ay = -t.r22;
    bx = t.r11 - t.r12;
    by = -t.r22;
    rays.apex_x += t.r12;
    rays.apex_y += t.r22;
  }
  const float shortest = std::sqrt(squared);
  const float wanted = k_nodes_per_deviation * shortest;
  const int panels = static_cast<int>(wanted / (k_most_panel_nodes - 3)) + 1;
  const int nodes = static_cast<int>(std::ceil(wanted / static_cast<float>(panels) + 2));
  const RayRules::Rule& rule = ray_rules().rules[static_cast<std::size_t>(nodes)];
  const V unit = hn::Set(d, k_unit);
  for (int panel = 0; panel < panels; ++panel) {
    for (int k = 0; k < nodes; k += k_lanes) {
      const V z = hn::Mul(hn::Add(hn::LoadU(d, rule.nodes.data() + k), hn::Set(d, static_cast<float>(panel))),
                          hn::Set(d, 1 / static_cast<float>(panels)));
      const V dx = hn::MulAdd(z, hn::Set(d, bx - ax), hn::Set(d, ax));
      const V dy = hn::MulAdd(z, hn::Set(d, by - ay), hn::Set(d, ay));
      const V length = hn::Sqrt(hn::MulAdd(dx, dx, hn::Mul(dy, dy)));
      const V inverse = hn::Div(hn::Set(d, 1), length);
      const V ux = hn::Mul(hn::Mul(dx, inverse), unit);
      const V uy = hn::Mul(hn::Mul(dy, inverse), unit);
      const auto along = [&](float vx, float vy)
                             HWY_ATTR { return hn::MulAdd(hn::Set(d, vx), ux, hn::Mul(hn::Set(d, vy), uy)); };
      const auto beside = [&](float vx, float vy)
                              HWY_ATTR { return hn::MulSub(hn::Set(d, vx), uy, hn::Mul(hn::Set(d, vy), ux)); };
      const std::size_t at = static_cast<std::size_t>(rays.count) + static_cast<std::size_t>(k);
      hn::StoreU(along(rays.apex_x, rays.apex_y), d, out.b0.data() + at);
      hn::StoreU(along(t.wxx, t.wyx), d, out.bx.data() + at);
      hn::StoreU(along(t.wxy, t.wyy), d, out.by.data() + at);
      hn::StoreU(beside(rays.apex_x, rays.apex_y), d, out.p0.data() + at);
      hn::StoreU(beside(t.wxx, t.wyx), d, out.px.data() + at);
      hn::StoreU(beside(t.wxy, t.wyy), d, out.py.data() + at);
      hn::StoreU(hn::Mul(length, unit), d, out.length.data() + at);
      const V weight =
          hn::Mul(hn::LoadU(d, rule.weights.data() + k), hn::Set(d, t.factor / static_cast<float>(panels)));
      hn::StoreU(hn::Mul(weight, hn::Mul(inverse, inverse)), d, out.weight.data() + at);
    }
    rays.count += nodes;
  }
  // What fills the last vector is out of every cell's reach.
  for (int k = rays.count; k % k_lanes != 0; ++k) {
    const auto at = static_cast<std::size_t>(k);
    out.p0[at] = 1e9F;
    out.px[at] = out.py[at] = 0;
  }
  return rays;
}

// Rows [first_row, last_row] of the band, for each the columns within `reach` deviations of the triangle (in the
// scratch arrays), and the range of them all.
struct Reach {
  int first_row;
  int last_row;
  int first_column;
  int last_column;
};

inline Reach find_reach(const SplatFrame& frame, const SplatCell& cell, const SplatBand& band, float reach,
                        const std::array<float, 3>& x, const std::array<float, 3>& y, SplatScratch::Arrays& out) {
  const Floats d;
  const hn::RebindToSigned<Floats> di;
  const auto [lowest, highest] = std::minmax({y[0], y[1], y[2]});
  const float rows = reach / frame.ky;
  const auto in_band = [&](float row) {
    return std::clamp(row, static_cast<float>(band.first_row() - cell.origin_row) - 1,
                      static_cast<float>(band.first_row() + band.rows() - cell.origin_row));
  };
  const int first = std::max(static_cast<int>(std::ceil(in_band(lowest - rows))), band.first_row() - cell.origin_row);
  const int last = std::min(static_cast<int>(std::floor(in_band(highest + rows))),
                            band.first_row() + band.rows() - 1 - cell.origin_row);
  Reach found{first, last, frame.columns, -frame.columns};
  if (first > last) return found;

  const V inverse_kx = hn::Set(d, 1 / frame.kx);
  const V least = hn::Set(d, static_cast<float>(-cell.origin_column));
  const V most = hn::Set(d, static_cast<float>(frame.columns - 1 - cell.origin_column));
  const V squared_reach = hn::Set(d, reach * reach);
  const V zero = hn::Zero(d);
  for (int row = first; row <= last; row += k_lanes) {
    const V at = hn::Mul(hn::Iota(d, static_cast<float>(row)), hn::Set(d, frame.ky));
    V lo = hn::Set(d, 1e9F);
    V hi = hn::Set(d, -1e9F);
    for (std::size_t v = 0; v < 3; ++v) {
      const float vx = x[v] * frame.kx;
      const float vy = y[v] * frame.ky;
      const V off = hn::Sub(at, hn::Set(d, vy));
      const V room = hn::NegMulAdd(off, off, squared_reach);
      const auto meets = hn::Ge(room, zero);
      const V half = hn::Sqrt(hn::Max(room, zero));
      lo = hn::IfThenElse(meets, hn::Min(lo, hn::Sub(hn::Set(d, vx), half)), lo);
      hi = hn::IfThenElse(meets, hn::Max(hi, hn::Add(hn::Set(d, vx), half)), hi);
      // The edge to the next vertex, moved outwards by the reach.
      const std::size_t next = v == 2 ? 0 : v + 1;
      const float ex = x[next] * frame.kx - vx;
      const float ey = y[next] * frame.ky - vy;
      const float length = std::sqrt(ex * ex + ey * ey);
      if (!(std::abs(ey) > 1e-6F * length)) continue;  // level: the vertices reach as far
      const float out_x = reach * std::abs(ey) / length;
      const float out_y = reach * (ey > 0 ? -ex : ex) / length;
      const V slope = hn::Set(d, ex / ey);
      const auto side = [&](float sign, auto combine, V bound) HWY_ATTR {
        const V along = hn::Sub(off, hn::Set(d, sign * out_y));
        const auto inside =
            hn::And(hn::Ge(along, hn::Set(d, std::min(0.0F, ey))), hn::Le(along, hn::Set(d, std::max(0.0F, ey))));
        const V edge = hn::MulAdd(along, slope, hn::Set(d, vx + sign * out_x));
        return hn::IfThenElse(inside, combine(bound, edge), bound);
      };
      lo = side(
          -1, [](V a, V b) HWY_ATTR { return hn::Min(a, b); }, lo);
      hi = side(
          1, [](V a, V b) HWY_ATTR { return hn::Max(a, b); }, hi);
    }
    const auto index = static_cast<std::size_t>(row - first);
    const V first_column = hn::Max(hn::Ceil(hn::Mul(hn::Min(lo, hn::Set(d, 1e8F)), inverse_kx)), least);
    const V last_column = hn::Min(hn::Floor(hn::Mul(hn::Max(hi, hn::Set(d, -1e8F)), inverse_kx)), most);
    hn::StoreU(hn::ConvertTo(di, hn::Min(first_column, hn::Add(most, hn::Set(d, 1)))), di, out.first.data() + index);
    hn::StoreU(hn::ConvertTo(di, hn::Max(last_column, hn::Sub(least, hn::Set(d, 1)))), di, out.last.data() + index);
  }
  for (int row = first; row <= last; ++row) {
    const auto index = static_cast<std::size_t>(row - first);
    if (out.first[index] > out.last[index]) continue;
    found.first_column = std::min<int>(found.first_column, out.first[index]);
    found.last_column = std::max<int>(found.last_column, out.last[index]);
  }
  return found;
}

}  // namespace
}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
