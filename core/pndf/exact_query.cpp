#include "core/pndf/exact_query.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/pndf/query_leaf.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/pndf/exact_query.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/math/simd_math-inl.h"
#include "core/pndf/query_triangles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

// Columns and rows of 16 children.
alignas(64) constexpr std::array<float, 16> k_columns{0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) constexpr std::array<float, 16> k_rows{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

// The rows of one array of a leaf, loaded one by one: what was stored just before in pieces is slow to load as a whole.
class LeafRows {
 public:
  explicit HWY_INLINE LeafRows(const std::array<float, 20>& values) : values_(values.data()) {}

  // Those of cells first, first + 1, …, `more` rows further down.
  [[nodiscard]] HWY_INLINE V lanes(int first, int more) const {
    const float* from = values_ + first + std::ptrdiff_t{4} * more;
#if HWY_MAX_BYTES == 64
    return hn::Combine(Floats(), two(from + 8), two(from));
#elif HWY_MAX_BYTES == 32
    return two(from);
#else
    return hn::LoadU(Floats(), from);
#endif
  }

 private:
#if HWY_MAX_BYTES >= 32
  static HWY_INLINE hn::Vec<hn::FixedTag<float, 8>> two(const float* from) {
    const hn::FixedTag<float, 4> row;
    return hn::Combine(hn::FixedTag<float, 8>(), hn::LoadU(row, from + 4), hn::LoadU(row, from));
  }
#endif
  const float* values_;
};

class Query {
 public:
  Query(const QueryFrame& frame, glm::dvec2 s, QueryScratch::Arrays& arrays)
      : frame_(frame), arrays_(arrays), squared_cut_(frame.cut * frame.cut) {
    normal_ = {{static_cast<float>(s.x), static_cast<float>(s.y)}, {}};
    normal_.low = {static_cast<float>(s.x - normal_.high[0]), static_cast<float>(s.y - normal_.high[1])};
    axes_ = {static_cast<float>(s.x), static_cast<float>(s.y), static_cast<float>(s.x + s.y),
             static_cast<float>(s.x - s.y)};
  }

  std::optional<double> density() {
    arrays_.leaf_count = 0;
    arrays_.triangle_count = 0;
    for (const QueryGroup& group : frame_.groups) search_group(group);
    sum_found();
    return refused_ ? std::nullopt : std::optional(total_);
  }

 private:
  // So that memory stays bounded, however many triangles matter.
  static constexpr std::size_t k_most_triangles = 4096;

  void sum_found() {
    if (!refused_) {
      const std::optional<double> sum = sum_triangles(frame_, normal_, arrays_);
      refused_ = !sum;
      total_ += sum.value_or(0);
    }
    arrays_.leaf_count = 0;
    arrays_.triangle_count = 0;
  }

  // Calls body(child) for the children of a node that can hold something within the cut. `size` is a child's, texels.
  template <class Body>
  HWY_INLINE void for_near_children(const NormalNode& node, float left, float top, float size, Body body) const {
    const Floats d;
    for (int k = 0; k < 16; k += k_lanes) {
      const auto at = static_cast<std::size_t>(k);
      const V x = hn::MulAdd(hn::LoadU(d, k_columns.data() + at), hn::Set(d, size), hn::Set(d, left));
      const V y = hn::MulAdd(hn::LoadU(d, k_rows.data() + at), hn::Set(d, size), hn::Set(d, top));
      const V room = hn::Sub(hn::Set(d, squared_cut_), squared_offset(x, y, size));
      std::array<V, 4> gaps{gap(node, 0, at), gap(node, 1, at), gap(node, 2, at), gap(node, 3, at)};
      const V straight = hn::MulAdd(gaps[0], gaps[0], hn::Mul(gaps[1], gaps[1]));
      const V diagonal = hn::Mul(hn::Set(d, 0.5F), hn::MulAdd(gaps[2], gaps[2], hn::Mul(gaps[3], gaps[3])));
      std::uint32_t near = mask_bits(hn::Lt(hn::Max(straight, diagonal), room));
      while (near != 0) {
        body(k + __builtin_ctz(near));
        near &= near - 1;
      }
    }
  }

  // Squared distance of the box [x, x + size] x [y, y + size] from the footprint's centre, in deviations, at least.
  HWY_INLINE V squared_offset(V x, V y, float size) const {
    const Floats d;
    const V y1 = hn::Add(y, hn::Set(d, size));
    const V lean = hn::Mul(hn::Set(d, frame_.w12), y);
    const V lean1 = hn::Mul(hn::Set(d, frame_.w12), y1);
    const V w11 = hn::Set(d, frame_.w11);
    const V from = hn::MulAdd(w11, x, hn::Min(lean, lean1));
    const V to = hn::MulAdd(w11, hn::Add(x, hn::Set(d, size)), hn::Max(lean, lean1));
    const V w22 = hn::Set(d, frame_.w22);
    const V dx = hn::Max(hn::Zero(d), hn::Max(from, hn::Neg(to)));
    const V dy = hn::Max(hn::Zero(d), hn::Max(hn::Mul(w22, y), hn::Neg(hn::Mul(w22, y1))));
    return hn::MulAdd(dx, dx, hn::Mul(dy, dy));
  }

  // Of the query from the children's bounds along one axis, in deviations.
  HWY_INLINE V gap(const NormalNode& node, std::size_t axis, std::size_t at) const {
    const Floats d;
    const hn::RebindToSigned<Floats> wide;
    const hn::Rebind<std::int16_t, Floats> narrow;
    const V step = hn::Set(d, NormalBounds::k_step);
    const V lo = hn::ConvertTo(d, hn::PromoteTo(wide, hn::LoadU(narrow, node.lo[axis].data() + at)));
    const V hi = hn::ConvertTo(d, hn::PromoteTo(wide, hn::LoadU(narrow, node.hi[axis].data() + at)));
    const V q = hn::Set(d, axes_[axis]);
    const V outside = hn::Max(hn::MulSub(lo, step, q), hn::NegMulAdd(hi, step, q));
    return hn::Mul(hn::Max(outside, hn::Zero(d)), hn::Set(d, frame_.inverse_roughness));
  }

  void search_group(const QueryGroup& group) {
    for_near_children(*group.bounds, group.left, group.top, NormalBounds::k_tile, [&](int child) HWY_ATTR {
      const int column = child % 4;
      const int row = child / 4;
      search_tile(group.tile_column + column, group.tile_row + row,
                  group.left + static_cast<float>(column * NormalBounds::k_tile),
                  group.top + static_cast<float>(row * NormalBounds::k_tile));
    });
  }

  void search_tile(int column, int row, float left, float top) {
    for_near_children(frame_.bounds->tile(column, row), left, top, NormalBounds::k_block, [&](int child) HWY_ATTR {
      const int x = child % 4 * NormalBounds::k_block;
      const int y = child / 4 * NormalBounds::k_block;
      search_block(column * NormalBounds::k_tile + x, row * NormalBounds::k_tile + y, left + static_cast<float>(x),
                   top + static_cast<float>(y));
    });
  }

  void search_block(int column, int row, float left, float top) {
    if (arrays_.triangle_count > k_most_triangles) sum_found();
    if (refused_) return;
    const SurfaceCells& cells = *frame_.cells;
    const int columns = std::min<int>(4, static_cast<int>(cells.axis_u().count) - column);
    const int rows = std::min<int>(4, static_cast<int>(cells.axis_v().count) - row);
    const CellIndex first{cells.axis_u().first + column, cells.axis_v().first + row};
    if (cells.surface().interpolation() == Interpolation::linear) {
      QueryLeaf& leaf = arrays_.add_leaf();
      fill_linear_leaf(cells.surface().map(), first, leaf);
      leaf.left = left;
      leaf.top = top;
      leaf.size = 1;
      list_triangles(columns, rows);
      return;
    }
    std::array<std::array<glm::vec2, 7>, 7> texels;
    load_smooth_block(cells.surface().map(), first, texels);
    std::uint32_t near = near_smooth_cells(texels, left, top);
    for (; near != 0; near &= near - 1) {
      const int x = __builtin_ctz(near) % 4;
      const int y = __builtin_ctz(near) / 4;
      if (x >= columns || y >= rows) continue;
      QueryLeaf& leaf = arrays_.add_leaf();
      fill_smooth_leaf(texels, x, y, leaf);
      leaf.left = left + static_cast<float>(x);
      leaf.top = top + static_cast<float>(y);
      leaf.size = 0.25F;
      list_triangles(4, 4);
    }
  }

  // Which of the 16 cells of a block of the smooth surface can matter.
  HWY_INLINE std::uint32_t near_smooth_cells(const std::array<std::array<glm::vec2, 7>, 7>& texels, float left,
                                             float top) const {
    const Floats d;
    CellBoxes boxes;
    bound_smooth_cells(texels, boxes);
    std::uint32_t near = 0;
    for (int k = 0; k < 16; k += k_lanes) {
      const auto at = static_cast<std::size_t>(k);
      const V x = hn::Add(hn::LoadU(d, k_columns.data() + at), hn::Set(d, left));
      const V y = hn::Add(hn::LoadU(d, k_rows.data() + at), hn::Set(d, top));
      const auto outside = [&](const auto& lo, const auto& hi, float q) HWY_ATTR {
        const V query = hn::Set(d, q);
        const V gap =
            hn::Max(hn::Sub(hn::LoadU(d, lo.data() + at), query), hn::Sub(query, hn::LoadU(d, hi.data() + at)));
        return hn::Mul(hn::Max(gap, hn::Zero(d)), hn::Set(d, frame_.inverse_roughness));
      };
      const V gap_x = outside(boxes.x_lo, boxes.x_hi, axes_[0]);
      const V gap_y = outside(boxes.y_lo, boxes.y_hi, axes_[1]);
      const V squared = hn::MulAdd(gap_x, gap_x, hn::MulAdd(gap_y, gap_y, squared_offset(x, y, 1)));
      near |= mask_bits(hn::Lt(squared, hn::Set(d, squared_cut_))) << k;
    }
    return near;
  }

  // Those of the last leaf's 32 triangles that can matter.
  void list_triangles(int columns, int rows) {
    const Floats d;
    const QueryLeaf& leaf = arrays_.leaves[arrays_.leaf_count - 1];
    const LeafRows x0(leaf.x0);
    const LeafRows x1(leaf.x1);
    const LeafRows y0(leaf.y0);
    const LeafRows y1(leaf.y1);
    const auto base = static_cast<std::int32_t>(arrays_.leaf_count - 1) * 32;
    const bool whole = columns == 4 && rows == 4;
    for (int k = 0; k < 16; k += k_lanes) {
      const auto at = static_cast<std::size_t>(k);
      const V column = hn::LoadU(d, k_columns.data() + at);
      const V row = hn::LoadU(d, k_rows.data() + at);
      const V x = hn::MulAdd(column, hn::Set(d, leaf.size), hn::Set(d, leaf.left));
      const V y = hn::MulAdd(row, hn::Set(d, leaf.size), hn::Set(d, leaf.top));
      const V room = hn::Sub(hn::Set(d, squared_cut_), squared_offset(x, y, leaf.size));
      const auto outside = [&](V a, V b, V c, float q) HWY_ATTR {
        const V query = hn::Set(d, q);
        const V gap = hn::Max(hn::Sub(hn::Min(a, hn::Min(b, c)), query), hn::Sub(query, hn::Max(a, hn::Max(b, c))));
        return hn::Mul(hn::Max(gap, hn::Zero(d)), hn::Set(d, frame_.inverse_roughness));
      };
      const V right_x = x1.lanes(k, 0);
      const V right_y = y1.lanes(k, 0);
      const V below_x = x0.lanes(k, 1);
      const V below_y = y0.lanes(k, 1);
      const V upper_x = outside(x0.lanes(k, 0), right_x, below_x, axes_[0]);
      const V upper_y = outside(y0.lanes(k, 0), right_y, below_y, axes_[1]);
      const V lower_x = outside(x1.lanes(k, 1), right_x, below_x, axes_[0]);
      const V lower_y = outside(y1.lanes(k, 1), right_y, below_y, axes_[1]);
      auto upper = hn::Lt(hn::MulAdd(upper_x, upper_x, hn::Mul(upper_y, upper_y)), room);
      auto lower = hn::Lt(hn::MulAdd(lower_x, lower_x, hn::Mul(lower_y, lower_y)), room);
      if (!whole) {
        const auto there = hn::And(hn::Lt(column, hn::Set(d, static_cast<float>(columns))),
                                   hn::Lt(row, hn::Set(d, static_cast<float>(rows))));
        upper = hn::And(upper, there);
        lower = hn::And(lower, there);
      }
      push(upper, base + k);
      push(lower, base + 16 + k);
    }
  }

  // Appends first + lane for the lanes of the mask.
  HWY_INLINE void push(hn::Mask<Floats> mask, std::int32_t first) {
    const Floats d;
    const hn::RebindToSigned<Floats> di;
    if (arrays_.triangles.size() < arrays_.triangle_count + static_cast<std::size_t>(k_lanes)) {
      arrays_.triangles.resize(2 * arrays_.triangles.size() + static_cast<std::size_t>(k_lanes));
    }
    hn::StoreU(hn::Compress(hn::Iota(di, first), hn::RebindMask(di, mask)), di,
               arrays_.triangles.data() + arrays_.triangle_count);
    arrays_.triangle_count += hn::CountTrue(d, mask);
  }

  const QueryFrame& frame_;
  QueryScratch::Arrays& arrays_;
  float squared_cut_;
  double total_ = 0;
  bool refused_ = false;  // a triangle was too long
  QueryNormal normal_{};
  std::array<float, 4> axes_{};
};

}  // namespace

std::optional<double> query(const QueryFrame& frame, glm::dvec2 s, QueryScratch& scratch) {
  return Query(frame, s, scratch.arrays()).density();
}

}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glint {

HWY_EXPORT(query);

QueryScratch::QueryScratch() : arrays_(std::make_unique<Arrays>()) {}
QueryScratch::~QueryScratch() = default;

std::optional<double> exact_query(const QueryFrame& frame, glm::dvec2 s, QueryScratch& scratch) {
  return HWY_DYNAMIC_DISPATCH(query)(frame, s, scratch);
}

}  // namespace glint

#endif  // once
