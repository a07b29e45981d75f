#pragma once
// One triangle of the surface under one footprint: its contribution to D_P(s), prepared for many s.

#include <array>
#include <functional>

#include <glm/vec2.hpp>

#include "core/math/gaussian.h"
#include "core/math/simplex_integral.h"
#include "core/pndf/surface_cells.h"

namespace glint {

/// Integral over the triangle of G_p(u) G_r(n(u) - s) du, n affine (Yan et al. 2014, section 4), whitened by a
/// Householder QR factorisation of [W E; dn / sigma_r]: no collapsed mean or covariance is formed, nothing is divided
/// by det J, and constant or degenerate normals need no special case.
class TriangleKernel {
 public:
  /// `roughness` is sigma_r on each axis (they differ in images whose cells are not square).
  TriangleKernel(const SurfaceTriangle& triangle, const Whitening& whitening, glm::dvec2 roughness);

  /// The contribution to D_P(s), per unit of disk area; relative error below 1e-9. What lies beyond `cut` joint
  /// deviations (of footprint and roughness together) may be left out. Zero for a triangle without area.
  [[nodiscard]] double density(glm::dvec2 s, double cut) const;

  /// The triangle in whitened coordinates, without its position: r11, r12, r22.
  [[nodiscard]] const WhitenedTriangle& shape() const { return shape_; }

 private:
  glm::dvec2 roughness_;
  glm::dvec2 corner_normal_;
  glm::dvec2 whitened_corner_;
  std::array<double, 4> first_{};  // Householder vectors, scaled so that H = I - v v^T
  std::array<double, 3> second_{};
  WhitenedTriangle shape_{};
  double factor_ = 0;
};

/// Integral over the triangle of weight(u) G_r(n(u) - s) du for a weight that is smooth over a cell: used where the
/// footprint is wide and folded. `cut` counts deviations of the roughness. Offsets of the triangle are positions in the
/// cell, both coordinates in [0, 1].
double weighted_density(const SurfaceTriangle& triangle, glm::dvec2 s, glm::dvec2 roughness, double cut,
                        const std::function<double(glm::dvec2)>& weight);

}  // namespace glint
