// Functions of vectors of floats, built once for each of Highway's targets: included inside its per-target machinery
// and nowhere else.

#if defined(GLINT_SIMD_MATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_SIMD_MATH_INL_H_
#undef GLINT_SIMD_MATH_INL_H_
#else
#define GLINT_SIMD_MATH_INL_H_
#endif

#include <array>
#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using V = hn::Vec<Floats>;
inline constexpr int k_lanes = static_cast<int>(hn::MaxLanes(Floats()));

/// exp(-x^2 / 2) = 2^(-(k_unit x)^2)
inline constexpr float k_unit = 0.84932180F;

/// One bit a lane, the first lowest.
HWY_INLINE std::uint32_t mask_bits(hn::Mask<Floats> mask) {
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(Floats(), mask, bytes.data());
  std::uint32_t all = 0;
  for (int k = 0; k < (k_lanes + 7) / 8; ++k) all |= std::uint32_t{bytes[static_cast<std::size_t>(k)]} << (8 * k);
  return all;
}

/// 2^x for x <= 0, relative error 2e-7; 2^-100 below -100, so that few products become denormal numbers.
HWY_INLINE V exp2_of_negative(V x) {
  const Floats d;
  const hn::RebindToSigned<Floats> di;
  x = hn::Max(x, hn::Set(d, -100.0F));
  const V whole = hn::Round(x);
  const V f = hn::Sub(x, whole);
  // Chebyshev interpolation of degree 5 on [-1/2, 1/2].
  V p = hn::Set(d, 1.3390863e-3F);
  p = hn::MulAdd(p, f, hn::Set(d, 9.6760319e-3F));
  p = hn::MulAdd(p, f, hn::Set(d, 5.5503571e-2F));
  p = hn::MulAdd(p, f, hn::Set(d, 2.4022107e-1F));
  p = hn::MulAdd(p, f, hn::Set(d, 6.9314719e-1F));
  p = hn::MulAdd(p, f, hn::Set(d, 1.0000000755F));
  const auto exponent = hn::ShiftLeft<23>(hn::ConvertTo(di, whole));
  return hn::BitCast(d, hn::Add(hn::BitCast(di, p), exponent));
}

/// 1 / x to 2e-7, for normal x.
HWY_INLINE V reciprocal(V x) {
  const Floats d;
#if HWY_TARGET == HWY_SCALAR
  return hn::Div(hn::Set(d, 1.0F), x);
#else
  const V r = hn::ApproximateReciprocal(x);
  return hn::Mul(r, hn::NegMulAdd(x, r, hn::Set(d, 2.0F)));
#endif
}

/// 1 / sqrt(x) to 3e-7, for normal x > 0.
HWY_INLINE V reciprocal_root(V x) {
  const Floats d;
#if HWY_TARGET == HWY_SCALAR
  return hn::Div(hn::Set(d, 1.0F), hn::Sqrt(x));
#else
  const V r = hn::ApproximateReciprocalSqrt(x);
  const V half = hn::Mul(hn::Set(d, 0.5F), x);
  return hn::Mul(r, hn::NegMulAdd(half, hn::Mul(r, r), hn::Set(d, 1.5F)));
#endif
}

/// exp(x^2 / 2) times the integral of exp(-t^2 / 2) from x on (the Mills ratio), for x >= 0: relative error 3e-7 up to
/// x = 6, where the integral is 2e-9, and of the right order beyond.
HWY_INLINE V mills_ratio(V x) {
  const Floats d;
  // Chebyshev interpolation of degree 6 of the ratio over t, in t = 1 / (1 + 0.26 x).
  const V t = reciprocal(hn::MulAdd(x, hn::Set(d, 0.26F), hn::Set(d, 1.0F)));
  V p = hn::Set(d, -1.8616809e-1F);
  p = hn::MulAdd(p, t, hn::Set(d, 5.8520108e-1F));
  p = hn::MulAdd(p, t, hn::Set(d, -2.8160365e-1F));
  p = hn::MulAdd(p, t, hn::Set(d, 4.2622123e-1F));
  p = hn::MulAdd(p, t, hn::Set(d, 1.8141481e-1F));
  p = hn::MulAdd(p, t, hn::Set(d, 2.6872194e-1F));
  p = hn::MulAdd(p, t, hn::Set(d, 2.5952654e-1F));
  return hn::Mul(p, t);
}

/// mills_ratio in units of 1 / k_unit: of x / k_unit, divided by k_unit.
HWY_INLINE V unit_mills(V x) {
  const Floats d;
  return hn::Mul(mills_ratio(hn::Mul(x, hn::Set(d, 1 / k_unit))), hn::Set(d, 1 / k_unit));
}
/// The whole integral of exp(-x^2 / 2) in those units: sqrt(2 pi) / k_unit.
inline constexpr float k_whole = 2.5066283F / k_unit;

}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
