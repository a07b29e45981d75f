#include "core/pndf/surface_sampling.h"

#include "core/pndf/cell_visit.h"

namespace glint {

SurfaceSampler::SurfaceSampler(const Surface& surface, const Footprint& footprint, double intrinsic_roughness)
    : surface_(surface),
      center_(reduced_center(surface.map(), footprint.center)),
      factor_(cholesky(footprint.covariance)),
      intrinsic_roughness_(intrinsic_roughness) {}

glm::dvec2 SurfaceSampler::normal(const double (&deviates)[4]) const {
  const glm::dvec2 u = center_ + factor_.apply({deviates[0], deviates[1]});
  return surface_.normal(u) + intrinsic_roughness_ * glm::dvec2(deviates[2], deviates[3]);
}

glm::dvec2 SurfaceSampler::sample(RandomStream& random) const {
  double deviates[4];
  random.fill_normal(deviates);
  return normal(deviates);
}

}  // namespace glint
