#include "core/pndf/exact_query.h"

#include <array>
#include <cassert>
#include <cstdint>
#include <span>

#include "core/pndf/query_scratch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/pndf/exact_query.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/math/simd_math-inl.h"
#include "core/pndf/query_cells-inl.h"
#include "core/pndf/query_triangles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

// One bit a child, for each normal of the batch.
using NearBits = std::array<std::uint32_t, k_query_batch>;

// A batch of normals descends the pyramid together: nodes and cells are loaded once, and each normal lists the
// triangles that it finds.
class Query {
 public:
  Query(const QueryFrame& frame, std::span<const glm::dvec2> s, QueryScratch::Arrays& arrays)
      : frame_(frame), arrays_(arrays), squared_cut_(frame.cut * frame.cut), count_(s.size()) {
    const float k = frame.inverse_roughness;
    normal_room_ = 1 / (k * k);
    for (std::size_t q = 0; q < count_; ++q) {
      states_[q].normal = QueryNormal(s[q]);
      states_[q].axes = {static_cast<float>(s[q].x), static_cast<float>(s[q].y), static_cast<float>(s[q].x + s[q].y),
                         static_cast<float>(s[q].x - s[q].y)};
      arrays_.triangles[q].count = 0;
    }
  }

  void densities(std::span<double> out) {
    const std::uint32_t all = (1U << count_) - 1;
    for (const QueryGroup& group : frame_.groups) search_group(group, all);
    for (std::size_t q = 0; q < count_; ++q) {
      sum_found(q);
      out[q] = states_[q].total;
    }
  }

 private:
  // So that memory stays bounded, however many triangles matter.
  static constexpr std::size_t k_most_triangles = 4096;

  struct State {
    QueryNormal normal;
    std::array<float, 4> axes{};
    double total = 0;
  };

  void sum_found(std::size_t q) {
    State& state = states_[q];
    state.total += TriangleSum(frame_, cell_size(), state.normal, arrays_).sum(arrays_.triangles[q]);
    arrays_.triangles[q].count = 0;
  }

  [[nodiscard]] float cell_size() const { return is_linear() ? LinearCells::k_size : SmoothSubcells::k_size; }
  [[nodiscard]] bool is_linear() const { return frame_.cells->surface().interpolation() == Interpolation::linear; }

  // Calls body(bit) for the bits that are set.
  template <class Body>
  static HWY_INLINE void for_bits(std::uint32_t bits, Body body) {
    for (; bits != 0; bits &= bits - 1) body(static_cast<int>(__builtin_ctz(bits)));
  }

  // Calls body(child, bits of the normals that it is near to) for each child that is near to any.
  template <class Body>
  static HWY_INLINE void for_near(const NearBits& near, std::uint32_t active, Body body) {
    if ((active & (active - 1)) == 0) {  // a single normal
      for_bits(near[static_cast<std::size_t>(__builtin_ctz(active))], [&](int child) HWY_ATTR { body(child, active); });
      return;
    }
    std::uint32_t any = 0;
    for_bits(active, [&](int q) { any |= near[static_cast<std::size_t>(q)]; });
    for_bits(any, [&](int child) HWY_ATTR {
      std::uint32_t of_child = 0;
      for_bits(active, [&](int q) { of_child |= (near[static_cast<std::size_t>(q)] >> child & 1U) << q; });
      body(child, of_child);
    });
  }

  // What distances in the plane leave of the squared cut for cells first, first + 1, … of 4 x 4, in deviations.
  HWY_INLINE V room(int first, float left, float top, float size) const {
    const Floats d;
    const auto at = static_cast<std::size_t>(first);
    const V x = hn::MulAdd(hn::Load(d, k_columns.data() + at), hn::Set(d, size), hn::Set(d, left));
    const V y = hn::MulAdd(hn::Load(d, k_rows.data() + at), hn::Set(d, size), hn::Set(d, top));
    const V y1 = hn::Add(y, hn::Set(d, size));
    const V w12 = hn::Set(d, frame_.w12);
    const V lean = hn::Mul(w12, y);
    const V lean1 = hn::Mul(w12, y1);
    const V w11 = hn::Set(d, frame_.w11);
    const V from = hn::MulAdd(w11, x, hn::Min(lean, lean1));
    const V to = hn::MulAdd(w11, hn::Add(x, hn::Set(d, size)), hn::Max(lean, lean1));
    const V w22 = hn::Set(d, frame_.w22);
    const V dx = hn::Max(hn::Zero(d), hn::Max(from, hn::Neg(to)));
    const V dy = hn::Max(hn::Zero(d), hn::Max(hn::Mul(w22, y), hn::Neg(hn::Mul(w22, y1))));
    return hn::NegMulAdd(dx, dx, hn::NegMulAdd(dy, dy, hn::Set(d, squared_cut_)));
  }

  // Calls body(child, normals) for the children of a node that can hold something within the cut. `size` is a child's,
  // texels.
  template <class Body>
  HWY_INLINE void for_near_children(const NormalNode& node, float left, float top, float size, std::uint32_t active,
                                    Body body) const {
    const Floats d;
    NearBits near{};
    for (int k = 0; k < 16; k += k_lanes) {
      const V space = hn::Mul(room(k, left, top, size), hn::Set(d, normal_room_));
      for_bits(active, [&](int q) HWY_ATTR {
        const std::array<float, 4>& axes = states_[static_cast<std::size_t>(q)].axes;
        const auto gap = [&](std::size_t axis) HWY_ATTR { return node_gap(node, axis, k, axes[axis]); };
        const V straight = sum_of_squares(gap(0), gap(1));
        const V diagonal = hn::Mul(hn::Set(d, 0.5F), sum_of_squares(gap(2), gap(3)));
        near[static_cast<std::size_t>(q)] |= mask_bits(hn::Lt(hn::Max(straight, diagonal), space)) << k;
      });
    }
    for_near(near, active, body);
  }

  static HWY_INLINE V sum_of_squares(V a, V b) { return hn::MulAdd(a, a, hn::Mul(b, b)); }

  // Of the query from the children's bounds along one axis.
  static HWY_INLINE V node_gap(const NormalNode& node, std::size_t axis, int first, float query) {
    const Floats d;
    const hn::RebindToSigned<Floats> wide;
    const hn::Rebind<std::int16_t, Floats> narrow;
    const V step = hn::Set(d, NormalBounds::k_step);
    const V lo = hn::ConvertTo(d, hn::PromoteTo(wide, hn::LoadU(narrow, node.lo[axis].data() + first)));
    const V hi = hn::ConvertTo(d, hn::PromoteTo(wide, hn::LoadU(narrow, node.hi[axis].data() + first)));
    const V q = hn::Set(d, query);
    return hn::Max(hn::Max(hn::MulSub(lo, step, q), hn::NegMulAdd(hi, step, q)), hn::Zero(d));
  }

  void search_group(const QueryGroup& group, std::uint32_t active) {
    for_near_children(*group.bounds, group.left, group.top, NormalBounds::k_tile, active,
                      [&](int child, std::uint32_t normals) HWY_ATTR {
                        const int column = child % 4;
                        const int row = child / 4;
                        search_tile(group.tile_column + column, group.tile_row + row,
                                    group.left + static_cast<float>(column * NormalBounds::k_tile),
                                    group.top + static_cast<float>(row * NormalBounds::k_tile), normals);
                      });
  }

  void search_tile(int column, int row, float left, float top, std::uint32_t active) {
    for_near_children(frame_.bounds->tile(column, row), left, top, NormalBounds::k_block, active,
                      [&](int child, std::uint32_t normals) HWY_ATTR {
                        const int x = child % 4 * NormalBounds::k_block;
                        const int y = child / 4 * NormalBounds::k_block;
                        search_block(column * NormalBounds::k_tile + x, row * NormalBounds::k_tile + y,
                                     left + static_cast<float>(x), top + static_cast<float>(y), normals);
                      });
  }

  // A block of 4 x 4 cells, fewer at the end of a map that does not divide by 4.
  void search_block(int column, int row, float left, float top, std::uint32_t active) {
    const SurfaceCells& cells = *frame_.cells;
    const NormalMap& map = cells.surface().map();
    const std::int64_t i = cells.axis_u().first + column;
    const std::int64_t j = cells.axis_v().first + row;
    const std::uint32_t there =
        cells_there(static_cast<int>(cells.axis_u().count) - column, static_cast<int>(cells.axis_v().count) - row);
    if (is_linear()) {
      const TexelWindow texels(map, i, j, 5, 5);
      list_triangles(LinearCells(texels), there, left, top, active);
      return;
    }
    const TexelWindow texels(map, i - 1, j - 1, 7, 7);
    NearBits near{};
    find_near_patches(SmoothBounds(texels, cells.vertex_shift()), left, top, active, near);
    for_bits(active, [&](int q) { near[static_cast<std::size_t>(q)] &= there; });
    for_near(near, active, [&](int cell, std::uint32_t normals) HWY_ATTR {
      const int x = cell % 4;
      const int y = cell / 4;
      list_triangles(SmoothSubcells(texels, x, y, cells.vertex_shift()), 0xFFFF, left + static_cast<float>(x),
                     top + static_cast<float>(y), normals);
    });
  }

  static std::uint32_t cells_there(int columns, int rows) {
    if (columns >= 4 && rows >= 4) return 0xFFFF;
    std::uint32_t bits = 0;
    for (int k = 0; k < 16; ++k) bits |= (k % 4 < columns && k / 4 < rows ? 1U : 0U) << k;
    return bits;
  }

  HWY_INLINE void find_near_patches(const SmoothBounds& bounds, float left, float top, std::uint32_t active,
                                    NearBits& near) const {
    const Floats d;
    for (int k = 0; k < 16; k += k_lanes) {
      const V space = hn::Mul(room(k, left, top, 1), hn::Set(d, normal_room_));
      std::array<V, 2> lo;
      std::array<V, 2> hi;
      for (std::size_t axis = 0; axis < 2; ++axis) bounds.range(k, axis, lo[axis], hi[axis]);
      for_bits(active, [&](int q) HWY_ATTR {
        const std::array<float, 4>& axes = states_[static_cast<std::size_t>(q)].axes;
        const auto gap = [&](std::size_t axis) HWY_ATTR {
          const V query = hn::Set(d, axes[axis]);
          return hn::Max(hn::Max(hn::Sub(lo[axis], query), hn::Sub(query, hi[axis])), hn::Zero(d));
        };
        near[static_cast<std::size_t>(q)] |= mask_bits(hn::Lt(sum_of_squares(gap(0), gap(1)), space)) << k;
      });
    }
  }

  // Those triangles of 4 x 4 cells that can matter, of the cells whose bits are set.
  template <class Cells>
  HWY_INLINE void list_triangles(const Cells& cells, std::uint32_t there, float left, float top, std::uint32_t active) {
    const Floats d;
    const V size = hn::Set(d, Cells::k_size);
    for (int k = 0; k < 16; k += k_lanes) {
      const CornerLanes corners = cells.corners(k);
      const V space = hn::Mul(room(k, left, top, Cells::k_size), hn::Set(d, normal_room_));
      const V x = hn::MulAdd(hn::Load(d, k_columns.data() + k), size, hn::Set(d, left));
      const V y = hn::MulAdd(hn::Load(d, k_rows.data() + k), size, hn::Set(d, top));
      for_bits(active, [&](int q) HWY_ATTR {
        const QueryNormal& normal = states_[static_cast<std::size_t>(q)].normal;
        std::array<V, 4> s;
        std::array<V, 4> t;
        for (std::size_t c = 0; c < 4; ++c) {
          s[c] = hn::Sub(corners.x[c], hn::Set(d, normal.high[0]));
          t[c] = hn::Sub(corners.y[c], hn::Set(d, normal.high[1]));
        }
        const auto is_near = [&](std::size_t corner) HWY_ATTR {
          return hn::Lt(sum_of_squares(gap(s[corner], s[1], s[2]), gap(t[corner], t[1], t[2])), space);
        };
        const std::uint32_t bits = there >> k;
        TriangleList& list = arrays_.triangles[static_cast<std::size_t>(q)];
        push(is_near(0), bits, {x, y, s[0], t[0], s[1], t[1], s[2], t[2]}, list);
        push(is_near(3), bits,
             {hn::Neg(hn::Add(x, size)), hn::Neg(hn::Add(y, size)), s[3], t[3], s[2], t[2], s[1], t[1]}, list);
        if (list.count > k_most_triangles) sum_found(static_cast<std::size_t>(q));
      });
    }
  }

  // Of 0 from the range of three.
  static HWY_INLINE V gap(V a, V b, V c) {
    const V lo = hn::Min(a, hn::Min(b, c));
    const V hi = hn::Max(a, hn::Max(b, c));
    return hn::Max(hn::Max(lo, hn::Neg(hi)), hn::Zero(Floats()));
  }

  // Appends the lanes whose bits are set in both.
  using TriangleFields = std::array<V, TriangleList::k_fields>;
  static HWY_INLINE void push(hn::Mask<Floats> near, std::uint32_t there, const TriangleFields& of,
                              TriangleList& list) {
    const Floats d;
    if (there != 0xFFFF) near = hn::And(near, mask_of_bits(there));
    if (hn::AllFalse(d, near)) return;
    list.reserve(static_cast<std::size_t>(k_lanes));
    append(of, near, list);
  }

  const QueryFrame& frame_;
  QueryScratch::Arrays& arrays_;
  float squared_cut_;
  float normal_room_;  // squared roughness
  std::size_t count_;
  std::array<State, k_query_batch> states_{};
};

}  // namespace

void query(const QueryFrame& frame, std::span<const glm::dvec2> s, QueryScratch& scratch, std::span<double> out) {
  Query(frame, s, scratch.arrays()).densities(out);
}

}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glint {

HWY_EXPORT(query);

QueryScratch::QueryScratch() : arrays_(std::make_unique<Arrays>()) {}
QueryScratch::~QueryScratch() = default;

void exact_query(const QueryFrame& frame, std::span<const glm::dvec2> s, QueryScratch& scratch, std::span<double> out) {
  assert(!s.empty() && s.size() <= k_query_batch && out.size() >= s.size());
  HWY_DYNAMIC_DISPATCH(query)(frame, s, scratch, out);
}

}  // namespace glint

#endif  // once
