#pragma once
// The pixel footprint: a normalised 2D Gaussian over the map, G_p(u) = N(u; centre, covariance).

#include <optional>
#include <string>

#include <glm/vec2.hpp>

#include "core/math/gaussian.h"

namespace glint {

struct Footprint {
  glm::dvec2 center{0, 0};               ///< texels
  SymmetricMatrix2 covariance{1, 0, 1};  ///< texels squared

  friend bool operator==(const Footprint&, const Footprint&) = default;
};

/// sigma = radius texels in every direction.
Footprint isotropic_footprint(glm::dvec2 center, double radius);

/// The k-th of `count` evenly spread standard normal points: Vogel's spiral with the radii of a 2D Gaussian.
glm::dvec2 spread_deviate(int k, int count);

/// What is wrong with it, as half a sentence, or nothing: finite, positive definite, deviations at most 10^5 texels.
std::optional<std::string> footprint_fault(const Footprint& footprint);

}  // namespace glint
