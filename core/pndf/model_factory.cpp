#include "core/pndf/model_factory.h"

namespace glint {

std::unique_ptr<PndfModel> make_model(PndfMethod method, const Surface& surface, double intrinsic_roughness,
                                      const ModelSettings& settings) {
  switch (method) {
    case PndfMethod::exact:
      if (settings.precision == ExactPrecision::single_precision) {
        return std::make_unique<FastExactPndf>(surface, intrinsic_roughness, settings.exact);
      }
      return std::make_unique<ExactPndf>(surface, intrinsic_roughness, settings.exact);
    case PndfMethod::mixture:
      return std::make_unique<MixturePndf>(surface, intrinsic_roughness, settings.mixture, settings.atlas);
    case PndfMethod::lean:
      return std::make_unique<LeanPndf>(surface, intrinsic_roughness);
    case PndfMethod::automatic:
      return std::make_unique<AutoPndf>(surface, intrinsic_roughness, settings.automatic, settings.atlas);
    case PndfMethod::binning:
      return std::make_unique<BinnedPndf>(surface, intrinsic_roughness, settings.binned);
  }
  return nullptr;
}

}  // namespace glint
