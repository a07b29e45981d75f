#include "core/pndf/mixture_splat.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/pndf/mixture_splat.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/pndf/splat_elements-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

class CanvasSink {
 public:
  explicit CanvasSink(MixtureCanvas& canvas) : canvas_(canvas) {}
  HWY_INLINE void begin(std::size_t /*element*/) {}
  HWY_INLINE void add(V values, int row, int column) { add_tile(values, canvas_.row(row) + column, canvas_.stride()); }

 private:
  MixtureCanvas& canvas_;
};

}  // namespace

void splat_all(const ElementList& elements, MixtureCanvas& canvas) {
  CanvasSink sink(canvas);
  splat_list(elements, canvas.grid(), sink);
}

}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glint {

HWY_EXPORT(splat_all);

MixtureCanvas::MixtureCanvas(const PndfGrid& grid)
    : grid_(grid),
      stride_(grid.columns + k_padding),
      values_(static_cast<std::size_t>(stride_) * (static_cast<std::size_t>(grid.rows) + 1) + k_padding) {}

void MixtureCanvas::move_to(std::vector<double>& density) {
  for (int row_index = 0; row_index < grid_.rows; ++row_index) {
    float* from = row(row_index);
    double* to = density.data() + grid_.index(0, row_index);
    for (int column = 0; column < grid_.columns; ++column) to[column] += static_cast<double>(from[column]);
    std::fill(from, from + grid_.columns, 0.0F);
  }
}

void splat_elements(const ElementList& elements, MixtureCanvas& canvas) {
  HWY_DYNAMIC_DISPATCH(splat_all)(elements, canvas);
}

}  // namespace glint

#endif  // once
