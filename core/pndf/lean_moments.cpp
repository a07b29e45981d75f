#include "core/pndf/lean_moments.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>

#include "core/math/parallel.h"
#include "core/pndf/slope_space.h"

namespace glint {
namespace {

// Rounding may leave a rank-one matrix with a negative determinant.
SymmetricMatrix2 semidefinite(SymmetricMatrix2 m) {
  const double most = std::sqrt(m.xx) * std::sqrt(m.yy);
  m.xy = std::clamp(m.xy, -most, most);
  while (determinant(m) < 0) m.xy = std::nextafter(m.xy, 0.0);
  return m;
}

std::int64_t blocks_along(std::int64_t texels, std::int64_t size) {
  return (texels + size - 1) / size;
}

void for_rows(std::int64_t rows, const std::function<void(std::int64_t)>& body) {
  JobControl control;
  parallel_blocks(static_cast<std::size_t>(rows), control,
                  [&](std::size_t row) { body(static_cast<std::int64_t>(row)); });
}

}  // namespace

TexelSlope texel_slope(glm::dvec2 normal) {
  const double squared = squared_height(normal);
  if (squared >= k_least_height * k_least_height) return {(-1 / std::sqrt(squared)) * normal, false};
  return {(-k_steepest_slope / std::hypot(normal.x, normal.y)) * normal, true};
}

void MomentSum::add(double weight, const SlopeMoments& part) {
  if (!(weight > 0)) return;
  const double sum = weight_ + weight;
  const double share = weight / sum;
  const glm::dvec2 apart = part.mean - mean_;
  const double factor = weight_ * share;
  scatter_.xx += weight * part.covariance.xx + factor * apart.x * apart.x;
  scatter_.xy += weight * part.covariance.xy + factor * apart.x * apart.y;
  scatter_.yy += weight * part.covariance.yy + factor * apart.y * apart.y;
  mean_ += share * apart;
  weight_ = sum;
}

SlopeMoments MomentSum::moments() const {
  return {mean_, semidefinite({scatter_.xx / weight_, scatter_.xy / weight_, scatter_.yy / weight_})};
}

MomentChain::MomentChain(const NormalMap& map, const Rectangle& texels) : width_(texels.width), height_(texels.height) {
  add_first_level(map, texels);
  while (levels_.back().columns > 1 || levels_.back().rows > 1) add_next_level();
}

MomentChain::Block MomentChain::rounded(const SlopeMoments& moments) {
  const auto xx = static_cast<float>(moments.covariance.xx);
  const auto yy = static_cast<float>(moments.covariance.yy);
  const float most = std::sqrt(xx) * std::sqrt(yy);
  float xy = std::clamp(static_cast<float>(moments.covariance.xy), -most, most);
  // Products of floats are exact in double precision.
  while (static_cast<double>(xy) * xy > static_cast<double>(xx) * yy) xy = std::nextafter(xy, 0.0F);
  return {glm::vec2(moments.mean), {xx, xy, yy}};
}

void MomentChain::add_first_level(const NormalMap& map, const Rectangle& texels) {
  Level level{blocks_along(width_, k_first_block), blocks_along(height_, k_first_block), {}};
  level.blocks.resize(static_cast<std::size_t>(level.columns * level.rows));
  std::vector<std::size_t> clamped(static_cast<std::size_t>(level.rows));
  for_rows(level.rows, [&](std::int64_t row) {
    std::size_t steep = 0;
    for (std::int64_t column = 0; column < level.columns; ++column) {
      const std::int64_t right = std::min((column + 1) * k_first_block, width_);
      const std::int64_t below = std::min((row + 1) * k_first_block, height_);
      std::array<glm::dvec2, k_first_block * k_first_block> slopes;
      std::size_t count = 0;
      glm::dvec2 mean{0, 0};
      for (std::int64_t j = row * k_first_block; j < below; ++j) {
        for (std::int64_t i = column * k_first_block; i < right; ++i) {
          const TexelSlope texel = texel_slope(glm::dvec2(map.texel(texels.i + i, texels.j + j)));
          steep += texel.clamped ? 1 : 0;
          slopes[count++] = texel.slope;
          mean += texel.slope;
        }
      }
      const double share = 1 / static_cast<double>(count);
      SlopeMoments block{share * mean, {0, 0, 0}};
      for (std::size_t k = 0; k < count; ++k) {
        const glm::dvec2 apart = slopes[k] - block.mean;
        block.covariance.xx += share * apart.x * apart.x;
        block.covariance.xy += share * apart.x * apart.y;
        block.covariance.yy += share * apart.y * apart.y;
      }
      level.blocks[static_cast<std::size_t>(row * level.columns + column)] = rounded(block);
    }
    clamped[static_cast<std::size_t>(row)] = steep;
  });
  clamped_texels_ = std::accumulate(clamped.begin(), clamped.end(), std::size_t{0});
  levels_.push_back(std::move(level));
}

void MomentChain::add_next_level() {
  const int below = levels() - 1;
  const std::int64_t size = block_size(below);
  const Level& finer = levels_.back();
  Level level{blocks_along(finer.columns, 2), blocks_along(finer.rows, 2), {}};
  level.blocks.resize(static_cast<std::size_t>(level.columns * level.rows));
  for_rows(level.rows, [&](std::int64_t row) {
    for (std::int64_t column = 0; column < level.columns; ++column) {
      MomentSum sum;
      for (std::int64_t j = 2 * row; j < std::min(2 * row + 2, finer.rows); ++j) {
        for (std::int64_t i = 2 * column; i < std::min(2 * column + 2, finer.columns); ++i) {
          const std::int64_t texels = std::min(size, width_ - i * size) * std::min(size, height_ - j * size);
          sum.add(static_cast<double>(texels), block(below, i, j));
        }
      }
      level.blocks[static_cast<std::size_t>(row * level.columns + column)] = rounded(sum.moments());
    }
  });
  levels_.push_back(std::move(level));
}

SlopeMoments MomentChain::block(int level, std::int64_t i, std::int64_t j) const {
  const Level& of = levels_[static_cast<std::size_t>(std::min(level, levels() - 1))];
  const Block& b = of.blocks[static_cast<std::size_t>(j * of.columns + i)];
  return {glm::dvec2(b.mean), {b.covariance[0], b.covariance[1], b.covariance[2]}};
}

std::size_t MomentChain::bytes() const {
  std::size_t count = 0;
  for (const Level& level : levels_) count += level.blocks.size();
  return count * sizeof(Block);
}

LeanMoments::LeanMoments(const NormalMap& map) : map_chain_(map, {0, 0, map.width(), map.height()}) {
  if (map.wrap() == Wrap::repeat) return;
  borders_.reserve(4);
  borders_.emplace_back(map, MomentChain::Rectangle{0, 0, map.width(), 1});
  borders_.emplace_back(map, MomentChain::Rectangle{0, map.height() - 1, map.width(), 1});
  borders_.emplace_back(map, MomentChain::Rectangle{0, 0, 1, map.height()});
  borders_.emplace_back(map, MomentChain::Rectangle{map.width() - 1, 0, 1, map.height()});
}

std::size_t LeanMoments::bytes() const {
  std::size_t sum = map_chain_.bytes();
  for (const MomentChain& border : borders_) sum += border.bytes();
  return sum;
}

}  // namespace glint
