#pragma once
// Images under B-spline windows over a map: what MixtureAtlas keeps.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "core/math/parallel.h"
#include "core/pndf/mixture_rows.h"
#include "core/pndf/pndf_grid.h"
#include "core/pndf/spline_footprint.h"

namespace glint {

/// Cells of an image in single precision, rows of whole runs of 16 with room for vectors that reach beyond.
struct WindowImage {
  std::ptrdiff_t stride;
  std::vector<float> density;

  static std::ptrdiff_t stride_of(const PndfGrid& grid) { return (grid.columns + 15) / 16 * 16 + 16; }
  explicit WindowImage(const PndfGrid& grid)
      : stride(stride_of(grid)), density(static_cast<std::size_t>(stride) * static_cast<std::size_t>(grid.rows)) {}
};

/// The densities under the 16 windows that overlap one cell of a spline lattice, from the elements in that cell.
class WindowCanvas {
 public:
  static constexpr std::size_t k_windows = 16;

  explicit WindowCanvas(const PndfGrid& grid);

  /// Adds a row of elements whose offsets u are from the cell's left border: along_v weighs the windows along v.
  void splat(const ElementList& row, double pitch, const std::array<double, 4>& along_v);
  /// Adds window (a, b) of 0 … 3 each to an image.
  void add_to(std::size_t a, std::size_t b, WindowImage& image) const;
  /// Begins anew.
  void clear();

  [[nodiscard]] const PndfGrid& grid() const { return grid_; }
  /// Of that row of cells and window.
  [[nodiscard]] float* row(int index, std::size_t window) {
    return values_.data() + (static_cast<std::ptrdiff_t>(index) * 16 + static_cast<std::ptrdiff_t>(window)) * stride_;
  }
  [[nodiscard]] std::ptrdiff_t stride() const { return stride_; }

  /// Cells that were touched: rows and columns, first to last.
  struct Touched {
    int first_row, last_row, first_column, last_column;
  };
  Touched touched;

 private:
  PndfGrid grid_;
  std::ptrdiff_t stride_;
  std::vector<float> values_;
};

}  // namespace glint
