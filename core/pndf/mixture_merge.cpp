#include "core/pndf/mixture_merge.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/pndf/mixture_merge.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/math/simd_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

HWY_INLINE float sum(V values) {
  return hn::GetLane(hn::SumOfLanes(Floats(), values));
}

HWY_INLINE V squared_plus(V a, V b) {
  return hn::MulAdd(a, a, b);
}

// Elements of one tile in the lanes of a vector.
class TileLanes {
 public:
  TileLanes(const ElementList& band, const std::int32_t* ids, std::size_t count, const ElementMerger::Limits& limits)
      : band_(band), ids_(ids), limits_(limits), left_(hn::FirstN(Floats(), count)) {}

  // Adds what the tile becomes to `out` and its share of the error to `error`.
  HWY_INLINE void merge(ElementList& out, double& error) {
    for (int cluster = 0; cluster < k_most_clusters && !hn::AllFalse(Floats(), left_); ++cluster) {
      if (!merge_cluster(out, error)) break;
    }
    for (std::uint32_t bits = mask_bits(left_); bits != 0; bits &= bits - 1) {
      copy(static_cast<std::size_t>(ids_[__builtin_ctz(bits)]), out);
    }
  }

 private:
  static constexpr int k_most_clusters = 3;
  static constexpr std::size_t k_least_cluster = 3;

  // Those near the first that is left: adds the one Gaussian and takes them away, or does nothing.
  HWY_INLINE bool merge_cluster(ElementList& out, double& error) {
    const Floats d;
    const auto any = static_cast<std::size_t>(ids_[__builtin_ctz(mask_bits(left_))]);
    const V from_x = hn::Sub(field(band_.x), hn::Set(d, band_.x[any]));
    const V from_y = hn::Sub(field(band_.y), hn::Set(d, band_.y[any]));
    const auto near = hn::And(
        left_, hn::And(hn::Lt(hn::Abs(from_x), hn::Set(d, limits_.x)), hn::Lt(hn::Abs(from_y), hn::Set(d, limits_.y))));
    if (hn::CountTrue(d, near) < k_least_cluster) return false;

    const V across = hn::Div(hn::Set(d, 1), field(band_.w11));
    const V down = hn::Div(hn::Set(d, 1), field(band_.w22));
    const V lean = hn::Neg(hn::Mul(field(band_.w12), hn::Mul(across, down)));
    const V xx = squared_plus(across, hn::Mul(lean, lean));
    const V xy = hn::Mul(lean, down);
    const V yy = hn::Mul(down, down);
    // amplitude sqrt(det covariance): the weight over 2 pi.
    const V weight = hn::IfThenElseZero(near, hn::Mul(field(band_.amplitude), hn::Mul(across, down)));
    const float whole = sum(weight);
    if (!(whole > 0)) return false;
    const V share = hn::Mul(weight, hn::Set(d, 1 / whole));
    const auto mean = [&](V values) HWY_ATTR { return sum(hn::IfThenElseZero(near, hn::Mul(share, values))); };
    const float mean_x = mean(from_x);
    const float mean_y = mean(from_y);
    const float mean_xx = mean(xx);
    const float mean_xy = mean(xy);
    const float mean_yy = mean(yy);
    const V off_x = hn::Sub(from_x, hn::Set(d, mean_x));
    const V off_y = hn::Sub(from_y, hn::Set(d, mean_y));

    const float per_xx = 1 / limits_.r_xx;
    const float per_yy = 1 / limits_.r_yy;
    const auto off = [&](V value, float from, float scale)
                         HWY_ATTR { return hn::Mul(hn::Sub(value, hn::Set(d, from)), hn::Set(d, scale)); };
    const V of_xx = off(xx, mean_xx, per_xx);
    const V of_yy = off(yy, mean_yy, per_yy);
    const V of_xy = off(xy, mean_xy, std::sqrt(2 * per_xx * per_yy));
    const V squared_e = squared_plus(of_xx, squared_plus(of_yy, hn::Mul(of_xy, of_xy)));
    const float e = std::sqrt(hn::GetLane(hn::MaxOfLanes(d, hn::IfThenElseZero(near, squared_e))));
    if (!(e < 0.5F)) return false;
    const V squared_distance =
        hn::MulAdd(hn::Mul(off_x, off_x), hn::Set(d, per_xx), hn::Mul(hn::Mul(off_y, off_y), hn::Set(d, per_yy)));
    const V r = hn::Mul(hn::Add(squared_distance, hn::Set(d, 3.42F * e)), hn::Set(d, 1 / (1 - e)));
    const float bound = 1.15F * std::pow(mean(hn::Mul(r, r)), 0.75F);
    if (!(bound < limits_.bound)) return false;

    const float s_xx = mean_xx + mean(hn::Mul(off_x, off_x));
    const float s_xy = mean_xy + mean(hn::Mul(off_x, off_y));
    const float s_yy = mean_yy + mean(hn::Mul(off_y, off_y));
    const float inverse = 1 / std::sqrt(s_xx * s_yy - s_xy * s_xy);
    const std::size_t at = out.count++;
    out.x[at] = band_.x[any] + mean_x;
    out.y[at] = band_.y[any] + mean_y;
    out.w22[at] = 1 / std::sqrt(s_yy);
    out.w11[at] = s_yy * out.w22[at] * inverse;
    out.w12[at] = -s_xy * out.w22[at] * out.w22[at] * out.w11[at];
    out.amplitude[at] = whole * inverse;
    // Each would keep 1 - exp(-room / 2) of its weight: so does what they become.
    const V lost = exp2_of_negative(hn::Mul(field(band_.room), hn::Set(d, -k_unit * k_unit)));
    out.room[at] = std::min(-2 * std::log(mean(lost)), limits_.squared_cut);
    out.u[at] = mean(field(band_.u));
    error += 2 * std::numbers::pi * static_cast<double>(whole * bound);
    left_ = hn::AndNot(near, left_);
    return true;
  }

  void copy(std::size_t from, ElementList& out) const {
    const std::size_t at = out.count++;
    out.x[at] = band_.x[from];
    out.y[at] = band_.y[from];
    out.w11[at] = band_.w11[from];
    out.w12[at] = band_.w12[from];
    out.w22[at] = band_.w22[from];
    out.amplitude[at] = band_.amplitude[from];
    out.room[at] = band_.room[from];
    out.u[at] = band_.u[from];
  }

  [[nodiscard]] HWY_INLINE V field(const std::vector<float>& of) const {
    const hn::RebindToSigned<Floats> di;
    return hn::GatherIndex(Floats(), of.data(), hn::LoadU(di, ids_));
  }

  const ElementList& band_;
  const std::int32_t* ids_;
  const ElementMerger::Limits& limits_;
  hn::Mask<Floats> left_;  // those not merged yet
};

}  // namespace

// How many elements are near the next one of their row, which is a texel or a step away.
std::size_t count_near(const ElementList& band, const ElementMerger::Limits& limits) {
  const Floats d;
  std::size_t near = 0;
  for (std::size_t first = 0; first + 1 < band.count; first += static_cast<std::size_t>(k_lanes)) {
    const auto step = [&](const std::vector<float>& of) HWY_ATTR {
      return hn::Abs(hn::Sub(hn::LoadU(d, of.data() + first + 1), hn::LoadU(d, of.data() + first)));
    };
    const auto both = hn::And(hn::Lt(step(band.x), hn::Set(d, limits.x)), hn::Lt(step(band.y), hn::Set(d, limits.y)));
    near += hn::CountTrue(d, hn::And(both, hn::FirstN(d, band.count - 1 - first)));
  }
  return near;
}

// Of each tile, what merges and what does not, into `out`, where tile t then begins at out_begin[t]. Returns the bound.
double merge_tiles(const ElementList& band, const ElementMerger::Tiles& tiles, const ElementMerger::Limits& limits,
                   ElementList& out, std::vector<std::int32_t>& out_begin) {
  double error = 0;
  out.count = 0;
  out_begin.clear();
  for (std::size_t tile = 0; tile + 1 < tiles.begin.size(); ++tile) {
    out_begin.push_back(static_cast<std::int32_t>(out.count));
    const auto last = static_cast<std::size_t>(tiles.begin[tile + 1]);
    for (auto k = static_cast<std::size_t>(tiles.begin[tile]); k < last; k += static_cast<std::size_t>(k_lanes)) {
      TileLanes(band, tiles.order.data() + k, std::min<std::size_t>(last - k, k_lanes), limits).merge(out, error);
    }
  }
  out_begin.push_back(static_cast<std::int32_t>(out.count));
  return error;
}

}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glint {

HWY_EXPORT(count_near);
HWY_EXPORT(merge_tiles);

namespace {

constexpr double k_range = 4;                // of what may be merged, in its deviations: a ramp's is 3.5
constexpr std::size_t k_padding = 32;        // vectors reach beyond the last element
constexpr std::size_t k_tiles_at_once = 16;  // of what was merged already

}  // namespace

ElementMerger::ElementMerger(const MixtureFrame& frame) {
  const double farthest = k_range * std::cbrt(frame.merge_bound / 1.15);
  limits_ = {static_cast<float>(frame.roughness.x * frame.roughness.x),
             static_cast<float>(frame.roughness.y * frame.roughness.y),
             static_cast<float>(frame.merge_bound),
             static_cast<float>(farthest * frame.roughness.x),
             static_cast<float>(farthest * frame.roughness.y),
             static_cast<float>(frame.cut * frame.cut)};
  const double step = frame.lattice.step.x;
  const auto [first, last] = frame.columns();
  left_ = static_cast<float>(static_cast<double>(first) * step - frame.center.x);
  per_tile_ = static_cast<float>(1 / (static_cast<double>(k_columns) * step));
  tile_count_ = static_cast<std::size_t>(std::max<std::int64_t>(last - first, 0) / k_columns) + 2;
}

double ElementMerger::merge(ElementList& band) {
  if (!(limits_.bound > 0) || band.count < 2) return 0;
  if (4 * HWY_DYNAMIC_DISPATCH(count_near)(band, limits_) < band.count) return 0;
  sort(band);
  merged_.reserve(band.count + k_padding);
  double error = HWY_DYNAMIC_DISPATCH(merge_tiles)(band, tiles_, limits_, merged_, next_.begin);
  const bool mostly = 2 * merged_.count < band.count;
  std::swap(band, merged_);
  if (!mostly) return error;
  // What became one, with its neighbours along the band.
  std::size_t wide = 0;
  for (std::size_t t = 0; t < next_.begin.size() - 1; t += k_tiles_at_once) next_.begin[wide++] = next_.begin[t];
  next_.begin[wide++] = next_.begin.back();
  next_.begin.resize(wide);
  next_.order.assign(band.count + k_padding, 0);
  std::iota(next_.order.begin(), next_.order.begin() + static_cast<std::ptrdiff_t>(band.count), 0);
  merged_.reserve(band.count + k_padding);
  error += HWY_DYNAMIC_DISPATCH(merge_tiles)(band, next_, limits_, merged_, tiles_.begin);
  std::swap(band, merged_);
  return error;
}

// By counting.
void ElementMerger::sort(const ElementList& band) {
  const auto tile_of = [&](std::size_t k) {
    return std::min(static_cast<std::size_t>(std::max(0.0F, (band.u[k] - left_) * per_tile_)), tile_count_ - 1);
  };
  std::vector<std::int32_t>& begin = tiles_.begin;
  begin.assign(tile_count_ + 1, 0);
  for (std::size_t k = 0; k < band.count; ++k) ++begin[tile_of(k) + 1];
  for (std::size_t t = 1; t <= tile_count_; ++t) begin[t] += begin[t - 1];
  tiles_.order.assign(band.count + k_padding, 0);
  next_.begin = begin;
  for (std::size_t k = 0; k < band.count; ++k) {
    tiles_.order[static_cast<std::size_t>(next_.begin[tile_of(k)]++)] = static_cast<std::int32_t>(k);
  }
}

}  // namespace glint

#endif  // once
