#pragma once
// Metallic paint: flakes that do not overlap, each flat and turned its own way (Yan et al. 2014 and 2016, the car
// paints), periodic. As a map of their Voronoi cells, or one by one for core/pndf/flake_pndf.h.

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "core/math/parallel.h"
#include "core/math/result.h"
#include "core/surface/normal_map.h"

namespace glint {

struct FlakeSettings {
  int size = 1024;  ///< texels per side, 8 to 16384
  std::uint64_t seed = 7;
  /// Poisson-disk radius: no two centres are nearer, and no place is farther from the nearest centre; texels, within
  /// flake_radii(size).
  double radius = 6;
  double alpha = 0.3;     ///< Beckmann roughness of the slopes, whose variance is alpha^2 / 2 per axis; 0 to 10
  double flat_share = 0;  ///< share of flakes without a slope, 0 to 1

  friend bool operator==(const FlakeSettings&, const FlakeSettings&) = default;
};

/// The smallest and the largest radius on a map of that size: one texel, or a radius that leaves some six million
/// flakes, which take some twenty seconds, rounded up to a thousandth, as people read it; and a quarter of the map.
glm::dvec2 flake_radii(int size);

/// A flat flake.
struct Flake {
  glm::dvec2 center;  ///< texels
  glm::dvec2 normal;  ///< (s, t)
};

/// The flakes themselves, some 0.7 / radius^2 a texel, centres in [0, size). Slopes are drawn from the Beckmann P22:
/// flakes share the map's area, not their own. Neither alpha nor flat_share moves a centre. Errors as below.
Result<std::vector<Flake>> place_flakes(const FlakeSettings& settings, JobControl& control);

/// Every texel has the normal of the flake whose centre is nearest to its middle, over the border too: a map that is
/// piecewise constant and repeats seamlessly.
/// The same settings give the same bytes for any number of threads. A setting outside its range is an error about its
/// field (surface.generator.radius, ...); so is a cancelled job.
Result<NormalMap> generate_flakes(const FlakeSettings& settings, JobControl& control);

}  // namespace glint
