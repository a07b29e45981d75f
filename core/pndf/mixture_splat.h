#pragma once
// Adds elements of a mixture to a P-NDF image in single precision, with vector instructions.

#include "core/pndf/mixture_rows.h"
#include "core/pndf/pndf_grid.h"

namespace glint {

/// A whole P-NDF image in single precision, with room for vectors that reach beyond its last cells.
class MixtureCanvas {
 public:
  explicit MixtureCanvas(const PndfGrid& grid);

  [[nodiscard]] const PndfGrid& grid() const { return grid_; }
  [[nodiscard]] std::ptrdiff_t stride() const { return stride_; }
  [[nodiscard]] float* row(int index) { return values_.data() + index * stride_; }
  /// Adds what is here to `density`, which has the grid's cells, and begins anew: small terms are lost in large sums.
  void move_to(std::vector<double>& density);

 private:
  static constexpr int k_padding = 16;

  PndfGrid grid_;
  std::ptrdiff_t stride_;
  std::vector<float> values_;
};

/// Adds the elements where they are within their room, and, of cells visited besides, beyond it: never less.
void splat_elements(const ElementList& elements, MixtureCanvas& canvas);

}  // namespace glint
