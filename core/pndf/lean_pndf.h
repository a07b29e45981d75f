#pragma once
// The P-NDF as one Gaussian over slopes with the mean and the covariance that the slopes have under the footprint (LEAN
// mapping, Olano and Baker 2010; under glints, Chermain et al. 2021).

#include <atomic>
#include <memory>
#include <mutex>

#include "core/pndf/lean_moments.h"
#include "core/pndf/pndf_model.h"
#include "core/pndf/slope_gaussian.h"

namespace glint {

/// D(s) = N(m; mu, C + sigma_r^2 I) / z^4, m = -s / z. A model of the smooth surface, or of the constant one: right in
/// its first two moments of slopes, however many glints lie within. Its error against the surface falls about as the
/// footprint's deviation grows. Where footprints ask for it, the chain of moments is built once: 1.7 bytes a texel.
class LeanPndf final : public PndfModel {
 public:
  /// `intrinsic_roughness` is sigma_r in (0, 1], taken as the deviation of slopes, which it is near z = 1. A linear
  /// surface is taken as the smooth one through its samples.
  LeanPndf(const Surface& surface, double intrinsic_roughness);

  [[nodiscard]] PndfModelInfo info() const override;
  FootprintPndf& at(const Footprint& footprint, PndfWorkspace& workspace) const override;
  [[nodiscard]] std::optional<PndfImage> image(const Footprint& footprint, const PndfGrid& grid,
                                               JobControl& control) const override;

  /// Of the slopes under a footprint free of faults, without sigma_r.
  [[nodiscard]] SlopeMoments moments(const Footprint& footprint) const;
  /// Built when it is first asked for.
  [[nodiscard]] const LeanMoments& chain() const;

 private:
  Surface surface_;
  double intrinsic_roughness_;
  mutable std::once_flag chain_built_;
  mutable std::unique_ptr<const LeanMoments> chain_;
  mutable std::atomic<std::size_t> chain_bytes_{0};
};

}  // namespace glint
