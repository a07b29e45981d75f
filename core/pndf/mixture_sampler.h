#pragma once
// Normals drawn from a mixture under one footprint, exactly as its evaluation has them.

#include "core/math/random.h"
#include "core/pndf/mixture_rows.h"

namespace glint {

/// The integral of D_P(s) over the plane: the elements' weights, which ripple about 1 as their lattice does.
double sum_of_weights(const MixtureFrame& frame);

/// A normal whose density is D_P(s) over that sum, without any cut.
glm::dvec2 sample_mixture(const MixtureFrame& frame, RandomStream& random);

}  // namespace glint
