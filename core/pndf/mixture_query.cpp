#include "core/pndf/mixture_query.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/pndf/mixture_query.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/math/simd_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

HWY_INLINE V block_density(const PreparedMixture::Fields& f, std::size_t first, float sx, float sy) {
  const Floats d;
  const auto load = [&](const std::vector<float>& field) HWY_ATTR { return hn::LoadU(d, field.data() + first); };
  const V x = hn::Sub(hn::Set(d, sx), load(f.x));
  const V y = hn::Sub(hn::Set(d, sy), load(f.y));
  const V across = hn::MulAdd(x, load(f.w11), hn::Mul(y, load(f.w12)));
  const V down = hn::Mul(y, load(f.w22));
  const V exponent = hn::MulAdd(across, across, hn::Mul(down, down));
  const V value = hn::Mul(load(f.amplitude), exp2_of_negative(hn::Neg(exponent)));
  return hn::IfThenElseZero(hn::Lt(exponent, load(f.most)), value);
}

}  // namespace

double query_mixture(const PreparedMixture& mixture, glm::dvec2 s) {
  const Floats d;
  const auto sx = static_cast<float>(s.x);
  const auto sy = static_cast<float>(s.y);
  const std::array<float, 4> axes{sx, sy, static_cast<float>(s.x + s.y), static_cast<float>(s.x - s.y)};
  const PreparedMixture::Bounds& bounds = mixture.bounds();
  double total = 0;
  for (std::size_t first = 0; first < mixture.blocks(); first += static_cast<std::size_t>(k_lanes)) {
    auto near = hn::FirstN(d, mixture.blocks() - first);
    for (std::size_t axis = 0; axis < 4; ++axis) {
      const V q = hn::Set(d, axes[axis]);
      near = hn::And(near, hn::And(hn::Ge(q, hn::LoadU(d, bounds.lo[axis].data() + first)),
                                   hn::Le(q, hn::LoadU(d, bounds.hi[axis].data() + first))));
    }
    if (hn::AllFalse(d, near)) continue;
    V sum = hn::Zero(d);
    for (std::uint32_t bits = mask_bits(near); bits != 0; bits &= bits - 1) {
      const std::size_t block = first + static_cast<std::size_t>(__builtin_ctz(bits));
      for (std::size_t k = 0; k < PreparedMixture::k_block; k += static_cast<std::size_t>(k_lanes)) {
        sum = hn::Add(sum, block_density(mixture.fields(), block * PreparedMixture::k_block + k, sx, sy));
      }
    }
    total += static_cast<double>(hn::GetLane(hn::SumOfLanes(d, sum)));
  }
  return total;
}

// Makes blocks of the elements of a band in that order; returns the sum of their weights.
double add_blocks(const ElementList& band, const std::vector<std::int32_t>& order, std::size_t block,
                  PreparedMixture::Fields& fields, PreparedMixture::Bounds& bounds) {
  const Floats d;
  const hn::RebindToSigned<Floats> di;
  double mass = 0;
  for (std::size_t first = 0; first < band.count; first += PreparedMixture::k_block, ++block) {
    std::array<V, 4> lo;
    std::array<V, 4> hi;
    lo.fill(hn::Set(d, std::numeric_limits<float>::max()));
    hi.fill(hn::Set(d, std::numeric_limits<float>::lowest()));
    for (std::size_t k = 0; k < PreparedMixture::k_block; k += static_cast<std::size_t>(k_lanes)) {
      // Beyond the last, its neighbours again without amplitude.
      const auto ids = hn::LoadU(di, order.data() + first + k);
      const auto there = hn::FirstN(d, first + k < band.count ? band.count - first - k : 0);
      const auto field = [&](const std::vector<float>& of) HWY_ATTR { return hn::GatherIndex(d, of.data(), ids); };
      const V x = field(band.x);
      const V y = field(band.y);
      const V w11 = field(band.w11);
      const V w12 = field(band.w12);
      const V w22 = field(band.w22);
      const V room = field(band.room);
      const V amplitude = hn::IfThenElseZero(there, field(band.amplitude));
      const std::size_t at = block * PreparedMixture::k_block + k;
      const auto keep = [&](V values, std::vector<float>& to) HWY_ATTR { hn::StoreU(values, d, to.data() + at); };
      const V unit = hn::Set(d, k_unit);
      keep(x, fields.x);
      keep(y, fields.y);
      keep(hn::Mul(w11, unit), fields.w11);
      keep(hn::Mul(w12, unit), fields.w12);
      keep(hn::Mul(w22, unit), fields.w22);
      keep(amplitude, fields.amplitude);
      keep(hn::Mul(room, hn::Mul(unit, unit)), fields.most);
      // W^-T of the axes: their deviations.
      const V across = hn::Div(hn::Set(d, 1), w11);
      const V down = hn::Div(hn::Set(d, 1), w22);
      const V lean = hn::Neg(hn::Mul(w12, hn::Mul(across, down)));
      mass += static_cast<double>(hn::GetLane(hn::SumOfLanes(d, hn::Mul(amplitude, hn::Mul(across, down)))));
      const auto squares = [](V a, V b) HWY_ATTR { return hn::MulAdd(a, a, hn::Mul(b, b)); };
      const std::array<V, 4> means{x, y, hn::Add(x, y), hn::Sub(x, y)};
      const std::array<V, 4> variances{squares(across, lean), hn::Mul(down, down), squares(across, hn::Add(lean, down)),
                                       squares(across, hn::Sub(lean, down))};
      for (std::size_t axis = 0; axis < 4; ++axis) {
        const V reach = hn::Sqrt(hn::Mul(room, variances[axis]));
        lo[axis] = hn::Min(lo[axis], hn::Sub(means[axis], reach));
        hi[axis] = hn::Max(hi[axis], hn::Add(means[axis], reach));
      }
    }
    for (std::size_t axis = 0; axis < 4; ++axis) {
      bounds.lo[axis][block] = hn::GetLane(hn::MinOfLanes(d, lo[axis]));
      bounds.hi[axis][block] = hn::GetLane(hn::MaxOfLanes(d, hi[axis]));
    }
  }
  return 2 * std::numbers::pi * mass;
}

}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glint {

HWY_EXPORT(query_mixture);
HWY_EXPORT(add_blocks);

double PreparedMixture::density(glm::dvec2 s) const {
  return HWY_DYNAMIC_DISPATCH(query_mixture)(*this, s);
}

namespace {

// By counting: the elements of a band of rows by their tile of four seeds, padded to whole blocks.
class TileOrder {
 public:
  explicit TileOrder(const MixtureFrame& frame) {
    const double step = frame.lattice.step.x;
    const auto [first, last] = frame.columns();
    left_ = static_cast<float>((static_cast<double>(first) + 0.5) * step - frame.center.x);
    per_tile_ = static_cast<float>(1 / (4 * step));
    begins_.resize(static_cast<std::size_t>((last - first) / 4) + 4);
  }

  const std::vector<std::int32_t>& of(const ElementList& band) {
    std::fill(begins_.begin(), begins_.end(), 0);
    for (std::size_t k = 0; k < band.count; ++k) ++begins_[tile(band.u[k]) + 1];
    for (std::size_t t = 1; t < begins_.size(); ++t) begins_[t] += begins_[t - 1];
    order_.assign(band.count + PreparedMixture::k_block, 0);
    for (std::size_t k = 0; k < band.count; ++k) {
      order_[static_cast<std::size_t>(begins_[tile(band.u[k])]++)] = static_cast<std::int32_t>(k);
    }
    if (band.count > 0) {
      std::fill(order_.begin() + static_cast<std::ptrdiff_t>(band.count), order_.end(), order_[band.count - 1]);
    }
    return order_;
  }

 private:
  [[nodiscard]] std::size_t tile(float u) const {
    const auto at = static_cast<std::size_t>(std::max(0.0F, (u - left_) * per_tile_));
    return std::min(at, begins_.size() - 2);
  }

  float left_;
  float per_tile_;
  std::vector<std::int32_t> begins_;
  std::vector<std::int32_t> order_;
};

}  // namespace

PreparedMixture::PreparedMixture(const MixtureFrame& frame, MixtureFrame::Seeds of_rows) {
  constexpr std::int64_t k_band = 4;
  MixtureRows rows(frame);
  ElementList band;
  TileOrder order(frame);
  const auto [first, last] = of_rows;
  for (std::int64_t row = first; row <= last; row += k_band) {
    band.count = 0;
    for (std::int64_t k = row; k < std::min(row + k_band, last + 1); ++k) rows.append(k, band);
    const std::size_t before = blocks_;
    blocks_ += (band.count + k_block - 1) / k_block;
    for (std::vector<float>* field :
         {&fields_.x, &fields_.y, &fields_.w11, &fields_.w12, &fields_.w22, &fields_.amplitude, &fields_.most}) {
      field->resize(blocks_ * k_block);
    }
    for (std::size_t axis = 0; axis < 4; ++axis) {
      bounds_.lo[axis].resize(blocks_ + k_block);
      bounds_.hi[axis].resize(blocks_ + k_block);
    }
    mass_ += HWY_DYNAMIC_DISPATCH(add_blocks)(band, order.of(band), before, fields_, bounds_);
    count_ += band.count;
  }
}

}  // namespace glint

#endif  // once
