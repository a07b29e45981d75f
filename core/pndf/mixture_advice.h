#pragma once
// Where a mixture is used on what it is not made for: detected from a sample of the footprint, said in a sentence.

#include <string>
#include <vector>

#include "core/pndf/footprint.h"
#include "core/pndf/mixture_settings.h"
#include "core/surface/surface.h"

namespace glint {

struct MixtureFinding {
  enum class Kind {
    value_step,      ///< sigma_r is below the step of the map's values
    ripple,          ///< the lattice of the elements shows
    curvature,       ///< first-order elements do not follow the map
    flat_in_pieces,  ///< a map that jumps under a surface that does not
    fitted_step,     ///< h is not what was asked for
  };
  Kind kind;
  std::string sentence;  ///< without a full stop, with the figures
};

/// What is to be said of a mixture over `surface` (MixturePndf::modelled) under this footprint, in the order of Kind;
/// from 256 positions, always the same, in a fraction of a millisecond. It says and does not choose: as measured,
/// neither wider elements (kappa = 1/2 or 0.6) nor flat ones are closer to the surface where these rules fire. Ripple
/// falls by at most 4 % of D, but what a wider element misses of the map's curvature grows by more, except under
/// footprints of a texel on smooth maps; and the smooth surface ramps over its jumps, which flat elements miss and
/// corrected ones follow.
std::vector<MixtureFinding> mixture_findings(const Surface& surface, double intrinsic_roughness,
                                             const MixtureSettings& settings, const Footprint& footprint);

/// What of the ripple of its lattice a mixture shows at the normal of a position with that Jacobian: the larger axis'
/// 2 exp(-2 pi^2 (sigma_h^2 + C_kk) / h_k^2), C = (Sigma_p^-1 + J^T J / sigma_r^2)^-1, relative to D. Flat elements
/// are not sheared, which leaves C alone.
double ripple_amplitude(const glm::dmat2& jacobian, double intrinsic_roughness, const MixtureLattice& lattice,
                        bool flat, const SymmetricMatrix2& footprint);

}  // namespace glint
