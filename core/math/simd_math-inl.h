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

/// The mask of those bits.
HWY_INLINE hn::Mask<Floats> mask_of_bits(std::uint32_t bits) {
  const std::array<std::uint8_t, 8> bytes{static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8U)};
  return hn::LoadMaskBits(Floats(), bytes.data());
}

/// x as a whole number and a rest in [-1/2, 1/2].
struct WholeAndRest {
  hn::Vec<hn::RebindToSigned<Floats>> exponent;  ///< the number, shifted to where floats keep theirs
  V rest;
};
HWY_INLINE WholeAndRest split_exponent(V x) {
  const Floats d;
  const hn::RebindToSigned<Floats> di;
  // Rounds: the lowest bits of the sum are those of the integer.
  const V shift = hn::Set(d, 12582912.0F);  // 1.5 2^23
  const V shifted = hn::Add(x, shift);
  return {hn::ShiftLeft<23>(hn::BitCast(di, shifted)), hn::Sub(x, hn::Sub(shifted, shift))};
}
HWY_INLINE V scale_by_exponent(V x, hn::Vec<hn::RebindToSigned<Floats>> exponent) {
  const Floats d;
  return hn::BitCast(d, hn::Add(hn::BitCast(hn::RebindToSigned<Floats>(), x), exponent));
}

/// 2^x for x <= 0, relative error 2e-7; 2^-100 below -100, so that few products become denormal numbers.
HWY_INLINE V exp2_of_negative(V x) {
  const Floats d;
  const auto [exponent, f] = split_exponent(hn::Max(x, hn::Set(d, -100.0F)));
  // Chebyshev interpolation of degree 5 on [-1/2, 1/2].
  V p = hn::Set(d, 1.3390863e-3F);
  p = hn::MulAdd(p, f, hn::Set(d, 9.6760319e-3F));
  p = hn::MulAdd(p, f, hn::Set(d, 5.5503571e-2F));
  p = hn::MulAdd(p, f, hn::Set(d, 2.4022107e-1F));
  p = hn::MulAdd(p, f, hn::Set(d, 6.9314719e-1F));
  p = hn::MulAdd(p, f, hn::Set(d, 1.0000000755F));
  return scale_by_exponent(p, exponent);
}

/// Likewise to 4e-6.
HWY_INLINE V rough_exp2_of_negative(V x) {
  const Floats d;
  const auto [exponent, f] = split_exponent(hn::Max(x, hn::Set(d, -100.0F)));
  // Chebyshev interpolation of degree 4 on [-1/2, 1/2].
  V p = hn::Set(d, 0.00966636852F);
  p = hn::MulAdd(p, f, hn::Set(d, 0.0559219758F));
  p = hn::MulAdd(p, f, hn::Set(d, 0.24022349F));
  p = hn::MulAdd(p, f, hn::Set(d, 0.693121045F));
  p = hn::MulAdd(p, f, hn::Set(d, 1.0F));
  return scale_by_exponent(p, exponent);
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

/// The Mills ratio exp(x^2 / 2) (integral of exp(-t^2 / 2) from x on) for x >= 0, of x / k_unit and divided by k_unit:
/// within 2.6e-6 up to x = 6, where the integral is 2e-9, and of the right order beyond.
HWY_INLINE V unit_mills(V x) {
  const Floats d;
  // Chebyshev interpolation of degree 5 of the ratio over t, in t = 1 / (1 + 0.3 x / k_unit).
  const V t = reciprocal(hn::MulAdd(x, hn::Set(d, 0.3F / k_unit), hn::Set(d, 1.0F)));
  V p = hn::Set(d, -0.24564824F);
  p = hn::MulAdd(p, t, hn::Set(d, 0.69388414F));
  p = hn::MulAdd(p, t, hn::Set(d, -0.11724073F));
  p = hn::MulAdd(p, t, hn::Set(d, 0.46397755F));
  p = hn::MulAdd(p, t, hn::Set(d, 0.32522441F));
  p = hn::MulAdd(p, t, hn::Set(d, 0.35546496F));
  return hn::Mul(p, t);
}

/// 1 - x times the Mills ratio, of x / k_unit for x >= 0: within 1e-6, and of the right order beyond 6.
HWY_INLINE V unit_mills_remainder(V x) {
  const Floats d;
  // Chebyshev interpolation of degree 6 of the value over t^2, in t = 1 / (1 + 0.26 x / k_unit).
  const V t = reciprocal(hn::MulAdd(x, hn::Set(d, 0.26F / k_unit), hn::Set(d, 1.0F)));
  V p = hn::Set(d, -0.27891955F);
  p = hn::MulAdd(p, t, hn::Set(d, 0.67202165F));
  p = hn::MulAdd(p, t, hn::Set(d, 0.030152207F));
  p = hn::MulAdd(p, t, hn::Set(d, 0.10225236F));
  p = hn::MulAdd(p, t, hn::Set(d, 0.30338185F));
  p = hn::MulAdd(p, t, hn::Set(d, 0.099561283F));
  p = hn::MulAdd(p, t, hn::Set(d, 0.071549212F));
  return hn::Mul(p, hn::Mul(t, t));
}
/// The whole integral of exp(-x^2 / 2), divided likewise.
inline constexpr float k_whole = 2.5066283F / k_unit;

}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
