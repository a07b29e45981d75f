#include "core/study/reference.h"

#include <utility>

#include "core/pndf/exact_pndf.h"
#include "core/study/error_metrics.h"

namespace glint {
namespace {
constexpr double k_converged = 2e-4;
constexpr int k_finest_subdivision = 32;
}  // namespace

std::optional<ReferenceImage> reference_image(const Surface& surface, double intrinsic_roughness,
                                              const Footprint& footprint, const PndfGrid& grid, JobControl& control) {
  if (surface.interpolation() != Interpolation::smooth) {
    std::optional<PndfImage> image = ExactPndf(surface, intrinsic_roughness).image(footprint, grid, control);
    if (!image) return std::nullopt;
    const double bound = image->error.relative_l1;
    return ReferenceImage{surface.interpolation(), std::move(*image), bound};
  }
  std::optional<PndfImage> coarse;
  double change = 1;
  for (int subdivision = 4; subdivision <= k_finest_subdivision && change >= k_converged; subdivision *= 2) {
    std::optional<PndfImage> fine =
        ExactPndf(surface, intrinsic_roughness, {subdivision, true}).image(footprint, grid, control);
    if (!fine) return std::nullopt;
    if (coarse) change = compare(*coarse, *fine).relative_l1;
    coarse = std::move(fine);
  }
  return ReferenceImage{surface.interpolation(), std::move(*coarse), change};
}

}  // namespace glint
