#pragma once
// D_P(s) of a mixture at single normals without preparing their footprint: bounds of means find the few cells of the
// map whose elements can matter, 16 a test, and only those elements are made.

#include <glm/vec2.hpp>

#include "core/pndf/footprint_window.h"
#include "core/pndf/mixture_bounds.h"
#include "core/pndf/mixture_rows.h"

namespace glint {

/// What all queries of one footprint have in common. Immutable; shared between threads.
struct MixtureSearch {
  /// `frame` must be of the map, settings and roughness of `bounds`.
  MixtureSearch(const MixtureFrame& frame, const MixtureBounds& bounds);

  /// False for one that sees all of the map alike or leaves a map that clamps.
  static bool can_search(const MixtureFrame& frame);

  /// D_P(s): never negative, NaN or infinite; that of PreparedMixture as far as single precision tells. Adds what it
  /// took to `spent`: about how many elements are prepared in that time.
  double density(glm::dvec2 s, double& spent) const;

  const MixtureBounds* bounds;
  FootprintWindow window;  ///< of V
  double cut;
  glm::dvec2 first;     ///< offset of where cell 0 begins from the footprint's centre
  float w11, w12, w22;  ///< whitening of V
  float k_xx, k_xy, k_yy;
  float l11, l21, l22;
  float weight;
  float pull;  ///< rho, see mixture_search.cpp
};

}  // namespace glint
