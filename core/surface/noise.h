#pragma once
// Random rough surfaces, periodic, from their spectrum: the tool needs no file to show something.

#include <cstdint>

#include <glm/vec2.hpp>

#include "core/math/parallel.h"
#include "core/math/result.h"
#include "core/surface/normal_map.h"

namespace glint {

struct NoiseSettings {
  enum class Spectrum {
    gaussian,  ///< Gaussian autocorrelation exp(-x^2 / l^2) of the heights, through an FFT
    band,      ///< the sum of 200 plane waves with wavelengths in an interval: the map of the speed tables
  };

  int size = 1024;  ///< texels per side, 8 to 16384; a power of two for Spectrum::gaussian
  std::uint64_t seed = 7;
  Spectrum spectrum = Spectrum::band;
  /// Root mean square over both slope components, hit exactly; 0 (a flat map) to 10.
  double rms_slope = 0.15;
  double correlation_length = 8;  ///< l in texels, 1.5 to size / 4; Spectrum::gaussian only
  glm::dvec2 wavelengths{8, 32};  ///< shortest and longest, texels, 2 to size; Spectrum::band only

  friend bool operator==(const NoiseSettings&, const NoiseSettings&) = default;
};

/// An isotropic random height field of the given spectrum as a normal map that repeats seamlessly.
/// The same settings give the same bytes for any number of threads. A setting outside its range is an error about its
/// field (surface.generator.rms_slope, ...); so is a cancelled job.
Result<NormalMap> generate_noise(const NoiseSettings& settings, JobControl& control);

}  // namespace glint
