#include "core/study/reference.h"

#include <utility>

#include "core/pndf/exact_pndf.h"
#include "core/study/error_metrics.h"

namespace glint {
namespace {

constexpr int k_finest_subdivision = 32;

struct Request {
  const Surface& surface;
  double intrinsic_roughness;
  const Footprint& footprint;
  const PndfGrid& grid;
  CellContent content;
  double image_cut;
  JobControl& control;

  [[nodiscard]] std::optional<PndfImage> image(int subdivision, bool vertex_shift) const {
    ExactSettings settings;
    settings.subdivision = subdivision;
    settings.vertex_shift = vertex_shift;
    settings.image_cut = image_cut;
    settings.cell_means = content == CellContent::mean;
    return ExactPndf(surface, intrinsic_roughness, settings).image(footprint, grid, control);
  }
};

struct Refined {
  PndfImage image;
  ReferenceRefinement refinement;
};

// The image of the coarsest subdivision that differs from the next coarser one's by less than the limit.
std::optional<Refined> refine(const Request& request, double converged) {
  std::optional<PndfImage> coarse;
  ReferenceRefinement found{0, 1};
  for (int subdivision = 4; subdivision <= k_finest_subdivision && found.change >= converged; subdivision *= 2) {
    std::optional<PndfImage> fine = request.image(subdivision, true);
    if (!fine) return std::nullopt;
    found = {subdivision, coarse ? compare(*coarse, *fine).relative_l1 : 1};
    coarse = std::move(fine);
  }
  return Refined{*std::move(coarse), found};
}

}  // namespace

std::optional<ReferenceImage> reference_image(const Surface& surface, double intrinsic_roughness,
                                              const Footprint& footprint, const PndfGrid& grid, CellContent content,
                                              JobControl& control, std::optional<ReferenceRefinement> known,
                                              const ReferenceEffort& effort) {
  const Request request{surface, intrinsic_roughness, footprint, grid, content, effort.image_cut, control};
  if (surface.interpolation() != Interpolation::smooth) {
    std::optional<PndfImage> image = request.image(ExactSettings().subdivision, false);
    if (!image) return std::nullopt;
    const double own_error = image->error.bounded + image->error.estimated.value_or(0);
    return ReferenceImage{surface.interpolation(), std::move(*image), own_error, {}};
  }
  if (known) {
    std::optional<PndfImage> image = request.image(known->subdivision, true);
    if (!image) return std::nullopt;
    return ReferenceImage{Interpolation::smooth, std::move(*image), known->change, *known};
  }
  std::optional<Refined> refined = refine(request, effort.converged);
  if (!refined) return std::nullopt;
  return ReferenceImage{Interpolation::smooth, std::move(refined->image), refined->refinement.change,
                        refined->refinement};
}

}  // namespace glint
