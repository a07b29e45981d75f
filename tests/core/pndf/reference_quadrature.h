#pragma once
// A slow, plain twin of exact evaluation, for tests only: every triangle within 7.5 deviations is cut until its edges
// are short and then integrated by product Gauss rules directly in u. Nothing here is shared with core but the texels.

#include <array>
#include <vector>

#include <glm/vec2.hpp>

#include "core/math/random.h"
#include "core/pndf/footprint.h"
#include "core/surface/surface.h"

namespace glint::test {

/// N(d; 0, covariance), with the determinant in extended precision.
double slow_normal_density(glm::dvec2 d, const SymmetricMatrix2& covariance);

/// The first two moments of the normals under the footprint.
struct NormalMoments {
  double mass;  ///< 1, as far as the quadrature goes
  glm::dvec2 mean;
  SymmetricMatrix2 covariance;
};

class SlowPndf {
 public:
  /// `subdivision` as in ExactSettings; `roughness` is sigma_r on each axis. The map must outlive it.
  SlowPndf(const Surface& surface, int subdivision, const Footprint& footprint, glm::dvec2 roughness);

  /// D_P(s).
  [[nodiscard]] double density(glm::dvec2 s) const;
  /// n(u) for a position drawn from the footprint: on the triangles, not on the smooth surface between them.
  [[nodiscard]] glm::dvec2 draw_normal(RandomStream& random) const;
  /// Of n(u), without roughness.
  [[nodiscard]] NormalMoments moments() const;
  /// The limit sigma_r -> 0: the sum of G_p / |det J| over all u with n(u) = s. `margin`: the smallest barycentric
  /// coordinate of any root or near miss: where it is small, the limit is approached slowly.
  struct RootSum {
    double density;
    double margin;
  };
  [[nodiscard]] RootSum roots(glm::dvec2 s) const;

 private:
  struct Triangle {
    std::array<glm::dvec2, 3> white;  // whitened offsets from the footprint's centre
    std::array<glm::dvec2, 3> normals;
    double area;
  };
  void add_cell(const Surface& surface, long i, long j, int subdivision, const Footprint& footprint);

  std::vector<Triangle> triangles_;
  glm::dvec2 roughness_;
  std::array<long double, 3> whitening_;
};

/// D_P(s) of the bicubic surface itself, by a dense product rule.
double slow_smooth_density(const Surface& surface, const Footprint& footprint, double roughness, glm::dvec2 s);

}  // namespace glint::test
