#pragma once
// Whether drawn normals have the density they should have.

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/pndf/pndf_model.h"

namespace glint::test {

inline constexpr int k_chi_square_cells = 20;  ///< a side
inline constexpr int k_finer = 16;

/// The same window with 16 x 16 cells in each.
inline PndfGrid finer(PndfGrid grid) {
  grid.columns *= k_finer;
  grid.rows *= k_finer;
  return grid;
}

/// Pearson's statistic of 10^5 normals that `pndf` draws, counted in the cells of `grid`, against the densities of
/// `fine` on finer(grid); as a standard normal deviate (Wilson and Hilferty).
inline double chi_square_deviate(const FootprintPndf& pndf, const PndfGrid& grid, const PndfImage& fine) {
  constexpr int k_draws = 100'000;
  std::vector<double> expected(grid.cells() + 1);
  for (int row = 0; row < fine.grid.rows; ++row) {
    for (int column = 0; column < fine.grid.columns; ++column) {
      expected[grid.index(column / k_finer, row / k_finer)] +=
          k_draws * fine.density[fine.grid.index(column, row)] * fine.grid.cell_area();
    }
  }
  double inside = 0;
  for (const double mass : expected) inside += mass;
  expected.back() = std::max(0.0, k_draws - inside);
  std::vector<double> drawn(expected.size());
  RandomStream random(31, 17);
  for (int k = 0; k < k_draws; ++k) {
    const auto cell = grid.cell_at(pndf.sample(random));
    ++drawn[cell ? grid.index(cell->x, cell->y) : drawn.size() - 1];
  }
  double statistic = 0;
  int freedom = -1;
  double rare_expected = 0;
  double rare_drawn = 0;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if (expected[k] < 10) {
      rare_expected += expected[k];
      rare_drawn += drawn[k];
      continue;
    }
    statistic += (drawn[k] - expected[k]) * (drawn[k] - expected[k]) / expected[k];
    ++freedom;
  }
  if (rare_expected > 10) {
    statistic += (rare_drawn - rare_expected) * (rare_drawn - rare_expected) / rare_expected;
    ++freedom;
  }
  const double share = 2.0 / (9.0 * freedom);
  return (std::cbrt(statistic / freedom) - (1 - share)) / std::sqrt(share);
}

}  // namespace glint::test
