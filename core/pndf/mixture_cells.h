#pragma once
// Seeds of a mixture by the cells of the map in which they stand, where its lattice and the texels are commensurate:
// every cell then has the same seeds, which take the same weights of the texels about it.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/pndf/mixture_settings.h"
#include "core/surface/catmull_rom.h"
#include "core/surface/surface.h"

namespace glint {

/// What a seed at u takes, along one axis, of four texels from `first` on; of one texel on the constant surface.
struct AxisStencil {
  std::int64_t first;
  CubicWeights value{};
  CubicWeights slope{};
  CubicWeights bend{};  ///< the second difference

  AxisStencil(double u, bool piecewise_constant);
};

/// Cells are those of SurfaceCells: squares between four texel centres, or texels on the constant surface. Cell (i, j)
/// takes `taps` x `taps` texels from (i - before, j - before) on.
struct CellSeeds {
  static constexpr std::size_t k_most = 400;      ///< seeds of a cell: h = 1/20
  static constexpr std::size_t k_whole = 16;      ///< floats of the longest vector
  static constexpr std::size_t k_quantities = 3;  ///< mean, n_u, n_v

  /// Nothing unless, along both axes, h = 1/n (n x n seeds a cell) or h = n (one in every n-th cell).
  static std::optional<CellSeeds> of(const NormalMap& map, bool piecewise_constant, const MixtureSettings& settings);

  std::size_t count;   ///< of seeds in a cell that has any
  std::int64_t every;  ///< cell (i, j) has seeds if i and j leave `remainder` when divided by this
  std::int64_t remainder;
  int taps;              ///< 4, or 1 on the constant surface
  int before;            ///< 1, or 0 on the constant surface
  double border;         ///< where cell 0 begins, texels
  bool curved;           ///< whether n_u and n_v are made
  double deviation;      ///< sigma_h
  float centroid;        ///< of a cell's seeds, on both axes, from where the cell begins
  float extent;          ///< how far they are from there, along an axis
  std::vector<float> u;  ///< of each seed, likewise; padded
  std::vector<float> v;
  /// Of texel (column, row), at (row taps + column) stride: those of the mean of each seed, then of n_u, then of n_v.
  /// Correction is in that of the mean.
  std::vector<float> weights;
  std::size_t stride;  ///< whole vectors

  /// One bit for each of the 4 x 4 cells from (i, j) on that has seeds, of those that lie in `columns` x `rows`.
  [[nodiscard]] std::uint32_t cells_with_seeds(std::int64_t i, std::int64_t j, std::int64_t columns,
                                               std::int64_t rows) const;
};

}  // namespace glint
