#pragma once
// Normals drawn from a mixture under one footprint, exactly as its evaluation has them.

#include "core/math/random.h"
#include "core/pndf/mixture_rows.h"

namespace glint {

/// A normal whose density is D_P(s) over the sum of the elements' weights, without any cut.
glm::dvec2 sample_mixture(const MixtureFrame& frame, RandomStream& random);

}  // namespace glint
