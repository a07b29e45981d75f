// Elements of a mixture visited cell by cell, with vector instructions: included inside Highway's per-target machinery
// and nowhere else.

#if defined(GLINT_SPLAT_ELEMENTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_SPLAT_ELEMENTS_INL_H_
#undef GLINT_SPLAT_ELEMENTS_INL_H_
#else
#define GLINT_SPLAT_ELEMENTS_INL_H_
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <hwy/highway.h>

#include "core/math/simd_math-inl.h"
#include "core/pndf/mixture_rows.h"
#include "core/pndf/pndf_grid.h"

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {

// Cells that one vector takes: two rows of them where that leaves four columns.
inline constexpr int k_tile_rows = k_lanes >= 8 ? 2 : 1;
inline constexpr int k_tile_columns = k_lanes / k_tile_rows;

/// Adds to the cells of one tile, whose rows lie `stride` apart.
HWY_INLINE void add_tile(V values, float* out, [[maybe_unused]] std::ptrdiff_t stride) {
#if HWY_MAX_BYTES >= 32 && HWY_TARGET != HWY_SCALAR
  const hn::FixedTag<float, k_tile_columns> row;
  hn::StoreU(hn::Add(hn::LoadU(row, out), hn::LowerHalf(row, values)), row, out);
  hn::StoreU(hn::Add(hn::LoadU(row, out + stride), hn::UpperHalf(row, values)), row, out + stride);
#else
  const Floats d;
  hn::StoreU(hn::Add(hn::LoadU(d, out), values), d, out);
#endif
}

// One element in cells of the image: the density at (x, y) from its middle is
// amplitude 2^-((w11 x + w12 y)^2 + (w22 y)^2).
struct CellElement {
  float x, y;
  float w11, w12, w22;
  float amplitude;
  float room;  // in units of that exponent
};

/// Hands the densities of elements to sink.add(values, row, column), tile by tile, where they are within their room,
/// and, of cells visited besides, beyond it: never less. Tiles may reach beyond the last cells.
template <class Sink>
class Splat {
 public:
  Splat(Sink& sink, const PndfGrid& grid) : sink_(sink), columns_(grid.columns), rows_(grid.rows) {
    for (int k = 0; k < k_lanes; ++k) {
      lane_x_[static_cast<std::size_t>(k)] = static_cast<float>(k % k_tile_columns);
      const int row = k / k_tile_columns;
      lane_y_[static_cast<std::size_t>(k)] = static_cast<float>(row);
      counting_[static_cast<std::size_t>(k)] = static_cast<float>(k);
    }
  }

  HWY_INLINE void add(const CellElement& e) {
    const float reach = std::sqrt(e.room) / e.w22;
    // Clamped as floats: an element may be anywhere.
    const auto first = static_cast<int>(std::clamp(std::ceil(e.y - reach), 0.0F, static_cast<float>(rows_)));
    const auto last = static_cast<int>(std::clamp(std::floor(e.y + reach), -1.0F, static_cast<float>(rows_ - 1)));
    const Floats d;
    const V lane_x = hn::LoadU(d, lane_x_.data());
    const V lane_y = hn::LoadU(d, lane_y_.data());
    for (int begin = first; begin <= last; begin += k_rows_at_once) {
      const int count = std::min(k_rows_at_once, last - begin + 1);
      find_columns(e, begin, count);
      for (int row = 0; row < count; row += k_tile_rows) {
        const auto at = static_cast<std::size_t>(row);
        float from = first_columns_[at];
        float to = last_columns_[at];
        if (k_tile_rows == 2 && row + 1 < count) {
          from = std::min(from, first_columns_[at + 1]);
          to = std::max(to, last_columns_[at + 1]);
        }
        from = std::max(from, 0.0F);
        to = std::min(to, static_cast<float>(columns_ - 1));
        if (!(from <= to)) continue;
        add_row(e, begin + row, static_cast<int>(from), static_cast<int>(to), lane_x, lane_y);
      }
    }
  }

 private:
  static constexpr int k_rows_at_once = 16;

  // Of rows begin, begin + 1, …: the columns of the ellipse, of none where it does not reach the row.
  HWY_INLINE void find_columns(const CellElement& e, int begin, int count) {
    const Floats d;
    const float inverse = 1 / e.w11;
    const float slope = -e.w12 * inverse;
    for (int row = 0; row < count; row += k_lanes) {
      const V dy = hn::Add(hn::LoadU(d, counting_.data()), hn::Set(d, static_cast<float>(begin + row) - e.y));
      const V down = hn::Mul(dy, hn::Set(d, e.w22));
      const V left = hn::Max(hn::NegMulAdd(down, down, hn::Set(d, e.room)), hn::Zero(d));
      const V half = hn::Mul(hn::Sqrt(left), hn::Set(d, inverse));
      const V middle = hn::MulAdd(dy, hn::Set(d, slope), hn::Set(d, e.x));
      hn::StoreU(hn::Ceil(hn::Sub(middle, half)), d, first_columns_.data() + row);
      hn::StoreU(hn::Floor(hn::Add(middle, half)), d, last_columns_.data() + row);
    }
  }

  // Cells from .. to of one or two rows.
  HWY_INLINE void add_row(const CellElement& e, int row, int from, int to, V lane_x, V lane_y) {
    const Floats d;
    const V y = hn::Add(lane_y, hn::Set(d, static_cast<float>(row) - e.y));
    const V down = hn::Mul(y, hn::Set(d, e.w22));
    const V of_row = hn::Neg(hn::Mul(down, down));
    const V lean = hn::Mul(y, hn::Set(d, e.w12));
    const V w11 = hn::Set(d, e.w11);
    const V amplitude = hn::Set(d, e.amplitude);
    V x = hn::Add(lane_x, hn::Set(d, static_cast<float>(from) - e.x));
    for (int column = from; column <= to; column += k_tile_columns) {
      const V across = hn::MulAdd(x, w11, lean);
      const V exponent = hn::NegMulAdd(across, across, of_row);
      const V value = hn::Mul(amplitude, rough_exp2_of_negative(exponent));
      sink_.add(value, row, column);
      x = hn::Add(x, hn::Set(d, static_cast<float>(k_tile_columns)));
    }
  }

  std::array<float, static_cast<std::size_t>(k_lanes)> lane_x_{};
  std::array<float, static_cast<std::size_t>(k_lanes)> lane_y_{};
  std::array<float, static_cast<std::size_t>(k_lanes)> counting_{};
  std::array<float, std::size_t{2} * k_rows_at_once> first_columns_{};
  std::array<float, std::size_t{2} * k_rows_at_once> last_columns_{};
  Sink& sink_;
  int columns_;
  int rows_;
};

/// All elements of a list into sink, after sink.begin(its index) of each.
template <class Sink>
HWY_INLINE void splat_list(const ElementList& elements, const PndfGrid& grid, Sink& sink) {
  const Floats d;
  const glm::dvec2 pitch = grid.pitch();
  const auto per_x = static_cast<float>(1 / pitch.x);
  const auto per_y = static_cast<float>(1 / pitch.y);
  const auto start_x = static_cast<float>(-grid.s_min / pitch.x - 0.5);
  const auto start_y = static_cast<float>(grid.t_max / pitch.y - 0.5);
  const auto wide = static_cast<float>(k_unit * pitch.x);
  const auto high = static_cast<float>(k_unit * pitch.y);
  Splat<Sink> splat(sink, grid);
  for (std::size_t first = 0; first < elements.count; first += static_cast<std::size_t>(k_lanes)) {
    const auto load = [&](const std::vector<float>& field) HWY_ATTR { return hn::LoadU(d, field.data() + first); };
    struct alignas(64) Lanes {
      std::array<float, static_cast<std::size_t>(k_lanes)> of;
    };
    std::array<Lanes, 7> fields;
    const auto keep = [&](std::size_t k, V values) HWY_ATTR { hn::Store(values, d, fields[k].of.data()); };
    // In cells; rows run down.
    keep(0, hn::MulAdd(load(elements.x), hn::Set(d, per_x), hn::Set(d, start_x)));
    keep(1, hn::NegMulAdd(load(elements.y), hn::Set(d, per_y), hn::Set(d, start_y)));
    keep(2, hn::Mul(load(elements.w11), hn::Set(d, wide)));
    keep(3, hn::Mul(load(elements.w12), hn::Set(d, -high)));
    keep(4, hn::Mul(load(elements.w22), hn::Set(d, high)));
    keep(5, load(elements.amplitude));
    keep(6, hn::Mul(load(elements.room), hn::Set(d, k_unit * k_unit)));
    const std::size_t count = std::min(elements.count - first, static_cast<std::size_t>(k_lanes));
    for (std::size_t k = 0; k < count; ++k) {
      const auto of = [&](std::size_t field) { return fields[field].of[k]; };
      sink.begin(first + k);
      splat.add({of(0), of(1), of(2), of(3), of(4), of(5), of(6)});
    }
  }
}

}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggle
