#include "core/pndf/mixture_bounds.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/pndf/mixture_bounds.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/math/simd_math-inl.h"
#include "core/pndf/mixture_seeds-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

constexpr float k_rounding = 3e-7F;
constexpr float k_nowhere = 1e9F;

// CellLanes of one cell.
struct CornerGuess {
  std::array<float, TileBounds::k_axes> middle, reach, variance;
};

std::array<CornerGuess, 16> corner_guesses(const CellSeeds& seeds, const TexelView& texels) {
  std::array<CornerGuess, 16> all{};
  for (int first = 0; first < 16; first += k_lanes) {
    CellLanes lanes;
    find_cell_lanes(seeds, texels, first, lanes);
    for (std::size_t axis = 0; axis < TileBounds::k_axes; ++axis) {
      const auto spread = [&](V of, auto member) HWY_ATTR {
        alignas(64) std::array<float, 16> values{};
        hn::StoreU(of, Floats(), values.data());
        for (std::size_t k = 0; k < static_cast<std::size_t>(k_lanes); ++k) {
          (all[static_cast<std::size_t>(first) + k].*member)[axis] = values[k];
        }
      };
      spread(lanes.middle[axis], &CornerGuess::middle);
      spread(lanes.reach[axis], &CornerGuess::reach);
      spread(lanes.variance[axis], &CornerGuess::variance);
    }
  }
  return all;
}

// Bounds of one block, gathered.
class BlockRange {
 public:
  BlockRange(float roughness, const CellSeeds& seeds)
      : curved_(seeds.curved),
        own_(roughness * roughness),
        squared_deviation_(static_cast<float>(seeds.deviation * seeds.deviation)) {
    const Floats d;
    lo_.fill(hn::Set(d, k_nowhere));
    hi_.fill(hn::Set(d, -k_nowhere));
    largest_.fill(hn::Zero(d));
    reach_.fill(hn::Set(d, -k_nowhere));
    variance_.fill(hn::Set(d, -k_nowhere));
  }

  // All seeds of one cell.
  void include(const SeedBuffer& made, std::size_t count, const CornerGuess& guess) {
    using Field = SeedBuffer::Field;
    const Floats d;
    for (std::size_t at = 0; at < count; at += static_cast<std::size_t>(k_lanes)) {
      const auto there = hn::FirstN(d, count - at);
      const auto most = [&](V of, V& so_far) HWY_ATTR { so_far = hn::IfThenElse(there, hn::Max(so_far, of), so_far); };
      const auto means = along_axes(made.load(Field::x, at), made.load(Field::y, at));
      for (std::size_t axis = 0; axis < TileBounds::k_axes; ++axis) {
        lo_[axis] = hn::IfThenElse(there, hn::Min(lo_[axis], means[axis]), lo_[axis]);
        most(means[axis], hi_[axis]);
        const V away = hn::Abs(hn::Sub(means[axis], hn::Set(d, guess.middle[axis])));
        most(hn::Sub(away, hn::Set(d, guess.reach[axis])), reach_[axis]);
      }
      const V zero = hn::Zero(d);
      std::array<V, TileBounds::k_axes> du{zero, zero, zero, zero};
      std::array<V, TileBounds::k_axes> dv{zero, zero, zero, zero};
      if (curved_) {
        du = along_axes(made.load(Field::x_u, at), made.load(Field::y_u, at));
        dv = along_axes(made.load(Field::x_v, at), made.load(Field::y_v, at));
      }
      for (std::size_t axis = 0; axis < TileBounds::k_axes; ++axis) {
        const V slope = hn::MulAdd(du[axis], du[axis], hn::Mul(dv[axis], dv[axis]));
        const V variance = hn::MulAdd(slope, hn::Set(d, squared_deviation_), hn::Set(d, axis < 2 ? own_ : 2 * own_));
        most(variance, largest_[axis]);
        most(hn::Sub(variance, hn::Set(d, guess.variance[axis])), variance_[axis]);
      }
    }
  }

  void store(TileBounds& tile, std::size_t child) const {
    const Floats d;
    const auto most = [&](V of) HWY_ATTR { return hn::GetLane(hn::MaxOfLanes(d, of)); };
    for (std::size_t axis = 0; axis < TileBounds::k_axes; ++axis) {
      const float lo = hn::GetLane(hn::MinOfLanes(d, lo_[axis]));
      const float hi = most(hi_[axis]);
      const float rounding = k_rounding * (1 + std::max(std::abs(lo), std::abs(hi)));
      const float largest = std::max(most(largest_[axis]), own_);
      tile.lo[axis][child] = lo - rounding;
      tile.hi[axis][child] = hi + rounding;
      tile.inverse_deviation[axis][child] = (1 - 4 * k_rounding) / std::sqrt(largest);
      tile.cells[child].reach[axis] = most(reach_[axis]) + 4 * rounding;
      tile.cells[child].variance[axis] = most(variance_[axis]) + 8 * k_rounding * largest;
    }
  }

 private:
  bool curved_;
  float own_;
  float squared_deviation_;
  std::array<V, TileBounds::k_axes> lo_;
  std::array<V, TileBounds::k_axes> hi_;
  std::array<V, TileBounds::k_axes> largest_;  // variance
  std::array<V, TileBounds::k_axes> reach_;
  std::array<V, TileBounds::k_axes> variance_;
};

}  // namespace

void bound_tile(const MixtureBounds& bounds, std::int64_t a, std::int64_t b, TileBounds& out) {
  thread_local SeedBuffer buffer;  // not that of the query which asks for it
  const CellSeeds& seeds = bounds.seeds();
  const MixtureBounds::Axis u = bounds.axis_u();
  const MixtureBounds::Axis v = bounds.axis_v();
  TileTexels spare;
  const std::int64_t tile_column = a * MixtureBounds::k_tile;
  const std::int64_t tile_row = b * MixtureBounds::k_tile;
  const TexelView of_tile = spare.of(bounds, u.first + tile_column, v.first + tile_row);
  for (int child = 0; child < 16; ++child) {
    BlockRange range(bounds.roughness(), seeds);
    const int x = child % 4 * MixtureBounds::k_block;
    const int y = child / 4 * MixtureBounds::k_block;
    const TexelView texels = of_tile.from(x, y);
    const std::array<CornerGuess, 16> guesses = corner_guesses(seeds, texels);
    std::uint32_t bits = seeds.cells_with_seeds(u.first + tile_column + x, v.first + tile_row + y,
                                                u.count - tile_column - x, v.count - tile_row - y);
    for (; bits != 0; bits &= bits - 1) {
      const int cell = std::countr_zero(bits);
      buffer.begin(seeds);
      buffer.add(texels.from(cell % 4, cell / 4), 0, 0);
      range.include(buffer, buffer.make(), guesses[static_cast<std::size_t>(cell)]);
    }
    range.store(out, static_cast<std::size_t>(child));
  }
}

}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glint {

HWY_EXPORT(bound_tile);

MixtureBounds::MixtureBounds(std::shared_ptr<const NormalMap> map, CellSeeds seeds, double roughness)
    : map_(std::move(map)),
      seeds_(std::move(seeds)),
      roughness_(static_cast<float>(roughness)),
      tiles_(static_cast<std::size_t>(axis_u().tiles() * axis_v().tiles())) {}

MixtureBounds::~MixtureBounds() {
  for (const std::atomic<const TileBounds*>& tile : tiles_) delete tile.load();
}

MixtureBounds::Axis MixtureBounds::axis(int size) const {
  // Of a map that clamps: those on it between its border and the first texel's centre are in cell -1.
  if (map_->wrap() == Wrap::clamp && seeds_.before > 0) return {-1, std::int64_t{size} + 1};
  return {0, size};
}

const TileBounds& MixtureBounds::tile(std::int64_t a, std::int64_t b) const {
  std::atomic<const TileBounds*>& kept = tiles_[static_cast<std::size_t>(b * axis_u().tiles() + a)];
  if (const TileBounds* there = kept.load(std::memory_order_acquire)) return *there;
  auto made = std::make_unique<TileBounds>();
  HWY_DYNAMIC_DISPATCH(bound_tile)(*this, a, b, *made);
  const TileBounds* there = nullptr;
  if (!kept.compare_exchange_strong(there, made.get(), std::memory_order_acq_rel, std::memory_order_acquire)) {
    return *there;
  }
  made_.fetch_add(1, std::memory_order_relaxed);
  return *made.release();
}

std::size_t MixtureBounds::bytes() const {
  return made_.load(std::memory_order_relaxed) * sizeof(TileBounds) + tiles_.size() * sizeof(tiles_[0]);
}

}  // namespace glint

#endif  // once
