// The triangles that a query found, a vector at a time: QR whitening, then cubature or rays as in triangle_splat.cpp.
// Built once for each of Highway's targets, inside exact_query.cpp and nowhere else.

#if defined(GLINT_QUERY_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_QUERY_TRIANGLES_INL_H_
#undef GLINT_QUERY_TRIANGLES_INL_H_
#else
#define GLINT_QUERY_TRIANGLES_INL_H_
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include <hwy/highway.h>

#include "core/math/simd_math-inl.h"
#include "core/pndf/query_leaf.h"
#include "core/pndf/triangle_rules.h"

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

// A vector of triangles: offsets of the right angles, signed legs, normals at the right angle and at the ends of the
// legs relative to the query.
struct TriangleLanes {
  V ox, oy, leg;
  std::array<V, 3> x;
  std::array<V, 3> y;
};

HWY_INLINE TriangleLanes load_triangles(const QueryScratch::Arrays& arrays, std::size_t first, int count,
                                        const QueryNormal& query) {
  const Floats d;
  struct alignas(64) Columns {
    std::array<float, static_cast<std::size_t>(k_lanes)> values;
  };
  std::array<Columns, 9> columns;
  for (int lane = 0; lane < k_lanes; ++lane) {
    const auto id =
        static_cast<std::uint32_t>(arrays.triangles[first + static_cast<std::size_t>(std::min(lane, count - 1))]);
    const QueryLeaf& leaf = arrays.leaves[id / 32];
    const std::size_t cell = id % 16;
    const bool lower = id % 32 >= 16;
    const std::size_t column = cell % 4 + (lower ? 1 : 0);
    const std::size_t row = cell / 4 + (lower ? 1 : 0);
    const auto at = static_cast<std::size_t>(lane);
    columns[0].values[at] = leaf.left + static_cast<float>(column) * leaf.size;
    columns[1].values[at] = leaf.top + static_cast<float>(row) * leaf.size;
    columns[2].values[at] = lower ? -leaf.size : leaf.size;
    columns[3].values[at] = lower ? leaf.x1[cell + 4] : leaf.x0[cell];
    columns[4].values[at] = lower ? leaf.y1[cell + 4] : leaf.y0[cell];
    columns[5].values[at] = lower ? leaf.x0[cell + 4] : leaf.x1[cell];
    columns[6].values[at] = lower ? leaf.y0[cell + 4] : leaf.y1[cell];
    columns[7].values[at] = lower ? leaf.x1[cell] : leaf.x0[cell + 4];
    columns[8].values[at] = lower ? leaf.y1[cell] : leaf.y0[cell + 4];
  }
  const auto load = [&](std::size_t k) HWY_ATTR { return hn::Load(d, columns[k].values.data()); };
  const auto relative = [&](std::size_t k, std::size_t axis) HWY_ATTR {
    return hn::Sub(hn::Sub(load(k), hn::Set(d, query.high[axis])), hn::Set(d, query.low[axis]));
  };
  return {load(0),
          load(1),
          load(2),
          {relative(3, 0), relative(5, 0), relative(7, 0)},
          {relative(4, 1), relative(6, 1), relative(8, 1)}};
}

// Whitened, as SplatTriangle, at the query.
struct WhiteLanes {
  V r11, r12, r22;
  V wx, wy;    // the right angle
  V residual;  // log2 of its factor
};

HWY_INLINE V dot2(V a, V b, V c, V e) {
  return hn::MulAdd(a, b, hn::Mul(c, e));
}

HWY_INLINE WhiteLanes whiten(const QueryFrame& frame, const TriangleLanes& t) {
  const Floats d;
  const V w11 = hn::Set(d, frame.w11);
  const V w12 = hn::Set(d, frame.w12);
  const V w22 = hn::Set(d, frame.w22);
  const V k = hn::Set(d, frame.inverse_roughness);
  const V a0 = hn::Mul(w11, t.leg);
  const V a2 = hn::Mul(hn::Sub(t.x[1], t.x[0]), k);
  const V a3 = hn::Mul(hn::Sub(t.y[1], t.y[0]), k);
  const V b0 = hn::Mul(w12, t.leg);
  const V b1 = hn::Mul(w22, t.leg);
  const V b2 = hn::Mul(hn::Sub(t.x[2], t.x[0]), k);
  const V b3 = hn::Mul(hn::Sub(t.y[2], t.y[0]), k);
  WhiteLanes out;
  out.r11 = hn::Sqrt(hn::MulAdd(a0, a0, dot2(a2, a2, a3, a3)));
  const V i1 = hn::Div(hn::Set(d, 1), out.r11);
  const V q0 = hn::Mul(a0, i1);
  const V q2 = hn::Mul(a2, i1);
  const V q3 = hn::Mul(a3, i1);
  out.r12 = hn::MulAdd(q0, b0, dot2(q2, b2, q3, b3));
  V p0 = hn::NegMulAdd(out.r12, q0, b0);
  V p1 = b1;
  V p2 = hn::NegMulAdd(out.r12, q2, b2);
  V p3 = hn::NegMulAdd(out.r12, q3, b3);
  const V again = hn::MulAdd(q0, p0, dot2(q2, p2, q3, p3));
  p0 = hn::NegMulAdd(again, q0, p0);
  p2 = hn::NegMulAdd(again, q2, p2);
  p3 = hn::NegMulAdd(again, q3, p3);
  out.r12 = hn::Add(out.r12, again);
  out.r22 = hn::Sqrt(hn::MulAdd(p0, p0, hn::MulAdd(p1, p1, dot2(p2, p2, p3, p3))));
  const V i2 = hn::Div(hn::Set(d, 1), out.r22);
  p0 = hn::Mul(p0, i2);
  p1 = hn::Mul(p1, i2);
  p2 = hn::Mul(p2, i2);
  p3 = hn::Mul(p3, i2);
  const V f0 = dot2(w11, t.ox, w12, t.oy);
  const V f1 = hn::Mul(w22, t.oy);
  const V f2 = hn::Mul(t.x[0], k);
  const V f3 = hn::Mul(t.y[0], k);
  out.wx = hn::MulAdd(q0, f0, dot2(q2, f2, q3, f3));
  out.wy = hn::MulAdd(p0, f0, hn::MulAdd(p1, f1, dot2(p2, f2, p3, f3)));
  const V e0 = hn::NegMulAdd(p0, out.wy, hn::NegMulAdd(q0, out.wx, f0));
  const V e1 = hn::NegMulAdd(p1, out.wy, f1);
  const V e2 = hn::NegMulAdd(p2, out.wy, hn::NegMulAdd(q2, out.wx, f2));
  const V e3 = hn::NegMulAdd(p3, out.wy, hn::NegMulAdd(q3, out.wx, f3));
  const V squared = hn::Add(dot2(e0, e0, e1, e1), dot2(e2, e2, e3, e3));
  out.residual = hn::Mul(squared, hn::Set(d, -k_unit * k_unit));
  return out;
}

// The rays of every lane: its apex, and the edge that they end on from `from` by `across`; z runs over [z0, z0 + dz].
struct LaneRays {
  V apex_x, apex_y;
  V from_x, from_y;
  V across_x, across_y;
  V z0, dz;
};

// Cuts the edge to where its rays pass within `reach` of the query.
HWY_INLINE void clip(LaneRays& rays, V reach) {
  const Floats d;
  const V zero = hn::Zero(d);
  const V one = hn::Set(d, 1);
  const V squared = hn::NegMulAdd(reach, reach, dot2(rays.apex_x, rays.apex_x, rays.apex_y, rays.apex_y));
  // The tangents from the apex to the circle of that radius around the query.
  const V c = hn::Sqrt(hn::Max(squared, zero));
  const V ux = hn::Neg(rays.apex_x);
  const V uy = hn::Neg(rays.apex_y);
  const auto crossing = [&](V tx, V ty, V& slope) HWY_ATTR {
    slope = hn::MulSub(tx, rays.across_y, hn::Mul(ty, rays.across_x));
    const V start = hn::MulSub(tx, rays.from_y, hn::Mul(ty, rays.from_x));
    return hn::Neg(hn::Div(start, slope));
  };
  V slope_a;
  V slope_b;
  const V za = crossing(hn::NegMulAdd(uy, reach, hn::Mul(ux, c)), hn::MulAdd(ux, reach, hn::Mul(uy, c)), slope_a);
  const V zb = crossing(hn::MulAdd(uy, reach, hn::Mul(ux, c)), hn::NegMulAdd(ux, reach, hn::Mul(uy, c)), slope_b);
  // Both must meet the edge's line in front of the apex.
  const V side = hn::MulSub(rays.from_x, rays.across_y, hn::Mul(rays.from_y, rays.across_x));
  const auto usable = hn::And(hn::Gt(squared, hn::Set(d, 1e-3F)),
                              hn::And(hn::Gt(hn::Mul(slope_a, side), zero), hn::Gt(hn::Mul(slope_b, side), zero)));
  const V lo = hn::Min(hn::Max(hn::Min(za, zb), zero), one);
  const V hi = hn::Min(hn::Max(hn::Max(za, zb), zero), one);
  rays.z0 = hn::IfThenElseZero(usable, lo);
  rays.dz = hn::IfThenElse(usable, hn::Sub(hi, lo), one);
}

// Where the query lies beyond the edge by more than `reach`.
HWY_INLINE hn::Mask<Floats> is_beyond_edge(const LaneRays& rays, V reach) {
  const V apex = hn::MulSub(rays.across_x, rays.from_y, hn::Mul(rays.across_y, rays.from_x));
  const V query = hn::MulSub(rays.across_x, hn::Add(rays.apex_y, rays.from_y),
                             hn::Mul(rays.across_y, hn::Add(rays.apex_x, rays.from_x)));
  const V squared = dot2(rays.across_x, rays.across_x, rays.across_y, rays.across_y);
  const auto opposite = hn::Lt(hn::Mul(apex, query), hn::Zero(Floats()));
  return hn::And(opposite, hn::Gt(hn::Mul(query, query), hn::Mul(hn::Mul(reach, reach), squared)));
}

HWY_INLINE LaneRays make_lane_rays(const WhiteLanes& t, V to_du, V to_dv, V between, V reach) {
  const Floats d;
  const V zero = hn::Zero(d);
  const auto first = hn::And(hn::Le(between, to_du), hn::Le(between, to_dv));
  const auto second = hn::Le(to_dv, to_du);
  const auto choose = [&](V a, V b, V c) HWY_ATTR { return hn::IfThenElse(first, a, hn::IfThenElse(second, b, c)); };
  LaneRays rays;
  rays.apex_x = choose(t.wx, hn::Add(t.wx, t.r11), hn::Add(t.wx, t.r12));
  rays.apex_y = choose(t.wy, t.wy, hn::Add(t.wy, t.r22));
  rays.from_x = choose(t.r11, hn::Neg(t.r11), hn::Neg(t.r12));
  rays.from_y = choose(zero, zero, hn::Neg(t.r22));
  const V to_x = choose(t.r12, hn::Sub(t.r12, t.r11), hn::Sub(t.r11, t.r12));
  const V to_y = choose(t.r22, t.r22, hn::Neg(t.r22));
  rays.across_x = hn::Sub(to_x, rays.from_x);
  rays.across_y = hn::Sub(to_y, rays.from_y);
  clip(rays, reach);
  return rays;
}

HWY_INLINE V lane_cubature(const WhiteLanes& t) {
  const Floats d;
  const V unit = hn::Set(d, k_unit);
  const Cubature& rule = *cubature_for(0.99F * k_longest_cubature * k_longest_cubature);
  V sum = hn::Zero(d);
  for (int k = 0; k < rule.count; ++k) {
    const auto& [a, b, weight] = rule.points[static_cast<std::size_t>(k)];
    const V x = hn::Mul(unit, hn::MulAdd(hn::Set(d, a), t.r11, hn::MulAdd(hn::Set(d, b), t.r12, t.wx)));
    const V y = hn::Mul(unit, hn::MulAdd(hn::Set(d, b), t.r22, t.wy));
    const V exponent = hn::NegMulAdd(x, x, hn::NegMulAdd(y, y, t.residual));
    sum = hn::MulAdd(hn::Set(d, weight), exp2_of_negative(exponent), sum);
  }
  return sum;
}

// One ray of every lane, at z of its edge; without its weight.
HWY_INLINE V lane_ray(const LaneRays& rays, V residual, V at_apex, V z) {
  const Floats d;
  const V zero = hn::Zero(d);
  const V unit = hn::Set(d, k_unit);
  const V dx = hn::MulAdd(z, rays.across_x, rays.from_x);
  const V dy = hn::MulAdd(z, rays.across_y, rays.from_y);
  const V squared = dot2(dx, dx, dy, dy);
  const V inverse = reciprocal_root(squared);
  const V length = hn::Mul(squared, inverse);
  const V scaled = hn::Mul(inverse, unit);
  const V p = hn::Mul(hn::MulSub(rays.apex_x, dy, hn::Mul(rays.apex_y, dx)), scaled);
  const V b = hn::Mul(dot2(rays.apex_x, dx, rays.apex_y, dy), scaled);
  const V c = hn::MulAdd(length, unit, b);
  const V exponent = hn::NegMulAdd(p, p, residual);
  const V on_line = exp2_of_negative(exponent);
  const V at_end = exp2_of_negative(hn::NegMulAdd(c, c, exponent));
  const auto starts_before = hn::Lt(b, zero);
  const auto ends_before = hn::Lt(c, zero);
  V between = hn::IfThenZeroElse(ends_before, hn::IfThenElseZero(starts_before, hn::Mul(on_line, hn::Set(d, k_whole))));
  const V tail_c = hn::Mul(at_end, unit_mills(hn::Abs(c)));
  between = hn::Sub(between, hn::IfThenElse(ends_before, hn::Neg(tail_c), tail_c));
  const V tail_b = hn::Mul(at_apex, unit_mills(hn::Abs(b)));
  between = hn::Add(between, hn::IfThenElse(starts_before, hn::Neg(tail_b), tail_b));
  const V value = hn::NegMulAdd(b, between, hn::Sub(at_apex, at_end));
  return hn::Mul(hn::Mul(inverse, inverse), hn::Max(value, zero));
}

// Rays of many triangles, by field, for sorting by how many a triangle needs.
class RayStore {
 public:
  RayStore(QueryScratch::Arrays& arrays, std::size_t most) : arrays_(arrays) {
    for (std::vector<float>& field : arrays_.rays) {
      if (field.size() < most + static_cast<std::size_t>(k_lanes))
        field.resize(most + static_cast<std::size_t>(k_lanes));
    }
    arrays_.ray_counts.resize(most + static_cast<std::size_t>(k_lanes));
  }

  // Those lanes of `mask`. `factor` multiplies the integral.
  HWY_INLINE void add(const LaneRays& rays, V residual, V factor, V reach, float cut, hn::Mask<Floats> mask) {
    const Floats d;
    const hn::RebindToSigned<Floats> di;
    const V across_x = hn::Mul(rays.across_x, rays.dz);
    const V across_y = hn::Mul(rays.across_y, rays.dz);
    const V edge = hn::Sqrt(dot2(across_x, across_x, across_y, across_y));
    // What is small by its residual need not be as exact: from 1.1 a deviation down to 0.7.
    const V density = hn::MulAdd(reach, hn::Set(d, 0.4F / cut), hn::Set(d, k_nodes_per_deviation - 0.4F));
    const V wanted = hn::Add(hn::Ceil(hn::Mul(edge, density)), hn::Set(d, 2));
    const std::array<V, 8> fields{rays.apex_x,
                                  rays.apex_y,
                                  hn::MulAdd(rays.z0, rays.across_x, rays.from_x),
                                  hn::MulAdd(rays.z0, rays.across_y, rays.from_y),
                                  across_x,
                                  across_y,
                                  residual,
                                  hn::Mul(factor, rays.dz)};
    // Compressed in registers: some processors are slow to compress into memory.
    for (std::size_t k = 0; k < fields.size(); ++k) {
      hn::StoreU(hn::Compress(fields[k], mask), d, arrays_.rays[k].data() + count_);
    }
    hn::StoreU(hn::Compress(hn::ConvertTo(di, wanted), hn::RebindMask(di, mask)), di,
               arrays_.ray_counts.data() + count_);
    count_ += hn::CountTrue(d, mask);
  }

  // The sum of all integrals.
  HWY_INLINE double sum() {
    sort();
    double total = 0;
    for (std::size_t first = 0; first < count_; first += static_cast<std::size_t>(k_lanes)) {
      total += sum_lanes(first, std::min(count_ - first, static_cast<std::size_t>(k_lanes)));
    }
    return total;
  }

 private:
  static constexpr int k_buckets = k_most_panel_nodes + 2;

  static std::size_t bucket_of(std::int32_t count) { return static_cast<std::size_t>(std::min(count, k_buckets - 1)); }

  // By counting: those that need equally many stand together.
  void sort() {
    std::array<std::uint32_t, k_buckets + 1> begins{};
    for (std::size_t k = 0; k < count_; ++k) ++begins[bucket_of(arrays_.ray_counts[k]) + 1];
    for (std::size_t b = 1; b < begins.size(); ++b) begins[b] += begins[b - 1];
    arrays_.order.resize(count_ + static_cast<std::size_t>(k_lanes));
    for (std::size_t k = 0; k < count_; ++k) {
      arrays_.order[begins[bucket_of(arrays_.ray_counts[k])]++] = static_cast<std::int32_t>(k);
    }
    for (int k = 0; k < k_lanes; ++k) arrays_.order[count_ + static_cast<std::size_t>(k)] = 0;
  }

  HWY_INLINE double sum_lanes(std::size_t first, std::size_t lanes) const {
    const Floats d;
    const hn::RebindToSigned<Floats> di;
    const auto ids = hn::LoadU(di, arrays_.order.data() + first);
    const auto field = [&](std::size_t k) HWY_ATTR { return hn::GatherIndex(d, arrays_.rays[k].data(), ids); };
    const LaneRays rays{field(0), field(1), field(2), field(3), field(4), field(5), hn::Zero(d), hn::Zero(d)};
    const V residual = field(6);
    std::int32_t wanted = 2;
    for (std::size_t k = first; k < first + lanes; ++k) {
      wanted = std::max(wanted, arrays_.ray_counts[static_cast<std::size_t>(arrays_.order[k])]);
    }
    const int panels = (wanted + k_most_panel_nodes - 4) / (k_most_panel_nodes - 3);
    const int nodes = panels == 1 ? wanted : (wanted + panels - 1) / panels + 2;
    const RayRules::Rule& rule = ray_rules().rules[static_cast<std::size_t>(nodes)];
    const V at_apex = exp2_of_negative(
        hn::NegMulAdd(hn::Set(d, k_unit * k_unit), dot2(rays.apex_x, rays.apex_x, rays.apex_y, rays.apex_y), residual));
    const float share = 1 / static_cast<float>(panels);
    V along = hn::Zero(d);
    for (int panel = 0; panel < panels; ++panel) {
      for (int k = 0; k < nodes; ++k) {
        const float z = (rule.nodes[static_cast<std::size_t>(k)] + static_cast<float>(panel)) * share;
        along = hn::MulAdd(hn::Set(d, rule.weights[static_cast<std::size_t>(k)]),
                           lane_ray(rays, residual, at_apex, hn::Set(d, z)), along);
      }
    }
    const V used = hn::IfThenElseZero(hn::FirstN(d, lanes), hn::Mul(along, field(7)));
    return static_cast<double>(hn::GetLane(hn::SumOfLanes(d, used)) * share);
  }

  QueryScratch::Arrays& arrays_;
  std::size_t count_ = 0;
};

// Nothing where a triangle is too long.
inline std::optional<double> sum_triangles(const QueryFrame& frame, const QueryNormal& query,
                                           QueryScratch::Arrays& arrays) {
  const Floats d;
  RayStore store(arrays, arrays.triangle_count);
  double total = 0;
  for (std::size_t first = 0; first < arrays.triangle_count; first += static_cast<std::size_t>(k_lanes)) {
    const auto count = std::min<std::size_t>(arrays.triangle_count - first, k_lanes);
    const TriangleLanes triangles = load_triangles(arrays, first, static_cast<int>(count), query);
    const WhiteLanes white = whiten(frame, triangles);
    const V to_du = hn::Mul(white.r11, white.r11);
    const V to_dv = dot2(white.r12, white.r12, white.r22, white.r22);
    const V across = hn::Sub(white.r12, white.r11);
    const V between = dot2(across, across, white.r22, white.r22);
    const V longest = hn::Max(to_du, hn::Max(to_dv, between));
    if (!(hn::GetLane(hn::MaxOfLanes(d, longest)) < k_longest_edge * k_longest_edge)) return std::nullopt;
    const V factor = hn::Mul(hn::Mul(triangles.leg, triangles.leg), hn::Set(d, frame.scale));
    const auto there =
        hn::And(hn::FirstN(d, count), hn::Gt(white.residual, hn::Set(d, -frame.cut * frame.cut * k_unit * k_unit)));
    const auto is_short = hn::And(there, hn::Lt(longest, hn::Set(d, k_longest_cubature * k_longest_cubature)));
    if (!hn::AllFalse(d, is_short)) {
      const V used = hn::IfThenElseZero(is_short, hn::Mul(lane_cubature(white), factor));
      total += static_cast<double>(hn::GetLane(hn::SumOfLanes(d, used)));
    }
    // What the residual leaves of the cut.
    const V reach = hn::Sqrt(hn::Max(
        hn::MulAdd(white.residual, hn::Set(d, 1 / (k_unit * k_unit)), hn::Set(d, frame.cut * frame.cut)), hn::Zero(d)));
    const LaneRays rays = make_lane_rays(white, to_du, to_dv, between, reach);
    const auto live = hn::AndNot(is_beyond_edge(rays, reach), hn::Gt(rays.dz, hn::Zero(d)));
    store.add(rays, white.residual, factor, reach, frame.cut,
              hn::And(there, hn::And(hn::Ge(longest, hn::Set(d, k_longest_cubature * k_longest_cubature)), live)));
  }
  return total + store.sum();
}

}  // namespace
}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
