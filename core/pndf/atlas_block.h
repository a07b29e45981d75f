#pragma once
// One image of an atlas as it is kept.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/pndf/atlas_windows.h"

namespace glint {

/// Half floats in runs of 16 cells that are not empty: off by 2^-11 of each value at most.
struct AtlasBlock {
  float scale = 0;                       ///< density = scale * half
  std::vector<std::uint32_t> row_begin;  ///< row r has runs row_begin[r] … row_begin[r + 1] - 1
  std::vector<std::uint16_t> run;        ///< its first column over 16
  std::vector<std::uint16_t> half;       ///< 16 a run

  /// Times `factor`. Runs below 1e-6 of the image's largest value are empty.
  AtlasBlock(const WindowImage& image, int rows, float factor);

  [[nodiscard]] std::size_t bytes() const {
    return row_begin.size() * sizeof(std::uint32_t) + (run.size() + half.size()) * sizeof(std::uint16_t);
  }
};

inline constexpr double k_half_error = 1.0 / 2048;

/// Adds weight * density of rows first … last - 1 to `image`.
void add_block(const AtlasBlock& block, float weight, int first, int last, WindowImage& image);

}  // namespace glint
