// Generates a rough surface and measures the slope it asked for.

#include <cmath>
#include <cstdio>

#include "core/math/parallel.h"
#include "core/surface/noise.h"

int main() {
  glint::NoiseSettings settings;
  settings.size = 64;
  settings.spectrum = glint::NoiseSettings::Spectrum::gaussian;
  settings.rms_slope = 0.2;
  glint::JobControl control;
  const glint::Result<glint::NormalMap> map = glint::generate_noise(settings, control);
  if (!map) {
    std::fprintf(stderr, "%s\n", map.error().message().c_str());
    return 1;
  }

  double squares = 0;
  for (const glm::dvec2 normal : map->normals()) {
    const double squared_tangent = normal.x * normal.x + normal.y * normal.y;
    squares += squared_tangent / (1 - squared_tangent);
  }
  const double rms_slope = std::sqrt(squares / (2.0 * settings.size * settings.size));
  std::printf("RMS slope %.6f\n", rms_slope);
  return std::abs(rms_slope - settings.rms_slope) < 1e-3 ? 0 : 1;
}
