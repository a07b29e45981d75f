// The seeds of the cells of a 4 x 4 block and what they take of the map, a vector at a time. Built once for each of
// Highway's targets, inside the files that name it and nowhere else.

#if defined(GLINT_MIXTURE_SEEDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_MIXTURE_SEEDS_INL_H_
#undef GLINT_MIXTURE_SEEDS_INL_H_
#else
#define GLINT_MIXTURE_SEEDS_INL_H_
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <hwy/highway.h>

#include "core/math/simd_math-inl.h"
#include "core/pndf/mixture_bounds.h"
#include "core/pndf/query_cells-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

// Texels of the map, row by row.
struct TexelView {
  const float* first;
  std::ptrdiff_t stride;  // floats from one row to the next

  [[nodiscard]] HWY_INLINE const float* row(std::ptrdiff_t r) const { return first + r * stride; }
  [[nodiscard]] HWY_INLINE TexelView from(std::ptrdiff_t column, std::ptrdiff_t row) const {
    return {first + row * stride + 2 * column, stride};
  }
};

// The texels that the cells of a tile take, from the first of them on: in the map or, where they cross its border, in
// a copy.
class TileTexels {
 public:
  TexelView of(const MixtureBounds& bounds, std::int64_t i, std::int64_t j) {
    const NormalMap& map = bounds.map();
    const CellSeeds& seeds = bounds.seeds();
    i -= seeds.before;
    j -= seeds.before;
    const int side = MixtureBounds::k_tile - 1 + seeds.taps;
    if (i >= 0 && j >= 0 && i + side <= map.width() && j + side <= map.height()) {
      return {&map.normals()[static_cast<std::size_t>(j * map.width() + i)].x, std::ptrdiff_t{2} * map.width()};
    }
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column) {
        spare_[static_cast<std::size_t>(k_side) * static_cast<std::size_t>(row) + static_cast<std::size_t>(column)] =
            map.texel(i + column, j + row);
      }
    }
    return {&spare_[0].x, std::ptrdiff_t{2} * k_side};
  }

 private:
  static constexpr int k_side = MixtureBounds::k_tile + 3;
  std::array<glm::vec2, std::size_t{k_side} * k_side> spare_{};
};

// A few cells, and the seeds made of them, by field.
class SeedBuffer {
 public:
  enum Field : std::size_t { x, y, x_u, y_u, x_v, y_v, u, v, k_fields };

  // Empties it for cells with those seeds.
  void begin(const CellSeeds& seeds) {
    seeds_ = &seeds;
    most_cells_ = std::clamp<std::size_t>(k_room / seeds.count, 1, k_cells);
    cells_ = 0;
  }
  [[nodiscard]] bool is_full() const { return cells_ == most_cells_; }

  // A cell that begins at (left, top), with its texels.
  HWY_INLINE void add(const TexelView& texels, float left, float top) {
    texels_[cells_] = texels;
    left_[cells_] = left;
    top_[cells_] = top;
    ++cells_;
  }

  // Makes the seeds of all cells, which are then forgotten; returns the seeds' number.
  HWY_INLINE std::size_t make() {
    if (seeds_->taps == 1) {
      weigh<1>();
    } else {
      weigh<4>();
    }
    sort();
    return std::exchange(cells_, 0) * seeds_->count;
  }
  [[nodiscard]] HWY_INLINE V load(Field field, std::size_t at) const {
    return hn::LoadU(Floats(), fields_[field].data() + at);
  }

 private:
  static constexpr std::size_t k_room = 256;
  static constexpr std::size_t k_cells = 64;
  static constexpr std::size_t k_padded = std::max(k_room, CellSeeds::k_most) + 2 * CellSeeds::k_whole;
  static constexpr std::size_t k_made = CellSeeds::k_quantities * k_padded + k_cells * CellSeeds::k_whole;

  // Sums of texels, all of a cell's quantities in a row.
  template <std::ptrdiff_t taps>
  HWY_INLINE void weigh() {
    const Floats d;
    const std::size_t stride = seeds_->stride;
    const std::size_t cells = cells_;
    for (std::size_t at = 0; at < stride; at += static_cast<std::size_t>(k_lanes)) {
      std::array<V, static_cast<std::size_t>(taps * taps)> weights;
      for (std::size_t tap = 0; tap < weights.size(); ++tap) {
        weights[tap] = hn::LoadU(d, seeds_->weights.data() + tap * stride + at);
      }
      for (std::size_t cell = 0; cell < cells; ++cell) {
        const TexelView texels = texels_[cell];
        std::array<V, 2> s{hn::Zero(d), hn::Zero(d)};
        std::array<V, 2> t{hn::Zero(d), hn::Zero(d)};
#pragma GCC unroll 4
        for (std::ptrdiff_t row = 0; row < taps; ++row) {
          const float* texel = texels.row(row);
          const auto half = static_cast<std::size_t>(row % 2);
#pragma GCC unroll 4
          for (std::ptrdiff_t column = 0; column < taps; ++column) {
            const V weight = weights[static_cast<std::size_t>(row * taps + column)];
            s[half] = hn::MulAdd(hn::Set(d, texel[2 * column]), weight, s[half]);
            t[half] = hn::MulAdd(hn::Set(d, texel[2 * column + 1]), weight, t[half]);
          }
        }
        hn::StoreU(hn::Add(s[0], s[1]), d, made_[0].data() + cell * stride + at);
        hn::StoreU(hn::Add(t[0], t[1]), d, made_[1].data() + cell * stride + at);
      }
    }
  }

  // By field, four seeds at a time: what is written beyond a cell's last is its follower's or nobody's.
  HWY_INLINE void sort() {
    const std::size_t count = seeds_->count;
    if (count <= 4) {
      sort_cells(count, [](auto body) HWY_ATTR { body(std::size_t{0}); });
    } else {
      sort_cells(count, [count](auto body) HWY_ATTR {
        for (std::size_t k = 0; k < count; k += 4) body(k);
      });
    }
  }
  template <class ForFours>
  HWY_INLINE void sort_cells(std::size_t count, ForFours for_fours) {
    const hn::CappedTag<float, 4> d;
    const auto copy_four = [&](const float* from, float* to, auto change) HWY_ATTR {
      for (std::size_t k = 0; k < 4; k += hn::Lanes(d)) hn::StoreU(change(hn::LoadU(d, from + k)), d, to + k);
    };
    const bool curved = seeds_->curved;
    const std::size_t stride = seeds_->stride;
    const std::size_t cells = cells_;
    const float* seed_u = seeds_->u.data();
    const float* seed_v = seeds_->v.data();
    for (std::size_t cell = 0; cell < cells; ++cell) {
      const auto left = hn::Set(d, left_[cell]);
      const auto top = hn::Set(d, top_[cell]);
      for_fours([&](std::size_t k) HWY_ATTR {
        const std::size_t to = cell * count + k;
        const auto same = [](auto values) HWY_ATTR { return values; };
        const auto copy = [&](std::size_t quantity) HWY_ATTR {
          const std::size_t from = cell * stride + quantity * count + k;
          copy_four(made_[0].data() + from, fields_[2 * quantity].data() + to, same);
          copy_four(made_[1].data() + from, fields_[2 * quantity + 1].data() + to, same);
        };
        copy(0);
        if (curved) {
          copy(1);
          copy(2);
        }
        copy_four(seed_u + k, fields_[u].data() + to, [&](auto at) HWY_ATTR { return hn::Add(left, at); });
        copy_four(seed_v + k, fields_[v].data() + to, [&](auto at) HWY_ATTR { return hn::Add(top, at); });
      });
    }
  }

  const CellSeeds* seeds_ = nullptr;
  std::size_t most_cells_ = 0;
  std::size_t cells_ = 0;
  std::array<TexelView, k_cells> texels_{};
  std::array<float, k_cells> left_{};
  std::array<float, k_cells> top_{};
  alignas(64) std::array<std::array<float, k_made>, 2> made_{};
  alignas(64) std::array<std::array<float, k_padded>, k_fields> fields_{};
};

// What the corners of a vector of cells say of their seeds, along s, t, s + t and s - t.
struct CellLanes {
  std::array<V, TileBounds::k_axes> middle;    // of the seeds' means
  std::array<V, TileBounds::k_axes> reach;     // of them to either side
  std::array<V, TileBounds::k_axes> variance;  // sigma_h^2 |J^T e|^2
};

HWY_INLINE std::array<V, TileBounds::k_axes> along_axes(V x, V y) {
  return {x, y, hn::Add(x, y), hn::Sub(x, y)};
}

// Of cells first, first + 1, … of the 4 x 4 whose texels those are.
HWY_INLINE void find_cell_lanes(const CellSeeds& seeds, const TexelView& texels, int first, CellLanes& out) {
  const Floats d;
  if (seeds.taps == 1) {
    V x;
    V y;
    const std::array<const float*, 4> rows{texels.row(0), texels.row(1), texels.row(2), texels.row(3)};
    block_texels(rows.data(), 0, first, x, y);
    out.middle = along_axes(x, y);
    out.reach.fill(hn::Zero(d));
    out.variance.fill(hn::Zero(d));
    return;
  }
  const std::array<const float*, 5> rows{texels.row(1), texels.row(2), texels.row(3), texels.row(4), texels.row(5)};
  std::array<std::array<V, 2>, 4> n;
  for (int k = 0; k < 4; ++k) {
    std::array<V, 2>& corner = n[static_cast<std::size_t>(k)];
    block_texels(rows.data() + k / 2, 1 + k % 2, first, corner[0], corner[1]);
  }
  std::array<V, 2> middle;
  std::array<V, 2> du;
  std::array<V, 2> dv;
  const V quarter = hn::Set(d, 0.25F);
  const V half = hn::Set(d, 0.5F);
  const V from_middle = hn::Set(d, seeds.centroid - 0.5F);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const V falling = hn::Sub(n[3][axis], n[0][axis]);
    const V rising = hn::Sub(n[1][axis], n[2][axis]);
    du[axis] = hn::Mul(half, hn::Add(falling, rising));
    dv[axis] = hn::Mul(half, hn::Sub(falling, rising));
    const V sum = hn::Add(hn::Add(n[0][axis], n[3][axis]), hn::Add(n[1][axis], n[2][axis]));
    middle[axis] = hn::MulAdd(from_middle, falling, hn::Mul(quarter, sum));
  }
  out.middle = along_axes(middle[0], middle[1]);
  const auto along_u = along_axes(du[0], du[1]);
  const auto along_v = along_axes(dv[0], dv[1]);
  const V extent = hn::Set(d, seeds.extent);
  const V squared = hn::Set(d, seeds.curved ? static_cast<float>(seeds.deviation * seeds.deviation) : 0.0F);
  for (std::size_t axis = 0; axis < TileBounds::k_axes; ++axis) {
    const V u = along_u[axis];
    const V v = along_v[axis];
    out.reach[axis] = hn::Mul(extent, hn::Add(hn::Abs(u), hn::Abs(v)));
    out.variance[axis] = hn::Mul(squared, hn::MulAdd(u, u, hn::Mul(v, v)));
  }
}

}  // namespace
}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
