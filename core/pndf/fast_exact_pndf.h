#pragma once
// The exact P-NDF (Yan et al. 2014, section 4) in single precision with vector instructions: the default way to look.
// ExactPndf is the double-precision reference that it is held against.

#include <memory>
#include <mutex>

#include "core/pndf/exact_pndf.h"
#include "core/pndf/normal_bounds.h"

namespace glint {

/// Images cut jointly at d_u^2 + d_s^2 < R^2, R = 5, single normals at R = 4.8, which loses at most
/// exp(-R^2 / 2) (1 + R^2 / 2) = 5e-5 and 1.3e-4 of the mass, and of one triangle at most exp(-R^2 / 2) = 1e-5 of its
/// scale; measured, images and single normals are within 1e-4
/// (relative L1) of ExactPndf on the same surface. Triangles too long for single precision, folded footprints,
/// footprints so elongated and turned that their whitening cancels and, for single normals, the constant surface,
/// a roughness below 1e-6 and footprints that leave a map that clamps are evaluated by ExactPndf.
class FastExactPndf final : public PndfModel {
 public:
  static constexpr double k_image_cut = 5;
  static constexpr double k_query_cut = 4.8;

  /// `intrinsic_roughness` is sigma_r in (0, 1]. Images cut at k_image_cut, or at settings.image_cut if that is less.
  FastExactPndf(Surface surface, double intrinsic_roughness, const ExactSettings& settings = {});

  [[nodiscard]] PndfModelInfo info() const override;
  FootprintPndf& at(const Footprint& footprint, PndfWorkspace& workspace) const override;
  [[nodiscard]] std::optional<PndfImage> image(const Footprint& footprint, const PndfGrid& grid,
                                               JobControl& control) const override;

 private:
  /// Built when single normals are first asked for: images do without.
  const NormalBounds& bounds() const;

  ExactPndf exact_;
  mutable std::once_flag bounds_built_;
  mutable std::unique_ptr<const NormalBounds> bounds_;
};

}  // namespace glint
