// The triangles that a query found, a vector at a time, gathered by how they are integrated. Built once for each of
// Highway's targets, inside exact_query.cpp and nowhere else.

#if defined(GLINT_QUERY_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_QUERY_TRIANGLES_INL_H_
#undef GLINT_QUERY_TRIANGLES_INL_H_
#else
#define GLINT_QUERY_TRIANGLES_INL_H_
#endif

#include <array>
#include <cstddef>
#include <vector>

#include <hwy/highway.h>

#include "core/math/simd_math-inl.h"
#include "core/pndf/query_rays-inl.h"
#include "core/pndf/query_scratch.h"
#include "core/pndf/triangle_rules.h"

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

// Appends the lanes of the mask. They are brought to the front by one permutation: compressing each field, or into
// memory, is slow on some processors. (Behind the mask's, compressed lanes hold some lane's index on all of our
// targets.)
template <std::size_t fields>
HWY_INLINE void append(const std::array<V, fields>& of, hn::Mask<Floats> mask, FieldList<fields>& list) {
  const Floats d;
  const hn::RebindToSigned<Floats> di;
  const auto front = hn::IndicesFromVec(d, hn::Compress(hn::Iota(di, 0), hn::RebindMask(di, mask)));
  for (std::size_t k = 0; k < fields; ++k) {
    hn::StoreU(hn::TableLookupLanes(of[k], front), d, list.fields[k].data() + list.count);
  }
  list.count += hn::CountTrue(d, mask);
}

// Repeats the last one to the end of its vector: what a vector computes beyond the list stays tame.
template <std::size_t fields>
HWY_INLINE void pad(FieldList<fields>& list) {
  if (list.count == 0) return;
  const Floats d;
  list.reserve(static_cast<std::size_t>(k_lanes));
  for (std::vector<float>& field : list.fields) {
    hn::StoreU(hn::Set(d, field[list.count - 1]), d, field.data() + list.count);
  }
}

// Calls body(fields of a vector, lanes in use) for the first `count` of a padded list.
template <std::size_t fields, class Body>
HWY_INLINE void for_vectors(const FieldList<fields>& list, std::size_t count, Body body) {
  const Floats d;
  for (std::size_t first = 0; first < count; first += static_cast<std::size_t>(k_lanes)) {
    std::array<V, fields> of;
    for (std::size_t k = 0; k < fields; ++k) of[k] = hn::LoadU(d, list.fields[k].data() + first);
    body(of, hn::FirstN(d, count - first));
  }
}

// The triangles of a query on their way: whitened, then gathered by how they are integrated, then integrated.
class TriangleSum {
 public:
  // Of triangles whose legs are `leg` texels long.
  TriangleSum(const QueryFrame& frame, float leg, const QueryNormal& normal, QueryScratch::Arrays& arrays)
      : frame_(frame), leg_(leg), low_(normal.low), arrays_(arrays) {}

  double sum(TriangleList& list) {
    arrays_.long_triangles.count = 0;
    arrays_.long_triangles.reserve(list.count + static_cast<std::size_t>(k_lanes));
    arrays_.short_triangles.count = 0;
    arrays_.short_triangles.reserve(list.count + static_cast<std::size_t>(k_lanes));
    for (RayList* rays : {&arrays_.few_rays, &arrays_.many_rays}) {
      rays->count = 0;
      rays->reserve(list.count + 2 * static_cast<std::size_t>(k_lanes));
    }
    pad(list);
    for_vectors(list, list.count,
                [&](const std::array<V, TriangleList::k_fields>& of, hn::Mask<Floats> there)
                    HWY_ATTR { add(of, there); });
    return static_cast<double>(leg_ * leg_ * frame_.scale) * (sum_short() + sum_rays()) +
           sum_in_double(frame_, arrays_.long_triangles, leg_, low_);
  }

 private:
  static constexpr float k_few_nodes = 9;

  HWY_INLINE void add(const std::array<V, TriangleList::k_fields>& of, hn::Mask<Floats> there) {
    const Floats d;
    const float cut = frame_.cut;
    const V low_x = hn::Set(d, low_[0]);
    const V low_y = hn::Set(d, low_[1]);
    const WhiteLanes white = whiten(frame_,
                                    {of[0],
                                     of[1],
                                     {hn::Sub(of[2], low_x), hn::Sub(of[4], low_x), hn::Sub(of[6], low_x)},
                                     {hn::Sub(of[3], low_y), hn::Sub(of[5], low_y), hn::Sub(of[7], low_y)}},
                                    leg_);
    const V to_du = hn::Mul(white.r11, white.r11);
    const V to_dv = dot2(white.r12, white.r12, white.r22, white.r22);
    const V across = hn::Sub(white.r12, white.r11);
    const V between = dot2(across, across, white.r22, white.r22);
    const V longest = hn::Max(to_du, hn::Max(to_dv, between));
    const auto too_long = hn::AndNot(hn::Lt(longest, hn::Set(d, k_longest_query_edge * k_longest_query_edge)), there);
    if (!hn::AllFalse(d, too_long)) {
      append(of, too_long, arrays_.long_triangles);
      there = hn::AndNot(too_long, there);
    }
    // What the residual leaves of the squared cut.
    const V room = hn::MulAdd(white.residual, hn::Set(d, 1 / (k_unit * k_unit)), hn::Set(d, cut * cut));
    there = hn::And(there, hn::Gt(room, hn::Zero(d)));
    const auto is_long = hn::Ge(longest, hn::Set(d, k_longest_cubature * k_longest_cubature));
    const auto is_short = hn::AndNot(is_long, there);
    if (!hn::AllFalse(d, is_short)) {
      append<WhiteList::k_fields>({white.r11, white.r12, white.r22, white.wx, white.wy, white.residual}, is_short,
                                  arrays_.short_triangles);
    }
    const V reach = rough_root(room);
    const LaneRays rays = make_lane_rays(white, to_du, to_dv, between, reach);
    const auto live = hn::AndNot(is_beyond_edge(rays, reach), hn::Gt(rays.dz, hn::Zero(d)));
    add_rays(rays, white.residual, reach, hn::And(there, hn::And(is_long, live)));
  }

  HWY_INLINE void add_rays(const LaneRays& rays, V residual, V reach, hn::Mask<Floats> mask) {
    const Floats d;
    const V start_x = hn::MulAdd(rays.z0, rays.across_x, rays.from_x);
    const V start_y = hn::MulAdd(rays.z0, rays.across_y, rays.from_y);
    const V across_x = hn::Mul(rays.across_x, rays.dz);
    const V across_y = hn::Mul(rays.across_y, rays.dz);
    // What is small by its residual need not be as exact: from 1.1 a deviation down to 0.5.
    const V density = hn::MulAdd(hn::Mul(reach, reach), hn::Set(d, 0.6F / (frame_.cut * frame_.cut)),
                                 hn::Set(d, k_nodes_per_deviation - 0.6F));
    const V span = ray_span(rays, start_x, start_y, across_x, across_y, reach);
    const V wanted = hn::Add(hn::Ceil(hn::Mul(span, density)), hn::Set(d, 2));
    const std::array<V, RayList::k_fields> fields{rays.apex_x, rays.apex_y, start_x, start_y, across_x,
                                                  across_y,    residual,    rays.dz, wanted};
    const auto many = hn::And(mask, hn::Gt(wanted, hn::Set(d, k_few_nodes)));
    const auto few = hn::AndNot(many, mask);
    if (!hn::AllFalse(d, few)) append(fields, few, arrays_.few_rays);
    if (!hn::AllFalse(d, many)) append(fields, many, arrays_.many_rays);
  }

  // Over how many deviations the integrand changes from ray to ray: along the edge; or, where rays come from beyond the
  // reach and end beyond it, across the rays at the query.
  static HWY_INLINE V ray_span(const LaneRays& rays, V start_x, V start_y, V across_x, V across_y, V reach) {
    const V edge = dot2(across_x, across_x, across_y, across_y);
    const V squared_reach = hn::Mul(reach, reach);
    const V to_edge =
        hn::MulSub(across_x, hn::Add(rays.apex_y, start_y), hn::Mul(across_y, hn::Add(rays.apex_x, start_x)));
    const auto ends_beyond = hn::Gt(hn::Mul(to_edge, to_edge), hn::Mul(squared_reach, edge));
    const auto starts_beyond = hn::Gt(dot2(rays.apex_x, rays.apex_x, rays.apex_y, rays.apex_y), squared_reach);
    const auto distance = [&](V x, V y) HWY_ATTR {
      return hn::Mul(hn::MulSub(rays.apex_x, y, hn::Mul(rays.apex_y, x)), rough_reciprocal_root(dot2(x, x, y, y)));
    };
    const V spread =
        hn::Abs(hn::Sub(distance(start_x, start_y), distance(hn::Add(start_x, across_x), hn::Add(start_y, across_y))));
    const V along = rough_root(edge);
    return hn::IfThenElse(hn::And(ends_beyond, starts_beyond), hn::Min(spread, along), along);
  }

  HWY_INLINE double sum_short() {
    const Floats d;
    WhiteList& list = arrays_.short_triangles;
    pad(list);
    double total = 0;
    for_vectors(list, list.count, [&](const std::array<V, WhiteList::k_fields>& of, hn::Mask<Floats> there) HWY_ATTR {
      const V values = lane_cubature({of[0], of[1], of[2], of[3], of[4], of[5]});
      total += static_cast<double>(hn::GetLane(hn::SumOfLanes(d, hn::IfThenElseZero(there, values))));
    });
    return total;
  }

  HWY_INLINE double sum_rays() {
    const Floats d;
    RayList& few = arrays_.few_rays;
    RayList& many = arrays_.many_rays;
    // What does not fill a vector goes with the others.
    const std::size_t whole = few.count / k_lanes * k_lanes;
    if (whole < few.count) {
      std::array<V, RayList::k_fields> rest;
      for (std::size_t k = 0; k < rest.size(); ++k) rest[k] = hn::LoadU(d, few.fields[k].data() + whole);
      append(rest, hn::FirstN(d, few.count - whole), many);
    }
    pad(many);
    double total = 0;
    const auto add_all = [&](const RayList& list, std::size_t count) HWY_ATTR {
      for_vectors(list, count, [&](const std::array<V, RayList::k_fields>& of, hn::Mask<Floats> there) HWY_ATTR {
        total += sum_ray_lanes(of, there);
      });
    };
    add_all(few, whole);
    add_all(many, many.count);
    return total;
  }

  static HWY_INLINE double sum_ray_lanes(const std::array<V, RayList::k_fields>& of, hn::Mask<Floats> there) {
    const Floats d;
    const LaneRays rays{of[0], of[1], of[2], of[3], of[4], of[5], hn::Zero(d), hn::Zero(d)};
    const V residual = of[6];
    const auto wanted = static_cast<int>(hn::GetLane(hn::MaxOfLanes(d, of[8])));
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
    const V used = hn::IfThenElseZero(there, hn::Mul(along, of[7]));
    return static_cast<double>(hn::GetLane(hn::SumOfLanes(d, used)) * share);
  }

  const QueryFrame& frame_;
  float leg_;
  std::array<float, 2> low_;
  QueryScratch::Arrays& arrays_;
};

}  // namespace
}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
