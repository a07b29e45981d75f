#pragma once
// The P-NDF as a Gaussian mixture (Yan et al. 2016): the position-normal distribution as 4D Gaussians seeded on a
// lattice over the map, each sheared by the map's Jacobian; in closed form under a Gaussian footprint.

#include <atomic>
#include <memory>
#include <mutex>

#include "core/pndf/fast_exact_pndf.h"
#include "core/pndf/mixture_atlas.h"
#include "core/pndf/mixture_bounds.h"
#include "core/pndf/mixture_settings.h"
#include "core/pndf/pndf_model.h"

namespace glint {

/// Elements are implicit in the map: nothing is stored of them, whatever the step, but bounds of those that queries
/// came across. A model of the smooth surface, off by O(h^2), or O(h^4) with corrected elements; of the constant
/// surface, for which its elements are flat. Images cut jointly at R = 4.2 and are scaled by what that loses, 1.5e-3 of
/// the mass; single normals cut at R = 5. Footprints that reach far beyond the map, or to which single precision does
/// not do, and a roughness below 1e-6 are evaluated exactly.
///
/// Where a lattice and the texels are commensurate (h = 1/n or n, which divides the map), the first normals of a
/// footprint are evaluated without preparing it; it is prepared once they took as long as that takes. Values before and
/// after differ in what single precision does not tell.
class MixturePndf final : public PndfModel {
 public:
  static constexpr double k_image_cut = 4.2;
  static constexpr double k_query_cut = 5;

  /// `intrinsic_roughness` is sigma_r in (0, 1]. A linear surface is taken as the smooth one through its samples.
  /// Images of footprints whose blocks the atlas holds are taken from it, if it is of the same surface, roughness,
  /// settings and grid.
  MixturePndf(const Surface& surface, double intrinsic_roughness, const MixtureSettings& settings = {},
              std::shared_ptr<const MixtureAtlas> atlas = nullptr);

  /// The surface that a mixture over `surface` models.
  static Surface modelled(const Surface& surface);

  [[nodiscard]] PndfModelInfo info() const override;
  FootprintPndf& at(const Footprint& footprint, PndfWorkspace& workspace) const override;
  [[nodiscard]] std::optional<PndfImage> image(const Footprint& footprint, const PndfGrid& grid,
                                               JobControl& control) const override;

 private:
  /// Built when a footprint first asks for it.
  const FastExactPndf& exact() const;
  /// Likewise; nothing where lattice and texels are not commensurate.
  const MixtureBounds* bounds() const;

  Surface surface_;
  double intrinsic_roughness_;
  MixtureSettings settings_;
  std::shared_ptr<const MixtureAtlas> atlas_;
  mutable std::once_flag exact_built_;
  mutable std::unique_ptr<const FastExactPndf> exact_;
  mutable std::once_flag bounds_built_;
  mutable std::unique_ptr<const MixtureBounds> bounds_;
  mutable std::atomic<const MixtureBounds*> bounds_in_use_{nullptr};
};

}  // namespace glint
