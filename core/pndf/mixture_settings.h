#pragma once
// What a Gaussian mixture is made of (Yan et al. 2016): the kind of its elements and the lattice of their seeds.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include <glm/vec2.hpp>

#include "core/surface/surface.h"

namespace glint {

/// Elements without a Jacobian; with it, as in the paper; or besides with seeds s_i = n(u_i) + sigma_h^2 / 2 (n_uu +
/// n_vv), which takes the bias of first-order elements away: errors of order h^4 rather than h^2.
enum class MixtureElements { flat, curved, corrected };

inline constexpr double k_least_step = 0.05;
inline constexpr double k_largest_step = 8;

struct MixtureSettings {
  double step = 0.5;            ///< h, texels between seeds, 0.05 to 8
  std::optional<double> kappa;  ///< sigma_h / h; none: automatic_kappa(step)
  MixtureElements elements = MixtureElements::corrected;
  /// Neighbours that are nearly alike are merged into one Gaussian where that moves less than this share of their
  /// weight, for the roughness and footprint at hand (a bound, see ElementMerger); 0: never.
  double merge_bound = 5e-3;

  friend bool operator==(const MixtureSettings&, const MixtureSettings&) = default;
};

inline MixtureSettings mixture_of_step(double step) {
  MixtureSettings settings;
  settings.step = step;
  return settings;
}

/// 1 / sqrt(8 ln 2), the papers' (the seeds' Gaussians meet at half their height); 1/2 for steps up to 1/4.
inline double automatic_kappa(double step) {
  return step > 0.25 ? 0.42466090014400953 : 0.5;
}

/// Seeds u = ((k + 1/2) step.x, (l + 1/2) step.y) for all integers k, l. A whole number of them fits into the map, so
/// the steps may differ a little from what was asked and from each other.
struct MixtureLattice {
  glm::dvec2 step;
  double deviation;  ///< sigma_h, texels: of the wider step, so that elements meet along both axes

  MixtureLattice(const NormalMap& map, const MixtureSettings& settings) {
    const auto fitting = [&](int size) { return size / std::max(1.0, std::round(size / settings.step)); };
    step = {fitting(map.width()), fitting(map.height())};
    deviation = settings.kappa.value_or(automatic_kappa(settings.step)) * std::max(step.x, step.y);
  }

  [[nodiscard]] double area() const { return step.x * step.y; }
};

}  // namespace glint
