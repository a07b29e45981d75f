#pragma once
// The methods of this build, and how one is made.

#include <memory>

#include "core/pndf/auto_pndf.h"
#include "core/pndf/binned_pndf.h"
#include "core/pndf/exact_pndf.h"
#include "core/pndf/fast_exact_pndf.h"
#include "core/pndf/lean_pndf.h"
#include "core/pndf/mixture_pndf.h"
#include "core/pndf/pndf_model.h"

namespace glint {

enum class PndfMethod { exact, mixture, lean, automatic, binning };

/// What exact evaluation computes in: FastExactPndf or ExactPndf.
enum class ExactPrecision { single_precision, double_precision };

/// Everything any method asks for beyond the surface and sigma_r.
struct ModelSettings {
  ExactSettings exact;
  ExactPrecision precision = ExactPrecision::single_precision;
  MixtureSettings mixture;
  AutoSettings automatic;
  BinnedSettings binned;
  std::shared_ptr<const MixtureAtlas> atlas;  ///< that mixtures look wide footprints up in, or null
};

std::unique_ptr<PndfModel> make_model(PndfMethod method, const Surface& surface, double intrinsic_roughness,
                                      const ModelSettings& settings);

}  // namespace glint
