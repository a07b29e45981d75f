#include "core/pndf/atlas_block.h"

#include <algorithm>
#include <numeric>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/pndf/atlas_block.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/math/simd_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

constexpr std::size_t k_run = 16;
using Run = hn::CappedTag<float, k_run>;
using Halves = hn::Rebind<hwy::float16_t, Run>;

}  // namespace

void to_halves(const float* from, float factor, std::uint16_t* to) {
  const Run d;
  for (std::size_t k = 0; k < k_run; k += hn::Lanes(d)) {
    const auto values = hn::Mul(hn::LoadU(d, from + k), hn::Set(d, factor));
    hn::StoreU(hn::DemoteTo(Halves(), values), Halves(), reinterpret_cast<hwy::float16_t*>(to + k));
  }
}

void add_runs(const AtlasBlock& block, float weight, WindowImage& image) {
  const Run d;
  const auto factor = hn::Set(d, weight * block.scale);
  for (std::size_t r = 0; r + 1 < block.row_begin.size(); ++r) {
    float* row = image.density.data() + static_cast<std::ptrdiff_t>(r) * image.stride;
    for (std::size_t run = block.row_begin[r]; run < block.row_begin[r + 1]; ++run) {
      float* out = row + k_run * block.run[run];
      const auto* half = reinterpret_cast<const hwy::float16_t*>(block.half.data() + k_run * run);
      for (std::size_t k = 0; k < k_run; k += hn::Lanes(d)) {
        const auto values = hn::PromoteTo(d, hn::LoadU(Halves(), half + k));
        hn::StoreU(hn::MulAdd(factor, values, hn::LoadU(d, out + k)), d, out + k);
      }
    }
  }
}

}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glint {

HWY_EXPORT(to_halves);
HWY_EXPORT(add_runs);

AtlasBlock::AtlasBlock(const WindowImage& image, int rows, float factor) {
  constexpr float k_largest_half = 32768;
  constexpr std::ptrdiff_t k_run = 16;
  const float largest = *std::max_element(image.density.begin(), image.density.end());
  const double sum = std::accumulate(image.density.begin(), image.density.end(), 0.0);
  const auto least = static_cast<float>(k_dropped_share * sum / static_cast<double>(image.density.size()));
  row_begin.assign(static_cast<std::size_t>(rows) + 1, 0);
  if (!(largest > 0)) return;
  scale = factor * largest / k_largest_half;
  for (int r = 0; r < rows; ++r) {
    const float* row = image.density.data() + r * image.stride;
    for (std::ptrdiff_t at = 0; at + k_run <= image.stride; at += k_run) {
      if (*std::max_element(row + at, row + at + k_run) < least) continue;
      run.push_back(static_cast<std::uint16_t>(at / k_run));
      half.resize(half.size() + k_run);
      HWY_DYNAMIC_DISPATCH(to_halves)(row + at, k_largest_half / largest, half.data() + half.size() - k_run);
    }
    row_begin[static_cast<std::size_t>(r) + 1] = static_cast<std::uint32_t>(run.size());
  }
  run.shrink_to_fit();
  half.shrink_to_fit();
}

void add_block(const AtlasBlock& block, float weight, WindowImage& image) {
  HWY_DYNAMIC_DISPATCH(add_runs)(block, weight, image);
}

}  // namespace glint

#endif  // once
