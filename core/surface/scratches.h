#pragma once
// Scratched metal: many fine engraved lines over gentle dents (Yan et al. 2014, the cutlery), periodic.

#include <cstdint>

#include <glm/vec2.hpp>

#include "core/math/parallel.h"
#include "core/math/result.h"
#include "core/surface/normal_map.h"

namespace glint {

/// The defaults are worn steel: many fine, shallow lines in every direction, a few of them deep, on almost even ground.
struct ScratchSettings {
  int size = 1024;  ///< texels per side, a power of two from 32 to 16384
  std::uint64_t seed = 7;
  int count = 800;  ///< scratches on the whole map, 0 to 100000
  /// Shortest and longest, texels, 1 to 16384; log-uniform. One that is longer than the map comes round again.
  glm::dvec2 length{40, 800};
  glm::dvec2 half_width{0.5, 1.1};    ///< w, texels, 0.25 to 64; uniform
  glm::dvec2 flank_slope{0.03, 0.3};  ///< largest slope of a flank before the blur, 0.001 to 10; uniform
  double direction = 0;               ///< mean, degrees from the u axis towards the top of the picture, -360 to 360
  double spread = 90;                 ///< largest deviation from it, degrees, 0 to 90; 90 is every direction
  double blur = 0.5;                  ///< standard deviation of the Gaussian blur of the heights, texels, 0 to 16
  double dent_rms_slope = 0.012;      ///< RMS slope per axis of the dents (Gaussian spectrum, l = 6 texels), 0 to 10

  friend bool operator==(const ScratchSettings&, const ScratchSettings&) = default;
};

/// Engraved scratches over dents as a normal map that repeats seamlessly.
/// The same settings give the same bytes for any number of threads. A setting outside its range, or more scratches than
/// can be drawn in some ten seconds, is an error about its field (surface.generator.count, ...); so is a cancelled job.
Result<NormalMap> generate_scratches(const ScratchSettings& settings, JobControl& control);

}  // namespace glint
