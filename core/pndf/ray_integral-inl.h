// The integral of a Gaussian along one ray of a triangle, a vector at a time. Built once for each of Highway's targets,
// inside the files that name it and nowhere else.

#if defined(GLINT_RAY_INTEGRAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_RAY_INTEGRAL_INL_H_
#undef GLINT_RAY_INTEGRAL_INL_H_
#else
#define GLINT_RAY_INTEGRAL_INL_H_
#endif

#include <hwy/highway.h>

#include "core/math/simd_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

// l^2 times the integral of z exp(-|a + z d|^2 / 2) over z in [0, 1], l = |d|: of a ray that starts at `a` and whose
// line passes the origin at a distance p; it runs from b = a.d / l to c = b + l along its line. b and c are in units of
// 1 / k_unit; `on_line` is exp(-p^2 / 2), `at_start` and `at_end` are exp(-|a|^2 / 2) and exp(-|a + d|^2 / 2), all
// times whatever factor. With the Mills ratio M:
//   at_start (1 - |b| M(|b|)) - at_end (1 - sign(c) b M(|c|)) - [b < 0 <= c] b sqrt(2 pi) on_line
// A start or an end that is too far away to matter is left out.
template <bool near_start, bool near_end>
HWY_INLINE V ray_integral(V b, V c, V on_line, V at_start, V at_end) {
  const Floats d;
  const V zero = hn::Zero(d);
  const V whole = hn::Mul(hn::Mul(b, hn::Set(d, -k_whole)), on_line);
  if constexpr (!near_start && !near_end) return whole;
  auto crosses = hn::Lt(b, zero);
  V sum = zero;
  if constexpr (near_end) {
    // By one mask: b or c may be zero.
    const auto ends_before = hn::Lt(c, zero);
    crosses = hn::AndNot(ends_before, crosses);
    const V signed_b = hn::IfThenElse(ends_before, hn::Neg(b), b);
    sum = hn::Mul(at_end, hn::MulSub(signed_b, unit_mills(hn::Abs(c)), hn::Set(d, 1)));
  }
  if constexpr (near_start) sum = hn::MulAdd(at_start, unit_mills_remainder(hn::Abs(b)), sum);
  return hn::Max(hn::Add(sum, hn::IfThenElseZero(crosses, whole)), zero);
}

}  // namespace
}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
