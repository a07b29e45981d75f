#include "core/study/reference.h"

#include <cmath>
#include <utility>

#include "core/pndf/exact_pndf.h"
#include "core/study/error_metrics.h"

namespace glint {
namespace {
constexpr double k_converged = 2e-4;
constexpr int k_finest_subdivision = 32;
constexpr double k_reference_cut = 8;

struct Request {
  const Surface& surface;
  double intrinsic_roughness;
  const Footprint& footprint;
  const PndfGrid& grid;
  JobControl& control;

  [[nodiscard]] std::optional<PndfImage> image(const ExactSettings& settings, const PndfGrid& on) const {
    return ExactPndf(surface, intrinsic_roughness, settings).image(footprint, on, control);
  }
};

// The coarsest subdivision whose image differs from the next coarser one's by less than the limit, and that difference.
struct Convergence {
  int subdivision;
  double change;
};

std::optional<Convergence> converge(const Request& request) {
  std::optional<PndfImage> coarse;
  Convergence found{0, 1};
  for (int subdivision = 4; subdivision <= k_finest_subdivision && found.change >= k_converged; subdivision *= 2) {
    std::optional<PndfImage> fine = request.image({subdivision, true}, request.grid);
    if (!fine) return std::nullopt;
    found = {subdivision, coarse ? compare(*coarse, *fine).relative_l1 : 1};
    coarse = std::move(fine);
  }
  return found;
}

// The mean over each cell by the 2 x 2 Gauss rule: four images on shifted grids.
std::optional<PndfImage> cell_means(const Request& request, const ExactSettings& settings) {
  const glm::dvec2 shift = request.grid.pitch() / (2 * std::sqrt(3.0));
  std::optional<PndfImage> mean;
  for (const glm::dvec2 sign : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(-1, 1), glm::dvec2(1, 1)}) {
    PndfGrid shifted = request.grid;
    shifted.s_min += sign.x * shift.x;
    shifted.s_max += sign.x * shift.x;
    shifted.t_min += sign.y * shift.y;
    shifted.t_max += sign.y * shift.y;
    std::optional<PndfImage> part = request.image(settings, shifted);
    if (!part) return std::nullopt;
    if (!mean) {
      mean = std::move(part);
      for (double& density : mean->density) density *= 0.25;
    } else {
      for (std::size_t k = 0; k < mean->density.size(); ++k) mean->density[k] += 0.25 * part->density[k];
    }
  }
  mean->grid = request.grid;
  return mean;
}

}  // namespace

std::optional<ReferenceImage> reference_image(const Surface& surface, double intrinsic_roughness,
                                              const Footprint& footprint, const PndfGrid& grid, CellContent content,
                                              JobControl& control) {
  const Request request{surface, intrinsic_roughness, footprint, grid, control};
  ExactSettings settings;
  settings.image_cut = k_reference_cut;
  double own_error = 0;
  if (surface.interpolation() == Interpolation::smooth) {
    const std::optional<Convergence> found = converge(request);
    if (!found) return std::nullopt;
    settings.subdivision = found->subdivision;
    settings.vertex_shift = true;
    own_error = found->change;
  }
  const bool widened = widening_for(grid, intrinsic_roughness) != glm::dvec2(0);
  std::optional<PndfImage> image =
      content == CellContent::mean && !widened ? cell_means(request, settings) : request.image(settings, grid);
  if (!image) return std::nullopt;
  if (surface.interpolation() != Interpolation::smooth) own_error = image->error.relative_l1;
  return ReferenceImage{surface.interpolation(), std::move(*image), own_error};
}

}  // namespace glint
