#pragma once
// Beckmann's distribution of normals, convolved with the intrinsic roughness: what many flakes come to.

#include <cmath>
#include <numbers>
#include <vector>

#include <glm/vec2.hpp>

#include "core/math/gaussian.h"
#include "core/pndf/pndf_grid.h"

namespace glint::test {

/// Normals that stand for equal shares of Beckmann's P22: by strata of exp(-|m|^2 / alpha^2) and of the direction.
inline std::vector<glm::dvec2> beckmann_normals(double alpha) {
  constexpr int k_steepness = 200;
  constexpr int k_directions = 64;
  std::vector<glm::dvec2> normals;
  for (int a = 0; a < k_steepness; ++a) {
    const double slope = alpha * std::sqrt(-std::log((a + 0.5) / k_steepness));
    const double length = slope / std::sqrt(1 + slope * slope);
    for (int b = 0; b < k_directions; ++b) {
      const double direction = 2 * std::numbers::pi * (b + 0.5 * (a % 2)) / k_directions;
      normals.emplace_back(length * std::cos(direction), length * std::sin(direction));
    }
  }
  return normals;
}

/// Densities at the centres of the grid's cells.
inline std::vector<double> beckmann_image(const PndfGrid& grid, double alpha, double roughness) {
  const std::vector<glm::dvec2> normals = beckmann_normals(alpha);
  const double variance = roughness * roughness;
  std::vector<double> density(grid.cells());
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      double& sum = density[grid.index(column, row)];
      for (const glm::dvec2 n : normals) sum += normal_density(grid.center(column, row) - n, {variance, 0, variance});
      sum /= static_cast<double>(normals.size());
    }
  }
  return density;
}

}  // namespace glint::test
