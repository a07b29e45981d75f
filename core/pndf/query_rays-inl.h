// Triangles of a query, a vector at a time: QR whitening, then cubature or rays as in triangle_splat.cpp. Built once
// for each of Highway's targets, inside exact_query.cpp and nowhere else.

#if defined(GLINT_QUERY_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_QUERY_RAYS_INL_H_
#undef GLINT_QUERY_RAYS_INL_H_
#else
#define GLINT_QUERY_RAYS_INL_H_
#endif

#include <array>

#include <hwy/highway.h>

#include "core/math/simd_math-inl.h"
#include "core/pndf/exact_query.h"
#include "core/pndf/ray_integral-inl.h"
#include "core/pndf/triangle_rules.h"

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

// A vector of triangles, as a TriangleList has them.
struct TriangleLanes {
  V ox, oy;
  std::array<V, 3> x;
  std::array<V, 3> y;
};

// Whitened, as SplatTriangle, at the query.
struct WhiteLanes {
  V r11, r12, r22;
  V wx, wy;    // the right angle
  V residual;  // log2 of its factor
};

HWY_INLINE V dot2(V a, V b, V c, V e) {
  return hn::MulAdd(a, b, hn::Mul(c, e));
}

// `leg` is that of every triangle, texels.
HWY_INLINE WhiteLanes whiten(const QueryFrame& frame, const TriangleLanes& t, float leg) {
  const Floats d;
  const V w11 = hn::Set(d, frame.w11);
  const V w12 = hn::Set(d, frame.w12);
  const V w22 = hn::Set(d, frame.w22);
  const V k = hn::Set(d, frame.inverse_roughness);
  const V a0 = hn::Set(d, frame.w11 * leg);
  const V a2 = hn::Mul(hn::Sub(t.x[1], t.x[0]), k);
  const V a3 = hn::Mul(hn::Sub(t.y[1], t.y[0]), k);
  const V b0 = hn::Set(d, frame.w12 * leg);
  const V b1 = hn::Set(d, frame.w22 * leg);
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

// To 4e-4, where more would be wasted: in what bounds a reach or counts nodes.
HWY_INLINE V rough_reciprocal_root(V x) {
#if HWY_TARGET == HWY_SCALAR
  return hn::Div(hn::Set(Floats(), 1), hn::Sqrt(x));
#else
  return hn::ApproximateReciprocalSqrt(x);
#endif
}

// 0 for negative x.
HWY_INLINE V rough_root(V x) {
  const Floats d;
  return hn::Mul(hn::Max(x, hn::Zero(d)), rough_reciprocal_root(hn::Max(x, hn::Set(d, 1e-12F))));
}

// Cuts the edge to where its rays pass within `reach` of the query.
HWY_INLINE void clip(LaneRays& rays, V reach) {
  const Floats d;
  const V zero = hn::Zero(d);
  const V one = hn::Set(d, 1);
  const V squared = hn::NegMulAdd(reach, reach, dot2(rays.apex_x, rays.apex_x, rays.apex_y, rays.apex_y));
  // The tangents from the apex to the circle of that radius around the query.
  const V c = rough_root(squared);
  const V ux = hn::Neg(rays.apex_x);
  const V uy = hn::Neg(rays.apex_y);
  const auto crossing = [&](V tx, V ty, V& slope) HWY_ATTR {
    slope = hn::MulSub(tx, rays.across_y, hn::Mul(ty, rays.across_x));
    const V start = hn::MulSub(tx, rays.from_y, hn::Mul(ty, rays.from_x));
    return hn::Neg(hn::Mul(start, reciprocal(slope)));
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
  return hn::Mul(hn::Mul(inverse, inverse), ray_integral<true, true>(b, c, on_line, at_apex, at_end));
}

}  // namespace
}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
