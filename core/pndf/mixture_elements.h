#pragma once
// The elements of a mixture one by one, in a part of the map: where they lie, what they weigh under a footprint, and
// what each adds to the density at one normal. For showing what a density is made of; evaluation does not need it.

#include <vector>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include "core/pndf/mixture_rows.h"

namespace glint {

/// w_i N(s; mean, covariance), as the footprint sees it (MixtureFrame).
struct MixtureElement {
  glm::dvec2 seed;  ///< u_i, texels, in the plane of the footprint's centre: beyond the map where that reaches there
  glm::dvec2 mean;  ///< of s
  Whitening whitening;  ///< of the covariance of s
  double weight;        ///< w_i; those of all elements add up to 1, but for the ripple of their lattice
  double room;          ///< squared distance of s, in deviations, from which on it counts as nothing (the joint cut)

  /// What it adds to D_P(s), per unit of disk area. Those of all elements add up to what the mixture says at s.
  [[nodiscard]] double density(glm::dvec2 s) const;
};

/// A part of the plane, texels.
struct PlaneRectangle {
  glm::dvec2 min{0, 0};
  glm::dvec2 max{0, 0};
};

/// The frame by which a mixture answers single normals. The surface's map must outlive it.
MixtureFrame element_frame(const Surface& surface, const MixtureSettings& settings, const Footprint& footprint,
                           double intrinsic_roughness);

/// How many seeds `elements_in` looks at, about: whole rows of those that the footprint reaches.
double seeds_visited(const MixtureFrame& frame, const PlaneRectangle& part);

/// The elements within the frame's cut whose seeds lie in that part of the plane, by rows. `reused` gives its memory:
/// for many thousands, having that is most of the time.
std::vector<MixtureElement> elements_in(const MixtureFrame& frame, const PlaneRectangle& part,
                                        std::vector<MixtureElement> reused = {});

/// How what an element adds to D_P(s) is spread over the plane: proportional to N(u; center, covariance). All of the
/// element, as the footprint cuts it, where it is flat; a sliver along which its normal is s where the surface turns by
/// more than the roughness.
struct ElementPart {
  glm::dvec2 center;            ///< texels, in the plane of the footprint's centre
  SymmetricMatrix2 covariance;  ///< texels squared
};

/// J of the element with that seed; 0 of flat ones. `surface` is that of the frame.
glm::dmat2 element_jacobian(const MixtureFrame& frame, const Surface& surface, glm::dvec2 seed);

/// With u ~ N(seed - K o, Sigma_e) and s given u ~ N(mean + J (u - seed + K o), diag(roughness^2)), u given s:
/// precision Sigma_e^-1 + J^T diag(roughness^-2) J.
ElementPart part_towards(const MixtureFrame& frame, const MixtureElement& element, const glm::dmat2& jacobian,
                         glm::dvec2 s);

}  // namespace glint
