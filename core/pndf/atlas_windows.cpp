#include "core/pndf/atlas_windows.h"

#include <algorithm>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/pndf/atlas_windows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/pndf/splat_elements-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

// Adds weight * values to the cells of one tile.
HWY_INLINE void add_weighted_tile(float weight, V values, float* out, [[maybe_unused]] std::ptrdiff_t stride) {
#if HWY_MAX_BYTES >= 32 && HWY_TARGET != HWY_SCALAR
  const hn::FixedTag<float, k_tile_columns> row;
  const auto factor = hn::Set(row, weight);
  hn::StoreU(hn::MulAdd(factor, hn::LowerHalf(row, values), hn::LoadU(row, out)), row, out);
  hn::StoreU(hn::MulAdd(factor, hn::UpperHalf(row, values), hn::LoadU(row, out + stride)), row, out + stride);
#else
  const Floats d;
  hn::StoreU(hn::MulAdd(hn::Set(d, weight), values, hn::LoadU(d, out)), d, out);
#endif
}

class WindowSink {
 public:
  WindowSink(const ElementList& elements, double pitch, const std::array<double, 4>& along_v, WindowCanvas& canvas)
      : elements_(elements), per_pitch_(1 / pitch), along_v_(along_v), canvas_(canvas) {}

  HWY_INLINE void begin(std::size_t element) {
    const std::array<double, 4> along_u = cubic_b_splines(static_cast<double>(elements_.u[element]) * per_pitch_);
    for (std::size_t b = 0; b < 4; ++b) {
      for (std::size_t a = 0; a < 4; ++a) weights_[4 * b + a] = static_cast<float>(along_u[a] * along_v_[b]);
    }
  }

  HWY_INLINE void add(V values, int row, int column) {
    WindowCanvas::Touched& t = canvas_.touched;
    t.first_row = std::min(t.first_row, row);
    t.last_row = std::max(t.last_row, row + k_tile_rows - 1);
    t.first_column = std::min(t.first_column, column);
    t.last_column = std::max(t.last_column, column + k_tile_columns - 1);
    float* out = canvas_.row(row, 0) + column;
    const std::ptrdiff_t stride = canvas_.stride();
    for (std::size_t w = 0; w < WindowCanvas::k_windows; ++w) {
      add_weighted_tile(weights_[w], values, out + static_cast<std::ptrdiff_t>(w) * stride, 16 * stride);
    }
  }

 private:
  const ElementList& elements_;
  double per_pitch_;
  std::array<double, 4> along_v_;
  WindowCanvas& canvas_;
  std::array<float, WindowCanvas::k_windows> weights_{};
};

}  // namespace

void splat_windows(const ElementList& row, double pitch, const std::array<double, 4>& along_v, WindowCanvas& canvas) {
  WindowSink sink(row, pitch, along_v, canvas);
  splat_list(row, canvas.grid(), sink);
}

}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glint {

HWY_EXPORT(splat_windows);

WindowCanvas::WindowCanvas(const PndfGrid& grid) : touched{}, grid_(grid), stride_(WindowImage::stride_of(grid)) {
  values_.resize(static_cast<std::size_t>(stride_) * k_windows * (static_cast<std::size_t>(grid.rows) + 1) + k_windows);
  clear();
}

void WindowCanvas::splat(const ElementList& elements, double pitch, const std::array<double, 4>& along_v) {
  HWY_DYNAMIC_DISPATCH(splat_windows)(elements, pitch, along_v, *this);
}

void WindowCanvas::add_to(std::size_t a, std::size_t b, WindowImage& image) const {
  const int last_row = std::min(touched.last_row, grid_.rows - 1);
  const int last_column = std::min(touched.last_column, grid_.columns - 1);
  for (int r = touched.first_row; r <= last_row; ++r) {
    const float* from =
        values_.data() + (static_cast<std::ptrdiff_t>(r) * 16 + static_cast<std::ptrdiff_t>(4 * b + a)) * stride_;
    float* to = image.density.data() + r * image.stride;
    for (int c = touched.first_column; c <= last_column; ++c) to[c] += from[c];
  }
}

void WindowCanvas::clear() {
  for (int r = touched.first_row; r <= touched.last_row; ++r) {
    for (std::size_t w = 0; w < k_windows; ++w) {
      std::fill(row(r, w) + touched.first_column, row(r, w) + touched.last_column + 1, 0.0F);
    }
  }
  touched = {std::numeric_limits<int>::max(), -1, std::numeric_limits<int>::max(), -1};
}

}  // namespace glint

#endif  // once
