#pragma once
// The Catmull-Rom cubic through four samples p0 … p3 at x = -1, 0, 1, 2, evaluated at x in [0, 1]:
// p(x) = sum of weights[k] p_k (Yan et al. 2014 interpolate (s, t) with it, each axis by itself).

#include <array>

namespace glint {

using CubicWeights = std::array<double, 4>;

constexpr CubicWeights catmull_rom(double x) {
  return {0.5 * x * (-1 + x * (2 - x)), 1 + 0.5 * x * x * (-5 + 3 * x), 0.5 * x * (1 + x * (4 - 3 * x)),
          0.5 * x * x * (x - 1)};
}

constexpr CubicWeights catmull_rom_derivative(double x) {
  return {0.5 * (-1 + x * (4 - 3 * x)), 0.5 * x * (-10 + 9 * x), 0.5 * (1 + x * (8 - 9 * x)), 0.5 * x * (3 * x - 2)};
}

constexpr CubicWeights catmull_rom_second_derivative(double x) {
  return {2 - 3 * x, -5 + 9 * x, 4 - 9 * x, 3 * x - 1};
}

/// The second differences at the two samples around x, interpolated linearly: unlike the second derivative, which jumps
/// at samples, it is continuous.
constexpr CubicWeights catmull_rom_second_difference(double x) {
  return {1 - x, 3 * x - 2, 1 - 3 * x, x};
}

/// The largest sum of the negative weights of the bicubic, in absolute value: a value never leaves the range [lo, hi]
/// of its 16 samples by more than this share of hi - lo. Per axis they sum to x (1 - x) / 2 <= 1/8; (1.25^2 - 1) / 2 in
/// 2D.
inline constexpr double k_catmull_rom_overshoot = 0.28125;

}  // namespace glint
