#pragma once
// Gauss-Legendre rules on [0, 1].

#include <span>

namespace glint {

inline constexpr int k_largest_gauss_rule = 32;

struct GaussRule {
  std::span<const double> nodes;    ///< in (0, 1), descending
  std::span<const double> weights;  ///< sum to 1
};

/// The rule of n points, 1 <= n <= k_largest_gauss_rule; correct to rounding. Thread-safe, computed once.
GaussRule gauss_legendre(int n);

}  // namespace glint
