#pragma once
// Private to footprint_moments: the Gaussian-weighted sum over the texels of a map, or over one level of its blocks.

#include "core/pndf/footprint.h"
#include "core/pndf/lean_moments.h"
#include "core/surface/normal_map.h"

namespace glint {

/// The nodes that are merged: texels (level 0) or the blocks of MomentChain's level - 1.
class LeanLattice {
 public:
  /// `chain` is that of `map`; texels need none.
  LeanLattice(const NormalMap& map, int level, const LeanMoments* chain)
      : map_(map), chain_(chain), level_(level - 1), size_(level > 0 ? MomentChain::block_size(level - 1) : 1) {}

  [[nodiscard]] const NormalMap& map() const { return map_; }
  /// Texels a side; fewer at the right and lower border.
  [[nodiscard]] std::int64_t size() const { return size_; }

  /// The node in column i and row j, inside the map.
  [[nodiscard]] SlopeMoments node(std::int64_t i, std::int64_t j) const {
    return chain_ == nullptr ? texel(i, j) : chain_->map().block(level_, i, j);
  }
  /// What a map that clamps holds beyond its border, beside a column or row of nodes and at the corners.
  [[nodiscard]] SlopeMoments beyond_top(std::int64_t i) const {
    return chain_ == nullptr ? texel(i, 0) : chain_->top().block(level_, i, 0);
  }
  [[nodiscard]] SlopeMoments beyond_bottom(std::int64_t i) const {
    return chain_ == nullptr ? texel(i, map_.height() - 1) : chain_->bottom().block(level_, i, 0);
  }
  [[nodiscard]] SlopeMoments beyond_left(std::int64_t j) const {
    return chain_ == nullptr ? texel(0, j) : chain_->left().block(level_, 0, j);
  }
  [[nodiscard]] SlopeMoments beyond_right(std::int64_t j) const {
    return chain_ == nullptr ? texel(map_.width() - 1, j) : chain_->right().block(level_, 0, j);
  }
  [[nodiscard]] SlopeMoments texel(std::int64_t i, std::int64_t j) const {
    return {texel_slope(glm::dvec2(map_.texel(i, j))).slope, {0, 0, 0}};
  }

 private:
  const NormalMap& map_;
  const LeanMoments* chain_;
  int level_;
  std::int64_t size_;
};

/// The footprint's centre is reduced, and its narrowest deviation at least 0.75 texels and two blocks. A footprint
/// that reaches further than four periods of a map is folded into one, whose nodes are visited once each.
SlopeMoments lattice_moments(const LeanLattice& lattice, const Footprint& footprint);

}  // namespace glint
