// The vertices of 4 x 4 cells of a surface, a vector of cells at a time. Built once for each of Highway's targets,
// inside the files that name it and nowhere else.

#if defined(GLINT_QUERY_CELLS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_QUERY_CELLS_INL_H_
#undef GLINT_QUERY_CELLS_INL_H_
#else
#define GLINT_QUERY_CELLS_INL_H_
#endif

#include <array>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "core/math/simd_math-inl.h"
#include "core/pndf/surface_cells.h"
#include "core/surface/catmull_rom.h"

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

// Columns and rows of 16 children.
alignas(64) inline constexpr std::array<float, 16> k_columns{0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) inline constexpr std::array<float, 16> k_rows{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

// The normals at the four corners of a vector of cells: [0] upper left, [1] upper right, [2] lower left, [3] lower
// right.
struct CornerLanes {
  std::array<V, 4> x;
  std::array<V, 4> y;
};

// `columns` x `rows` texels, at most 7 x 7, row by row; where they cross the border, in a copy.
class TexelWindow {
 public:
  TexelWindow(const NormalMap& map, std::int64_t i, std::int64_t j, int columns, int rows) {
    if (i >= 0 && j >= 0 && i + columns <= map.width() && j + rows <= map.height()) {
      first_ = map.normals().data() + j * map.width() + i;
      stride_ = map.width();
      return;
    }
    for (int r = 0; r < rows; ++r) {
      for (int c = 0; c < columns; ++c) {
        spare_[7 * static_cast<std::size_t>(r) + static_cast<std::size_t>(c)] = map.texel(i + c, j + r);
      }
    }
    first_ = spare_.data();
    stride_ = 7;
  }
  TexelWindow(const TexelWindow&) = delete;
  TexelWindow& operator=(const TexelWindow&) = delete;
  ~TexelWindow() = default;

  [[nodiscard]] HWY_INLINE const float* row(int r) const { return &first_[r * stride_].x; }

 private:
  const glm::vec2* first_;
  std::ptrdiff_t stride_;
  std::array<glm::vec2, 49> spare_;
};

// Of 4 x 4 texels those first, first + 1, …; they begin `right` texels behind each row's first.
HWY_INLINE void block_texels(const float* const* rows, int right, int first, V& x, V& y) {
  const Floats d;
  const auto from = [&](int row) HWY_ATTR { return rows[first / 4 + row] + std::ptrdiff_t{2} * right; };
#if HWY_TARGET == HWY_SCALAR
  x = hn::Set(d, from(0)[2 * (first % 4)]);
  y = hn::Set(d, from(0)[2 * (first % 4) + 1]);
#else
#if HWY_MAX_BYTES == 64
  const hn::FixedTag<float, 8> half;
  const V lower = hn::Combine(d, hn::LoadU(half, from(1)), hn::LoadU(half, from(0)));
  const V upper = hn::Combine(d, hn::LoadU(half, from(3)), hn::LoadU(half, from(2)));
#elif HWY_MAX_BYTES == 32
  const V lower = hn::LoadU(d, from(0));
  const V upper = hn::LoadU(d, from(1));
#else
  const V lower = hn::LoadU(d, from(0));
  const V upper = hn::LoadU(d, from(0) + 4);
#endif
  x = hn::ConcatEven(d, upper, lower);
  y = hn::ConcatOdd(d, upper, lower);
#endif
}

// 4 x 4 cells whose vertices are texels.
class LinearCells {
 public:
  static constexpr float k_size = 1;  // of a cell, texels

  explicit LinearCells(const TexelWindow& texels) {
    for (int r = 0; r < 5; ++r) rows_[static_cast<std::size_t>(r)] = texels.row(r);
  }

  // Those of cells first, first + 1, …
  [[nodiscard]] HWY_INLINE CornerLanes corners(int first) const {
    CornerLanes all;
    for (int k = 0; k < 4; ++k) {
      texels(first, k % 2, k / 2, all.x[static_cast<std::size_t>(k)], all.y[static_cast<std::size_t>(k)]);
    }
    return all;
  }

 private:
  HWY_INLINE void texels(int first, int right, int down, V& x, V& y) const {
    block_texels(rows_.data() + down, right, first, x, y);
  }

  std::array<const float*, 5> rows_{};
};

// Weights of four texels at the left (0) or right (1) vertices of 16 sub-cells, by their columns or rows: of the value,
// and of the derivatives that shifted vertices take.
using VertexWeights = std::array<std::array<std::array<float, 16>, 4>, 2>;
constexpr VertexWeights vertex_weights(bool along_rows, CubicWeights (*weights_at)(double)) {
  VertexWeights all{};
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t cell = 0; cell < 16; ++cell) {
      const CubicWeights w = weights_at(0.25 * static_cast<double>((along_rows ? cell % 4 : cell / 4) + side));
      for (std::size_t k = 0; k < 4; ++k) all[side][k][cell] = static_cast<float>(w[k]);
    }
  }
  return all;
}
alignas(64) inline constexpr VertexWeights k_column_weights = vertex_weights(true, catmull_rom);
alignas(64) inline constexpr VertexWeights k_row_weights = vertex_weights(false, catmull_rom);
alignas(64) inline constexpr VertexWeights k_column_slopes = vertex_weights(true, catmull_rom_derivative);
alignas(64) inline constexpr VertexWeights k_row_slopes = vertex_weights(false, catmull_rom_derivative);
alignas(64) inline constexpr VertexWeights k_column_bends = vertex_weights(true, catmull_rom_second_derivative);
alignas(64) inline constexpr VertexWeights k_row_bends = vertex_weights(false, catmull_rom_second_derivative);

// The 4 x 4 sub-cells of one smooth cell, whose patch the 4 x 4 texels from (column, row) of a window on make; where
// `shifted`, with vertices as SurfaceCells shifts them.
class SmoothSubcells {
 public:
  static constexpr float k_size = 0.25F;

  SmoothSubcells(const TexelWindow& texels, int column, int row, bool shifted) : shifted_(shifted) {
    for (int r = 0; r < 4; ++r) rows_[static_cast<std::size_t>(r)] = texels.row(row + r) + std::ptrdiff_t{2} * column;
  }

  [[nodiscard]] HWY_INLINE CornerLanes corners(int first) const {
    const auto at = static_cast<std::size_t>(first);
    CornerLanes all;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      std::array<V, 4>& out = axis == 0 ? all.x : all.y;
      for (std::size_t right = 0; right < 2; ++right) {
        const Lines values = along_rows(axis, k_column_weights[right], at);
        for (std::size_t down = 0; down < 2; ++down) {
          out[2 * down + right] = across_rows(values, k_row_weights[down], at);
        }
        if (!shifted_) continue;
        const V c = hn::Set(Floats(), k_size * k_size / 12);
        const Lines slopes = along_rows(axis, k_column_slopes[right], at);
        const Lines bends = along_rows(axis, k_column_bends[right], at);
        for (std::size_t down = 0; down < 2; ++down) {
          const V curvature =
              hn::Sub(hn::Add(across_rows(bends, k_row_weights[down], at), across_rows(values, k_row_bends[down], at)),
                      across_rows(slopes, k_row_slopes[down], at));
          out[2 * down + right] = hn::NegMulAdd(c, curvature, out[2 * down + right]);
        }
      }
    }
    return all;
  }

 private:
  using Lines = std::array<V, 4>;  // one a row of texels
  using SideWeights = VertexWeights::value_type;

  [[nodiscard]] HWY_INLINE Lines along_rows(std::size_t axis, const SideWeights& weights, std::size_t at) const {
    const Floats d;
    const auto along = [&](std::size_t r) HWY_ATTR {
      const float* row = rows_[r] + axis;
      V sum = hn::Mul(hn::Set(d, row[0]), hn::Load(d, weights[0].data() + at));
      for (std::size_t k = 1; k < 4; ++k) {
        sum = hn::MulAdd(hn::Set(d, row[2 * k]), hn::Load(d, weights[k].data() + at), sum);
      }
      return sum;
    };
    return {along(0), along(1), along(2), along(3)};
  }
  static HWY_INLINE V across_rows(const Lines& lines, const SideWeights& weights, std::size_t at) {
    const Floats d;
    V sum = hn::Mul(lines[0], hn::Load(d, weights[0].data() + at));
    for (std::size_t k = 1; k < 4; ++k) sum = hn::MulAdd(lines[k], hn::Load(d, weights[k].data() + at), sum);
    return sum;
  }

  std::array<const float*, 4> rows_{};
  bool shifted_;
};

// Bounds of the normals of the 16 smooth cells that a window of 7 x 7 texels holds: of each patch's Bezier points.
// Shifted vertices move by c |n_uu + n_vv - n_uv|, c = 1 / 192, which are second differences of those points: at most
// c (12 + 12 + 18) of their range.
class SmoothBounds {
 public:
  SmoothBounds(const TexelWindow& texels, bool shifted) : margin_(shifted ? 42.0F / 192 : 0.0F) {
    for (int r = 0; r < 7; ++r) {
      const float* row = texels.row(r);
      for (std::size_t axis = 0; axis < 2; ++axis) {
        for (std::size_t c = 0; c < 4; ++c) {
          const float* p = row + 2 * c + axis;
          const std::size_t at = 4 * static_cast<std::size_t>(r) + c;
          points_[axis][0][at] = p[2];
          points_[axis][1][at] = p[2] + (p[4] - p[0]) * (1 / 6.0F);
          points_[axis][2][at] = p[4] - (p[6] - p[2]) * (1 / 6.0F);
          points_[axis][3][at] = p[4];
        }
      }
    }
  }

  // Of cells first, first + 1, … along one axis.
  HWY_INLINE void range(int first, std::size_t axis, V& lo, V& hi) const {
    const Floats d;
    const V sixth = hn::Set(d, 1 / 6.0F);
    for (std::size_t h = 0; h < 4; ++h) {
      const float* from = points_[axis][h].data() + first;
      const V p0 = hn::LoadU(d, from);
      const V p1 = hn::LoadU(d, from + 4);
      const V p2 = hn::LoadU(d, from + 8);
      const V p3 = hn::LoadU(d, from + 12);
      const V b1 = hn::MulAdd(hn::Sub(p2, p0), sixth, p1);
      const V b2 = hn::NegMulAdd(hn::Sub(p3, p1), sixth, p2);
      const V least = hn::Min(hn::Min(p1, p2), hn::Min(b1, b2));
      const V most = hn::Max(hn::Max(p1, p2), hn::Max(b1, b2));
      lo = h == 0 ? least : hn::Min(lo, least);
      hi = h == 0 ? most : hn::Max(hi, most);
    }
    const V more = hn::Mul(hn::Sub(hi, lo), hn::Set(d, margin_));
    lo = hn::Sub(lo, more);
    hi = hn::Add(hi, more);
  }

 private:
  // Of Bezier point h along the rows: row by row of texels, four cells each.
  alignas(64) std::array<std::array<std::array<float, 28>, 4>, 2> points_;
  float margin_;
};

}  // namespace
}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
