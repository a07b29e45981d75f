#pragma once
// The first two moments of the slopes of a normal map, in a chain of ever larger blocks of texels (Olano and Baker
// 2010, LEAN mapping), with centred covariances: every term of a merge is positive semi-definite, where E[m^2] - E[m]^2
// cancels and turns negative.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "core/math/gaussian.h"
#include "core/surface/normal_map.h"

namespace glint {

/// Mean and centred covariance of slopes m = -(s, t) / z, dimensionless.
struct SlopeMoments {
  glm::dvec2 mean{0, 0};
  SymmetricMatrix2 covariance{0, 0, 0};
};

/// A normal steeper than z = 0.02, or outside the disk, has the slope 50 along its own direction.
inline constexpr double k_least_height = 0.02;
inline constexpr double k_steepest_slope = 50;

struct TexelSlope {
  glm::dvec2 slope;
  bool clamped;
};
TexelSlope texel_slope(glm::dvec2 normal);

/// Moments of a union, part by part: mu = sum w_k mu_k, C = sum w_k [C_k + (mu_k - mu)(mu_k - mu)^T].
class MomentSum {
 public:
  /// `weight` is not negative; parts of weight 0 count for nothing.
  void add(double weight, const SlopeMoments& part);

  [[nodiscard]] double weight() const { return weight_; }
  /// Of all that was added, whose weight must be positive. The covariance is positive semi-definite to the last digit.
  [[nodiscard]] SlopeMoments moments() const;

 private:
  double weight_ = 0;
  glm::dvec2 mean_{0, 0};
  SymmetricMatrix2 scatter_{0, 0, 0};  // sum of w (C + d d^T)
};

/// A rectangle of texels cut into blocks of 4 x 4 texels, 8 x 8, 16 x 16, … up to one block of all of them. Blocks at
/// the right and lower border hold what is left. Immutable; safe to read from any thread.
class MomentChain {
 public:
  /// Of the texels (i, j) … (i + width - 1, j + height - 1) of a map. On all threads, the same bytes for any number.
  struct Rectangle {
    std::int64_t i;
    std::int64_t j;
    std::int64_t width;
    std::int64_t height;
  };
  MomentChain(const NormalMap& map, const Rectangle& texels);

  [[nodiscard]] std::int64_t width() const { return width_; }
  [[nodiscard]] std::int64_t height() const { return height_; }
  [[nodiscard]] int levels() const { return static_cast<int>(levels_.size()); }
  /// Texels a side of a block of level 0, 1, …
  static std::int64_t block_size(int level) { return k_first_block << level; }
  /// The block in column i and row j; a level beyond the last one is the last one.
  [[nodiscard]] SlopeMoments block(int level, std::int64_t i, std::int64_t j) const;
  /// Of all texels.
  [[nodiscard]] SlopeMoments whole() const { return block(levels() - 1, 0, 0); }
  [[nodiscard]] std::size_t clamped_texels() const { return clamped_texels_; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  static constexpr std::int64_t k_first_block = 4;

  // Single precision is enough: it is no sum, and what is centred does not cancel.
  struct Block {
    glm::vec2 mean;
    std::array<float, 3> covariance;  // xx, xy, yy
  };
  struct Level {
    std::int64_t columns;
    std::int64_t rows;
    std::vector<Block> blocks;
  };
  static Block rounded(const SlopeMoments& moments);
  void add_first_level(const NormalMap& map, const Rectangle& texels);
  void add_next_level();

  std::int64_t width_;
  std::int64_t height_;
  std::size_t clamped_texels_ = 0;
  std::vector<Level> levels_;
};

/// The chain of a map, and, of a map that clamps, those of its border lines, which go on beyond it.
class LeanMoments {
 public:
  explicit LeanMoments(const NormalMap& map);

  [[nodiscard]] const MomentChain& map() const { return map_chain_; }
  /// One texel high or wide. Only of a map that clamps.
  [[nodiscard]] const MomentChain& top() const { return borders_[0]; }
  [[nodiscard]] const MomentChain& bottom() const { return borders_[1]; }
  [[nodiscard]] const MomentChain& left() const { return borders_[2]; }
  [[nodiscard]] const MomentChain& right() const { return borders_[3]; }
  /// Texels of the map whose slope was clamped.
  [[nodiscard]] std::size_t clamped_texels() const { return map_chain_.clamped_texels(); }
  [[nodiscard]] std::size_t bytes() const;

 private:
  MomentChain map_chain_;
  std::vector<MomentChain> borders_;
};

}  // namespace glint
