#include "core/pndf/fast_exact_pndf.h"

#include <algorithm>
#include <utility>

namespace glint {
namespace {

ExactSettings with_image_cut(ExactSettings settings) {
  settings.image_cut = std::min(settings.image_cut, FastExactPndf::k_image_cut);
  return settings;
}

}  // namespace

FastExactPndf::FastExactPndf(Surface surface, double intrinsic_roughness, const ExactSettings& settings)
    : exact_(std::move(surface), intrinsic_roughness, with_image_cut(settings)) {}

PndfModelInfo FastExactPndf::info() const {
  PndfModelInfo info = exact_.info();
  info.guarantee = "exact for its triangles, images in single precision within 1e-4";
  return info;
}

FootprintPndf& FastExactPndf::at(const Footprint& footprint, PndfWorkspace& workspace) const {
  return exact_.at(footprint, workspace);
}

}  // namespace glint
