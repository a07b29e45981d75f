#include "core/pndf/mixture_search.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/pndf/mixture_search.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/math/simd_math-inl.h"
#include "core/pndf/mixture_seeds-inl.h"

// What is passed over cannot matter. An element with offset o counts while d_u^2 + d_s^2 < R^2, with d_u^2 = o^T V^-1 o
// and d_s its distance in deviations of C = sigma_r^2 I + J Sigma_e J^T from its mean m = s_i - J K o. For any
// direction e of normals
//   d_s >= |e.(s - m)| / sqrt(e^T C e) >= (|e.(s - s_i)| - |J^T e| |K o|) / sqrt(sigma_r^2 + sigma_h^2 |J^T e|^2)
// since Sigma_e <= sigma_h^2 I. With |K o| = sigma_h^2 |V^-1 o| <= sigma_h rho d_u, rho = sigma_h / sqrt(the lesser
// eigenvalue of V) <= 1, the subtrahend is at most rho d_u, whatever J is. So with the gap g = |e.(s - s_i)| / the
// largest deviation, as bounds hold it,
//   g <= d_s + rho d_u, hence g^2 <= (1 + rho) (d_s^2 + rho d_u^2)
// by Cauchy-Schwarz, and an element counts only where g^2 < (1 + rho) (R^2 - (1 - rho) d_u^2) and d_u < R. Both d_u and
// g are bounded from below: d_u over the cells' squares, which hold their seeds; g by the range of all s_i of a block,
// corrected as they are, and of one cell by what its corners guess of middle, reach and deviation and the most by which
// any element of the block exceeds that. Ranges come from the very elements that queries make, so neither overshoot nor
// correction nor curvature can leave them; they and R are widened by what rounding can do.

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

constexpr float k_slack = 1.0001F;  // on R^2: whitening may lose 7e-5 deviations

struct Tile {
  const TileBounds* bounds = nullptr;
  TexelView texels{};
  std::int64_t column = 0;  // of its first cell, from the axis' first
  std::int64_t row = 0;
  float left = 0;  // offset of where it begins from the footprint's centre
  float top = 0;
  bool is_whole = false;  // all cells have seeds
};

// Tiles, blocks by 16 tile + child and cells by 16 block + child: searched breadth first, almost without branches.
struct Lists {
  static constexpr std::size_t k_tiles = 16;
  static constexpr std::size_t k_cells = 256;
  std::array<Tile, k_tiles> tile{};
  std::array<TileTexels, k_tiles> spare{};
  std::array<std::int32_t, 16 * k_tiles + 16> block{};
  std::array<std::int32_t, k_cells + 32> cell{};
  std::size_t tiles = 0;
  std::size_t blocks = 0;
  std::size_t cells = 0;
};

// One query.
class Search {
 public:
  Search(const MixtureSearch& frame, glm::dvec2 s, Lists& lists, SeedBuffer& buffer)
      : frame_(frame),
        bounds_(*frame.bounds),
        u_(bounds_.axis_u()),
        v_(bounds_.axis_v()),
        lists_(lists),
        buffer_(buffer),
        axes_{static_cast<float>(s.x), static_cast<float>(s.y), static_cast<float>(s.x + s.y),
              static_cast<float>(s.x - s.y)},
        squared_cut_(static_cast<float>(frame.cut * frame.cut)),
        room_(squared_cut_ * k_slack * (1 + frame.pull)),
        room_slope_((1 - frame.pull) * (1 + frame.pull)) {}

  double density() {
    buffer_.begin(bounds_.seeds());
    const double reach = frame_.window.reach_y(frame_.cut);
    for_tiles(v_, {-reach - frame_.first.y, reach - frame_.first.y}, [&](std::int64_t b, std::int64_t row) HWY_ATTR {
      const double top = static_cast<double>(row) + frame_.first.y;
      const auto columns = frame_.window.columns({top, top + MixtureBounds::k_tile}, frame_.cut);
      if (!columns) return;
      for_tiles(u_, {columns->lo - frame_.first.x, columns->hi - frame_.first.x},
                [&](std::int64_t a, std::int64_t column)
                    HWY_ATTR { search_tile(a, b, static_cast<double>(column) + frame_.first.x, top); });
    });
    search_blocks();
    return total_;
  }

  // As measured, in elements prepared in that time.
  [[nodiscard]] double spent() const {
    return 8 + 1.2 * static_cast<double>(tiles_) + 60 * static_cast<double>(copies_) +
           1.7 * static_cast<double>(blocks_) + 0.18 * static_cast<double>(cells_ * bounds_.seeds().count);
  }

 private:
  // Calls body(tile, its first cell) for those that meet a range of cells, in every period.
  template <class Body>
  void for_tiles(const MixtureBounds::Axis& axis, Interval cells, Body body) const {
    const bool repeats = bounds_.map().wrap() == Wrap::repeat;
    const auto count = static_cast<double>(axis.count);
    const auto first = static_cast<double>(axis.first);
    const double first_period = repeats ? std::floor((cells.lo - first) / count) : 0;
    const double last_period = repeats ? std::floor((cells.hi - first) / count) : 0;
    for (double period = first_period; period <= last_period; ++period) {
      const double begin = first + period * count;
      const double lo = std::max(cells.lo - begin, 0.0);
      const double hi = std::min(cells.hi - begin, count - 1);
      const auto origin = static_cast<std::int64_t>(begin);
      for (auto tile = static_cast<std::int64_t>(lo / MixtureBounds::k_tile);
           static_cast<double>(tile * MixtureBounds::k_tile) <= hi; ++tile) {
        body(tile, origin + tile * MixtureBounds::k_tile);
      }
    }
  }

  // The least squared distance in the plane of children first, first + 1, … of 4 x 4, in deviations.
  HWY_INLINE V squared_distance(int first, float left, float top, float size) const {
    const Floats d;
    const auto at = static_cast<std::size_t>(first);
    const V x = hn::MulAdd(hn::Load(d, k_columns.data() + at), hn::Set(d, size), hn::Set(d, left));
    const V y = hn::MulAdd(hn::Load(d, k_rows.data() + at), hn::Set(d, size), hn::Set(d, top));
    const V y1 = hn::Add(y, hn::Set(d, size));
    const V lean = hn::Mul(hn::Set(d, frame_.w12), y);
    const V lean1 = hn::Mul(hn::Set(d, frame_.w12), y1);
    const V w11 = hn::Set(d, frame_.w11);
    const V w22 = hn::Set(d, frame_.w22);
    const V from = hn::MulAdd(w11, x, hn::Min(lean, lean1));
    const V to = hn::MulAdd(w11, hn::Add(x, hn::Set(d, size)), hn::Max(lean, lean1));
    const V dx = hn::Max(hn::Zero(d), hn::Max(from, hn::Neg(to)));
    const V dy = hn::Max(hn::Zero(d), hn::Max(hn::Mul(w22, y), hn::Neg(hn::Mul(w22, y1))));
    return hn::MulAdd(dx, dx, hn::Mul(dy, dy));
  }

  // What squared gaps of children have to be below, in deviations: (1 + rho) (R^2 - (1 - rho) d_u^2).
  HWY_INLINE V room(V squared_distance) const {
    const Floats d;
    return hn::NegMulAdd(hn::Set(d, room_slope_), squared_distance, hn::Set(d, room_));
  }
  HWY_INLINE hn::Mask<Floats> in_reach(V squared_distance) const {
    return hn::Lt(squared_distance, hn::Set(Floats(), squared_cut_ * k_slack));
  }

  void search_tile(std::int64_t a, std::int64_t b, double left, double top) {
    const Floats d;
    const hn::RebindToSigned<Floats> di;
    if (lists_.tiles == Lists::k_tiles) search_blocks();
    const auto slot = static_cast<std::int32_t>(lists_.tiles++);
    Tile& tile = lists_.tile[static_cast<std::size_t>(slot)];
    tile.bounds = &bounds_.tile(a, b);
    tile.column = a * MixtureBounds::k_tile;
    tile.row = b * MixtureBounds::k_tile;
    tile.texels = lists_.spare[static_cast<std::size_t>(slot)].of(bounds_, u_.first + tile.column, v_.first + tile.row);
    copies_ += tile.texels.stride != std::ptrdiff_t{2} * bounds_.map().width() ? 1U : 0U;
    tile.left = static_cast<float>(left);
    tile.top = static_cast<float>(top);
    tile.is_whole = bounds_.seeds().every == 1 && tile.column + MixtureBounds::k_tile <= u_.count &&
                    tile.row + MixtureBounds::k_tile <= v_.count;
    for (int k = 0; k < 16; k += k_lanes) {
      V gap = hn::Zero(d);
      for (std::size_t axis = 0; axis < TileBounds::k_axes; ++axis) {
        const auto load = [&](const TileBounds::Blocks& of) HWY_ATTR { return hn::Load(d, of[axis].data() + k); };
        const V s = hn::Set(d, axes_[axis]);
        const V away = hn::Max(hn::Sub(load(tile.bounds->lo), s), hn::Sub(s, load(tile.bounds->hi)));
        gap = hn::Max(gap, hn::Mul(away, load(tile.bounds->inverse_deviation)));
      }
      const V squared = squared_distance(k, tile.left, tile.top, MixtureBounds::k_block);
      const auto near = hn::And(in_reach(squared), hn::Lt(hn::Mul(gap, gap), room(squared)));
      lists_.blocks += append(hn::Iota(di, slot * 16 + k), near, lists_.block.data() + lists_.blocks);
    }
  }

  // Those lanes at `to`; returns their number.
  static HWY_INLINE std::size_t append(hn::Vec<hn::RebindToSigned<Floats>> ids, hn::Mask<Floats> which,
                                       std::int32_t* to) {
    const Floats d;
    const hn::RebindToSigned<Floats> di;
    hn::StoreU(hn::Compress(ids, hn::RebindMask(di, which)), di, to);
    return hn::CountTrue(d, which);
  }

  // The cells of all blocks in the list that can hold what counts; their elements are added up.
  void search_blocks() {
    blocks_ += lists_.blocks;
    tiles_ += lists_.tiles;
    for (std::size_t k = 0; k < lists_.blocks; ++k) {
      if (lists_.cells > Lists::k_cells) take_cells();
      search_block(static_cast<std::uint32_t>(lists_.block[k]));
    }
    take_cells();
    lists_.tiles = 0;
    lists_.blocks = 0;
  }

  HWY_INLINE void search_block(std::uint32_t id) {
    const Floats d;
    const hn::RebindToSigned<Floats> di;
    const Tile& tile = lists_.tile[id / 16];
    const TileBounds::Cells& more = tile.bounds->cells[id % 16];
    const auto x = static_cast<int>(id % 4 * 4);
    const auto y = static_cast<int>(id / 4 % 4 * 4);
    const TexelView texels = tile.texels.from(x, y);
    std::uint32_t there = 0xFFFF;
    if (!tile.is_whole) {
      there = bounds_.seeds().cells_with_seeds(u_.first + tile.column + x, v_.first + tile.row + y,
                                               u_.count - tile.column - x, v_.count - tile.row - y);
    }
    for (int k = 0; k < 16; k += k_lanes) {
      CellLanes cells;
      find_cell_lanes(bounds_.seeds(), texels, k, cells);
      const V squared = squared_distance(k, tile.left + static_cast<float>(x), tile.top + static_cast<float>(y), 1);
      const V space = room(squared);
      auto near = in_reach(squared);
      for (std::size_t axis = 0; axis < TileBounds::k_axes; ++axis) {
        const V away = hn::Abs(hn::Sub(hn::Set(d, axes_[axis]), cells.middle[axis]));
        const V gap = hn::Max(hn::Zero(d), hn::Sub(away, hn::Add(cells.reach[axis], hn::Set(d, more.reach[axis]))));
        const V variance = hn::Add(cells.variance[axis], hn::Set(d, more.variance[axis]));
        near = hn::And(near, hn::Lt(hn::Mul(gap, gap), hn::Mul(variance, space)));
      }
      if (there != 0xFFFF) near = hn::And(near, mask_of_bits(there >> static_cast<unsigned>(k)));
      lists_.cells +=
          append(hn::Iota(di, static_cast<std::int32_t>(id) * 16 + k), near, lists_.cell.data() + lists_.cells);
    }
  }

  void take_cells() {
    cells_ += lists_.cells;
    for (std::size_t k = 0; k < lists_.cells; ++k) {
      if (buffer_.is_full()) sum_made();
      const auto id = static_cast<std::uint32_t>(lists_.cell[k]);
      const Tile& tile = lists_.tile[id / 256];
      const auto column = static_cast<int>(id / 16 % 4 * 4 + id % 4);
      const auto row = static_cast<int>(id / 64 % 4 * 4 + id / 4 % 4);
      buffer_.add(tile.texels.from(column, row), tile.left + static_cast<float>(column),
                  tile.top + static_cast<float>(row));
    }
    sum_made();  // the texels may be copies that are soon others
    lists_.cells = 0;
  }

  void sum_made() {
    const Floats d;
    const std::size_t count = buffer_.make();
    V sum = hn::Zero(d);
    for (std::size_t at = 0; at < count; at += static_cast<std::size_t>(k_lanes)) {
      const V value = bounds_.seeds().curved ? value_of<true>(at) : value_of<false>(at);
      sum = hn::Add(sum, hn::IfThenElseZero(hn::FirstN(d, count - at), value));
    }
    total_ += static_cast<double>(hn::GetLane(hn::SumOfLanes(d, sum)));
  }

  // What elements at, at + 1, … add to the density: as in mixture_rows.cpp and mixture_query.cpp.
  template <bool curved>
  HWY_INLINE V value_of(std::size_t at) const {
    using Field = SeedBuffer::Field;
    const Floats d;
    const auto load = [&](Field field) HWY_ATTR { return buffer_.load(field, at); };
    const V o_u = load(Field::u);
    const V o_v = load(Field::v);
    const V white_x = hn::MulAdd(hn::Set(d, frame_.w11), o_u, hn::Mul(hn::Set(d, frame_.w12), o_v));
    const V white_y = hn::Mul(hn::Set(d, frame_.w22), o_v);
    V squared = hn::MulAdd(white_x, white_x, hn::Mul(white_y, white_y));
    V x = hn::Sub(hn::Set(d, axes_[0]), load(Field::x));
    V y = hn::Sub(hn::Set(d, axes_[1]), load(Field::y));
    const V own = hn::Set(d, bounds_.roughness() * bounds_.roughness());
    V yy = own;
    V determinant = hn::Mul(own, own);
    V slant = hn::Zero(d);  // xy / yy
    if constexpr (curved) {
      const V x_u = load(Field::x_u);
      const V x_v = load(Field::x_v);
      const V y_u = load(Field::y_u);
      const V y_v = load(Field::y_v);
      const V ku = hn::MulAdd(hn::Set(d, frame_.k_xx), o_u, hn::Mul(hn::Set(d, frame_.k_xy), o_v));
      const V kv = hn::MulAdd(hn::Set(d, frame_.k_xy), o_u, hn::Mul(hn::Set(d, frame_.k_yy), o_v));
      x = hn::MulAdd(x_u, ku, hn::MulAdd(x_v, kv, x));
      y = hn::MulAdd(y_u, ku, hn::MulAdd(y_v, kv, y));
      const V su = hn::MulAdd(hn::Set(d, frame_.l11), x_u, hn::Mul(hn::Set(d, frame_.l21), x_v));
      const V sv = hn::Mul(hn::Set(d, frame_.l22), x_v);
      const V tu = hn::MulAdd(hn::Set(d, frame_.l11), y_u, hn::Mul(hn::Set(d, frame_.l21), y_v));
      const V tv = hn::Mul(hn::Set(d, frame_.l22), y_v);
      const V more_xx = hn::MulAdd(su, su, hn::Mul(sv, sv));
      const V more_yy = hn::MulAdd(tu, tu, hn::Mul(tv, tv));
      const V turned = hn::MulSub(su, tv, hn::Mul(sv, tu));
      determinant = hn::MulAdd(turned, turned, hn::MulAdd(own, hn::Add(more_xx, more_yy), determinant));
      yy = hn::Add(yy, more_yy);
      slant = hn::MulAdd(su, tu, hn::Mul(sv, tv));
    }
    const V root = reciprocal_root(determinant);
    const V inverse_yy = reciprocal(yy);
    slant = hn::Mul(slant, inverse_yy);
    const V across = hn::NegMulAdd(slant, y, x);
    squared = hn::MulAdd(hn::Mul(hn::Mul(yy, root), root), hn::Mul(across, across), squared);
    squared = hn::MulAdd(hn::Mul(y, y), inverse_yy, squared);
    const V value = hn::Mul(hn::Mul(hn::Set(d, frame_.weight), root),
                            exp2_of_negative(hn::Mul(squared, hn::Set(d, -k_unit * k_unit))));
    return hn::IfThenElseZero(hn::Lt(squared, hn::Set(d, squared_cut_)), value);
  }

  const MixtureSearch& frame_;
  const MixtureBounds& bounds_;
  MixtureBounds::Axis u_;
  MixtureBounds::Axis v_;
  Lists& lists_;
  SeedBuffer& buffer_;
  std::array<float, TileBounds::k_axes> axes_;
  float squared_cut_;
  float room_;
  float room_slope_;
  double total_ = 0;
  std::size_t tiles_ = 0;
  std::size_t copies_ = 0;  // of texels across the border
  std::size_t blocks_ = 0;
  std::size_t cells_ = 0;
};

}  // namespace

double search(const MixtureSearch& frame, glm::dvec2 s, double& spent) {
  thread_local Lists lists;
  thread_local SeedBuffer buffer;
  Search query(frame, s, lists, buffer);
  const double density = query.density();
  spent += query.spent();
  return density;
}

}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glint {

HWY_EXPORT(search);

MixtureSearch::MixtureSearch(const MixtureFrame& frame, const MixtureBounds& of)
    : bounds(&of),
      window(frame.widened),
      cut(frame.cut),
      first(of.seeds().border - frame.center.x, of.seeds().border - frame.center.y),
      w11(static_cast<float>(frame.whitening.w11)),
      w12(static_cast<float>(frame.whitening.w12)),
      w22(static_cast<float>(frame.whitening.w22)),
      k_xx(static_cast<float>(frame.drift.xx)),
      k_xy(static_cast<float>(frame.drift.xy)),
      k_yy(static_cast<float>(frame.drift.yy)),
      l11(static_cast<float>(frame.spread.l11)),
      l21(static_cast<float>(frame.spread.l21)),
      l22(static_cast<float>(frame.spread.l22)),
      weight(static_cast<float>(frame.weight)),
      pull(of.seeds().curved
               ? static_cast<float>(std::min(1.0, frame.lattice.deviation / std::sqrt(eigenvalues(frame.widened).y)))
               : 0.0F) {}

bool MixtureSearch::can_search(const MixtureFrame& frame) {
  if (frame.uniform) return false;
  const NormalMap& map = *frame.map;
  if (map.wrap() == Wrap::repeat) return true;
  const FootprintWindow reached(frame.widened);
  const double u = reached.reach_x(frame.cut);
  const double v = reached.reach_y(frame.cut);
  return frame.center.x - u > 0 && frame.center.x + u < map.width() && frame.center.y - v > 0 &&
         frame.center.y + v < map.height();
}

double MixtureSearch::density(glm::dvec2 s, double& spent) const {
  return HWY_DYNAMIC_DISPATCH(search)(*this, s, spent);
}

}  // namespace glint

#endif  // once
