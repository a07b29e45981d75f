#include "core/math/quadrature.h"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace glint {
namespace {

constexpr std::size_t k_entries = k_largest_gauss_rule * (k_largest_gauss_rule + 1) / 2;

struct Tables {
  std::array<double, k_entries> nodes{};
  std::array<double, k_entries> weights{};
};

std::size_t first_entry(int n) {
  return static_cast<std::size_t>(n) * static_cast<std::size_t>(n - 1) / 2;
}

// Newton's iteration on the Legendre polynomial P_n in extended precision, from Tricomi's start.
Tables compute_tables() {
  Tables tables;
  for (int n = 1; n <= k_largest_gauss_rule; ++n) {
    for (int k = 0; k < n; ++k) {
      long double z = std::cos(std::numbers::pi_v<long double> * (k + 0.75L) / (n + 0.5L));
      long double slope = 1;
      for (int iteration = 0; iteration < 20; ++iteration) {
        long double before = 1;
        long double value = z;
        for (int degree = 2; degree <= n; ++degree) {
          const long double next = ((2 * degree - 1) * z * value - (degree - 1) * before) / degree;
          before = value;
          value = next;
        }
        slope = n * (z * value - before) / (z * z - 1);
        z -= value / slope;
      }
      const std::size_t entry = first_entry(n) + static_cast<std::size_t>(k);
      tables.nodes[entry] = static_cast<double>((z + 1) / 2);
      tables.weights[entry] = static_cast<double>(1 / ((1 - z * z) * slope * slope));
    }
  }
  return tables;
}

}  // namespace

GaussRule gauss_legendre(int n) {
  assert(n >= 1 && n <= k_largest_gauss_rule);
  static const Tables k_tables = compute_tables();
  const auto count = static_cast<std::size_t>(n);
  return {std::span(k_tables.nodes).subspan(first_entry(n), count),
          std::span(k_tables.weights).subspan(first_entry(n), count)};
}

}  // namespace glint
