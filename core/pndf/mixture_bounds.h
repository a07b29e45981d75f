#pragma once
// Bounds of the elements of a mixture in blocks of cells, by which queries pass over those that cannot matter.

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/pndf/mixture_cells.h"
#include "core/surface/normal_map.h"

namespace glint {

/// Of the elements of 4 x 4 blocks of 4 x 4 cells, along s, t, s + t and s - t. A block without elements has lo > hi.
struct alignas(64) TileBounds {
  static constexpr std::size_t k_axes = 4;
  using Blocks = std::array<std::array<float, 16>, k_axes>;
  Blocks lo, hi;             ///< the means s_i of the block's elements
  Blocks inverse_deviation;  ///< 1 / the largest deviation: of sigma_r^2 I + sigma_h^2 J_i J_i^T

  /// How much more at most than a cell's four corners say (CellLanes), in one block.
  struct Cells {
    std::array<float, k_axes> reach;     ///< of means, to either side
    std::array<float, k_axes> variance;  ///< of elements, with sigma_r^2
  };
  std::array<Cells, 16> cells;
};

/// The bounds of tiles of 16 x 16 cells, each made when a footprint first asks for it, from the very elements that
/// queries make: what a query costs does not depend on the size of the map. Shared between threads; those that make the
/// same tile at once make it alike.
class MixtureBounds {
 public:
  static constexpr int k_block = 4;
  static constexpr int k_tile = 16;

  MixtureBounds(std::shared_ptr<const NormalMap> map, CellSeeds seeds, double roughness);
  MixtureBounds(const MixtureBounds&) = delete;
  MixtureBounds& operator=(const MixtureBounds&) = delete;
  ~MixtureBounds();

  [[nodiscard]] const NormalMap& map() const { return *map_; }
  [[nodiscard]] const CellSeeds& seeds() const { return seeds_; }
  [[nodiscard]] float roughness() const { return roughness_; }

  /// Cells along one axis, repeated with that period where the map repeats; else those of all seeds on the map.
  struct Axis {
    std::int64_t first;
    std::int64_t count;
    [[nodiscard]] std::int64_t tiles() const { return (count + k_tile - 1) / k_tile; }
  };
  [[nodiscard]] Axis axis_u() const { return axis(map_->width()); }
  [[nodiscard]] Axis axis_v() const { return axis(map_->height()); }

  /// Counted from the axes' first cells.
  [[nodiscard]] const TileBounds& tile(std::int64_t a, std::int64_t b) const;
  /// Of what was made so far.
  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] Axis axis(int size) const;

  std::shared_ptr<const NormalMap> map_;
  CellSeeds seeds_;
  float roughness_;
  mutable std::vector<std::atomic<const TileBounds*>> tiles_;
  mutable std::atomic<std::size_t> made_{0};
};

}  // namespace glint
