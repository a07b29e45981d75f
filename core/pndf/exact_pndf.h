#pragma once
// Exact P-NDF (Yan et al. 2014, section 4): the integral of the footprint times the roughness over every triangle of
// the surface, in double precision. The reference that every other method is held against.

#include <memory>

#include "core/pndf/pndf_model.h"
#include "core/pndf/surface_cells.h"

namespace glint {

struct ExactSettings {
  int subdivision = 4;        ///< smooth surface: sub-cells per axis and texel; 4 is the 32-triangle map
  bool vertex_shift = false;  ///< smooth surface: vertices moved so that the triangles lose their O(h^2) bias
  double image_cut = 6;       ///< images: the joint cut R; exp(-R^2 / 2) (1 + R^2 / 2) of the mass is lost
  /// Images: cells hold the mean of D over them, by widening sigma_r^2 by pitch^2 / 12 per axis however fine the grid
  /// is; else only where the grid does not resolve sigma_r.
  bool cell_means = false;
};

/// Evaluation at single normals cuts where the neglected rest is below 1e-9 of the value (it widens its cut until that
/// holds). Images cut jointly at d_u^2 + d_s^2 < R^2; R = 6 loses 2.9e-7 of the mass. A folded footprint (see
/// FoldedFootprint) has absolute accuracy: 1e-8 of a value holds while that is above 1e-6 of the peak.
class ExactPndf final : public PndfModel {
 public:
  static constexpr double k_folded_cut = 7.5;  ///< of single normals under a folded footprint, at first

  /// `intrinsic_roughness` is sigma_r in (0, 1].
  ExactPndf(Surface surface, double intrinsic_roughness, ExactSettings settings = {});

  [[nodiscard]] PndfModelInfo info() const override;
  FootprintPndf& at(const Footprint& footprint, PndfWorkspace& workspace) const override;
  [[nodiscard]] std::optional<PndfImage> image(const Footprint& footprint, const PndfGrid& grid,
                                               JobControl& control) const override;

  [[nodiscard]] const SurfaceCells& cells() const { return cells_; }
  [[nodiscard]] double intrinsic_roughness() const { return intrinsic_roughness_; }
  [[nodiscard]] double image_cut() const { return image_cut_; }
  [[nodiscard]] bool cell_means() const { return cell_means_; }

 private:
  SurfaceCells cells_;
  double intrinsic_roughness_;
  double image_cut_;
  bool cell_means_;
};

}  // namespace glint
