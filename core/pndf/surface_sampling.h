#pragma once
// Drawing normals from D_P itself: a position of the footprint, the surface's normal there, the roughness.

#include <glm/vec2.hpp>

#include "core/math/gaussian.h"
#include "core/math/random.h"
#include "core/pndf/footprint.h"
#include "core/surface/surface.h"

namespace glint {

/// u ~ G_p, s = n(u) + sigma_r xi: its density is exactly D_P(s) on that surface.
class SurfaceSampler {
 public:
  SurfaceSampler(const Surface& surface, const Footprint& footprint, double intrinsic_roughness);

  /// Four standard normal deviates in, one projected normal out; |s| >= 1 is an invalid normal.
  [[nodiscard]] glm::dvec2 normal(const double (&deviates)[4]) const;
  [[nodiscard]] glm::dvec2 sample(RandomStream& random) const;

 private:
  const Surface& surface_;
  glm::dvec2 center_;
  CholeskyFactor factor_;
  double intrinsic_roughness_;
};

}  // namespace glint
