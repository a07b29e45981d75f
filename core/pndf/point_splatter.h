#pragma once
// Weighted normals, each smeared by the roughness, summed into a grid of s.

#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "core/pndf/pndf_grid.h"

namespace glint {

/// A band of rows of a P-NDF image under construction. Belongs to one thread.
class PointSplatter {
 public:
  /// Rows [first_row, first_row + rows) of the grid; `roughness` per axis.
  PointSplatter(const PndfGrid& grid, int first_row, int rows, glm::dvec2 roughness);

  /// Adds weight * N(s; normal, roughness^2) to every cell whose centre is within `reach` deviations on each axis. A
  /// Gaussian on a regular grid is a product of two geometric recurrences: a few flops a cell.
  void add(double weight, glm::dvec2 normal, double reach);

  /// Calls value(s) for the cells whose centres lie in the box and adds what it returns.
  template <class Value>
  void add_cells(glm::dvec2 lo, glm::dvec2 hi, Value value) {
    const Range columns = column_range(lo.x, hi.x);
    const Range rows = row_range(lo.y, hi.y);
    for (int row = rows.begin; row < rows.end; ++row) {
      double* line = line_of(row);
      for (int column = columns.begin; column < columns.end; ++column) line[column] += value(grid_.center(column, row));
    }
  }
  /// How many cells have their centres in the box.
  [[nodiscard]] double count_cells(glm::dvec2 lo, glm::dvec2 hi) const;

  [[nodiscard]] std::span<const double> sums() const { return sums_; }

 private:
  struct Range {
    int begin;
    int end;
  };
  [[nodiscard]] Range column_range(double lo, double hi) const;
  [[nodiscard]] Range row_range(double lo, double hi) const;
  [[nodiscard]] double* line_of(int row) {
    return sums_.data() + static_cast<std::size_t>(row - first_row_) * static_cast<std::size_t>(grid_.columns);
  }

  PndfGrid grid_;
  int first_row_;
  int rows_;
  glm::dvec2 roughness_;
  double peak_;
  std::vector<double> sums_;
  std::vector<double> profile_;  // of one point along s
};

}  // namespace glint
