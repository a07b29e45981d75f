#pragma once
// The exact method as Yan et al. publish it in 2014 (section 4), for the benchmark alone: the Gaussian over a triangle
// as integrals along its edges of exp(-x^2 / 2) erf(a x + b), with erf replaced by six quadratics. The whitening is our
// own (QR), so that what is compared is the integral.

#include "core/math/simplex_integral.h"
#include "core/pndf/exact_pndf.h"

namespace glint::bench {

/// Of the whitened triangle, in simplex coordinates, as gaussian_over_simplex().
double six_quadratics_over_simplex(const WhitenedTriangle& t);

/// A whole image on the calling thread, triangle by triangle, cut where FastExactPndf cuts.
PndfImage six_quadratics_image(const ExactPndf& model, const Footprint& footprint, const PndfGrid& grid);

}  // namespace glint::bench
