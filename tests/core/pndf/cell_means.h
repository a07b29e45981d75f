#pragma once
// What binning estimates: the mean of D_P over each cell of a grid.

#include <vector>

#include <gtest/gtest.h>

#include "core/pndf/exact_pndf.h"
#include "tests/core/pndf/test_maps.h"

namespace glint::test {

/// Means of 4 x 4 exact values a cell, for grids whose quarter cells are finer than sigma_r / 0.6.
inline std::vector<double> cell_means(const ExactPndf& model, const Footprint& footprint, PndfGrid grid) {
  constexpr int k_parts = 4;
  const PndfGrid coarse = grid;
  grid.columns *= k_parts;
  grid.rows *= k_parts;
  const PndfImage fine = image_of(model, footprint, grid);
  EXPECT_EQ(fine.widening, glm::dvec2(0, 0));
  std::vector<double> means(coarse.cells());
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      means[coarse.index(column / k_parts, row / k_parts)] +=
          fine.density[grid.index(column, row)] / (k_parts * k_parts);
    }
  }
  return means;
}

}  // namespace glint::test
