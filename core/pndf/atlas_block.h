#pragma once
// One image of an atlas as it is kept.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/pndf/atlas_windows.h"

namespace glint {

inline constexpr double k_half_error = 1.0 / 2048;
inline constexpr double k_dropped_share = 1e-4;

/// Half floats in runs of 16 cells that are not empty: off by k_half_error of each value at most, and by
/// k_dropped_share of the sum of all.
struct AtlasBlock {
  float scale = 0;                       ///< density = scale * half
  std::vector<std::uint32_t> row_begin;  ///< row r has runs row_begin[r] … row_begin[r + 1] - 1
  std::vector<std::uint16_t> run;        ///< its first column over 16
  std::vector<std::uint16_t> half;       ///< 16 a run

  /// Times `factor`. Runs whose every value is below k_dropped_share of the mean are taken for empty.
  AtlasBlock(const WindowImage& image, int rows, float factor);

  [[nodiscard]] std::size_t bytes() const {
    return row_begin.size() * sizeof(std::uint32_t) + (run.size() + half.size()) * sizeof(std::uint16_t);
  }
};

/// Adds weight * density to `image`.
void add_block(const AtlasBlock& block, float weight, WindowImage& image);

}  // namespace glint
