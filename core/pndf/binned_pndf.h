#pragma once
// The P-NDF by binning (the ground truth of both Yan papers): draw positions of the footprint, add roughness, count
// normals in square cells.

#include <cstdint>

#include "core/pndf/pndf_model.h"

namespace glint {

struct BinnedSettings {
  std::uint64_t samples = 1'000'000;  ///< independent draws
  std::uint64_t seed = 1;
  int bins = 256;  ///< bins a side of the fitted window, for single normals; an image's bins are its cells
};

/// Estimates the *mean over a bin* of D_P, never its value at a point. Draws are independent (not stratified), so the
/// standard error of a cell is sqrt(D / (samples x area)); the counts do not depend on the number of threads. At single
/// normals the answer is the bin that holds s, 0 outside the fitted window.
class BinnedPndf final : public PndfModel {
 public:
  BinnedPndf(Surface surface, double intrinsic_roughness, BinnedSettings settings = {});

  [[nodiscard]] PndfModelInfo info() const override;
  FootprintPndf& at(const Footprint& footprint, PndfWorkspace& workspace) const override;
  [[nodiscard]] std::optional<PndfImage> image(const Footprint& footprint, const PndfGrid& grid,
                                               JobControl& control) const override;

  [[nodiscard]] const Surface& surface() const { return surface_; }
  [[nodiscard]] double intrinsic_roughness() const { return intrinsic_roughness_; }

 private:
  Surface surface_;
  double intrinsic_roughness_;
  BinnedSettings settings_;
};

}  // namespace glint
