#pragma once
// P-NDF images of wide footprints in the same time however wide they are: the images under B-spline windows over the
// map (SplineFootprint) are computed once and kept, and a footprint's is their weighted sum.

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <tuple>
#include <vector>

#include "core/math/parallel.h"
#include "core/pndf/atlas_block.h"
#include "core/pndf/mixture_settings.h"
#include "core/pndf/pndf_grid.h"
#include "core/pndf/spline_footprint.h"
#include "core/surface/surface.h"

namespace glint {

/// Of one surface, sigma_r, grid and mixture settings, merging apart. Elements under a window are weighted by its value
/// at their seeds, which for windows this wide is off the mixture's own weights by (sigma_h / sigma_p)^2. Members may
/// be called from any thread.
class MixtureAtlas {
 public:
  /// The memory of what is kept; while blocks are built, as much again for their images, and for the canvases of all
  /// threads.
  static constexpr std::size_t k_most_bytes = std::size_t{256} << 20U;

  MixtureAtlas(const Surface& surface, double intrinsic_roughness, const MixtureSettings& settings,
               const PndfGrid& grid, std::size_t most_bytes = k_most_bytes);

  [[nodiscard]] const std::shared_ptr<const NormalMap>& map() const { return surface_.shared_map(); }
  /// Whether it is of these.
  [[nodiscard]] bool is_of(const Surface& surface, double intrinsic_roughness, const MixtureSettings& settings,
                           const PndfGrid& grid) const;

  /// Whether an atlas answers such footprints at all: not narrower than k_least_deviation, not so long or so rich in
  /// cells that the blocks would not fit or take more than some seconds, and not for a roughness that is for the exact
  /// method.
  [[nodiscard]] bool suits(const SymmetricMatrix2& covariance) const;
  /// The share of the footprint's blocks that is not there, of one that suits.
  [[nodiscard]] double missing_share(const Footprint& footprint) const;

  /// Makes the blocks that the footprint lacks, on all threads, forgetting others where memory asks for it. For one
  /// thread at a time. False if cancelled, or where the atlas does not suit.
  bool build(const Footprint& footprint, JobControl& control);

  /// The image; nothing where blocks are missing. Bounded is what the windows leave of the footprint and how blocks are
  /// kept; not the cut of the elements, as in direct images.
  [[nodiscard]] std::optional<PndfImage> image(const Footprint& footprint) const;

  [[nodiscard]] std::size_t bytes() const;
  [[nodiscard]] std::size_t blocks() const;

 private:
  using Key = std::tuple<int, std::int64_t, std::int64_t>;  // level, j, i
  struct Kept {
    std::shared_ptr<const AtlasBlock> block;
    std::uint64_t last_use = 0;
  };
  struct Part {
    std::shared_ptr<const AtlasBlock> block;
    double weight;
  };

  [[nodiscard]] Footprint reduced(const Footprint& footprint) const;
  [[nodiscard]] std::vector<SplineFootprint::Node> missing(const SplineLattice& lattice,
                                                           const SplineFootprint& spline) const;
  // Nothing where one is missing.
  [[nodiscard]] std::vector<Part> parts(const SplineLattice& lattice, const SplineFootprint& spline) const;
  void forget_until_it_fits(std::size_t more);

  Surface surface_;
  double intrinsic_roughness_;
  MixtureSettings settings_;
  PndfGrid grid_;
  std::size_t most_bytes_;
  mutable std::mutex mutex_;
  mutable std::map<Key, Kept> kept_;  // last_use changes
  std::size_t bytes_ = 0;
  std::uint64_t uses_ = 0;
};

}  // namespace glint
