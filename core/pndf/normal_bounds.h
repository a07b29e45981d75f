#pragma once
// A 16-ary pyramid of boxes of normals over the cells of a surface, by which queries pass over what cannot matter:
// nodes of 4 x 4 children, whose bounds along s, t, s + t and s - t fill whole vectors.

#include <array>
#include <cstdint>
#include <vector>

#include "core/pndf/surface_cells.h"

namespace glint {

/// Bounds of 16 children, in steps of NormalBounds::k_step; a child without cells has lo > hi.
struct alignas(64) NormalNode {
  static constexpr int k_axes = 4;  ///< s, t, s + t, s - t
  std::array<std::array<std::int16_t, 16>, k_axes> lo;
  std::array<std::array<std::int16_t, 16>, k_axes> hi;
};

/// Cells are counted from the axes' first ones. A block is 4 x 4 cells, a tile 4 x 4 blocks, a group 4 x 4 tiles. About
/// 1.07 bytes a cell. Immutable; shared between threads.
class NormalBounds {
 public:
  static constexpr int k_block = 4;
  static constexpr int k_tile = 16;
  static constexpr int k_group = 64;
  static constexpr float k_step = 1.0F / 8192;  ///< normals with overshoot reach +-4

  /// Builds on the calling thread alone, which may hold a lock.
  explicit NormalBounds(const SurfaceCells& cells);

  [[nodiscard]] int tile_columns() const { return tile_columns_; }
  [[nodiscard]] int tile_rows() const { return tile_rows_; }
  [[nodiscard]] int group_columns() const { return (tile_columns_ + 3) / 4; }
  [[nodiscard]] int group_rows() const { return (tile_rows_ + 3) / 4; }
  /// The bounds of a tile's blocks, and of a group's tiles.
  [[nodiscard]] const NormalNode& tile(int a, int b) const { return tiles_[index(a, b, tile_columns_)]; }
  [[nodiscard]] const NormalNode& group(int a, int b) const { return groups_[index(a, b, group_columns())]; }
  /// What the pyramid of these cells takes.
  static std::size_t bytes_for(const SurfaceCells& cells);

 private:
  static std::size_t index(int a, int b, int columns) {
    return static_cast<std::size_t>(b) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(a);
  }
  void build_tile_row(const SurfaceCells& cells, int b);
  void build_group_row(int b);

  int tile_columns_;
  int tile_rows_;
  std::vector<NormalNode> tiles_;
  std::vector<NormalNode> groups_;
};

}  // namespace glint
