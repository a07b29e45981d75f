#pragma once
// The three surfaces that can lie between the samples of a normal map. Every model and every error names its own.

#include <cstdint>
#include <memory>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include "core/surface/normal_map.h"

namespace glint {

enum class Interpolation {
  linear,    ///< two triangles per cell between four texel centres, cut from (u1, v0) to (u0, v1)
  smooth,    ///< bicubic Catmull-Rom of (s, t)
  constant,  ///< one normal per texel square
};

/// Immutable; safe to share between threads. Positions are texels, brought inside by the map's wrap.
class Surface {
 public:
  Surface(std::shared_ptr<const NormalMap> map, Interpolation interpolation);

  [[nodiscard]] const NormalMap& map() const { return *map_; }
  [[nodiscard]] const std::shared_ptr<const NormalMap>& shared_map() const { return map_; }
  [[nodiscard]] Interpolation interpolation() const { return interpolation_; }

  /// The projected normal n(u) = (s, t); overshoot of the smooth surface beyond the disk is kept.
  [[nodiscard]] glm::dvec2 normal(glm::dvec2 u) const;
  /// J = dn/du per texel; column 0 is dn/du, column 1 is dn/dv. On an edge of the linear surface, that of the triangle
  /// on its lower or right side; zero on the constant surface.
  [[nodiscard]] glm::dmat2 jacobian(glm::dvec2 u) const;

 private:
  std::shared_ptr<const NormalMap> map_;
  Interpolation interpolation_;
};

}  // namespace glint
