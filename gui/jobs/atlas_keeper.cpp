#include "gui/jobs/atlas_keeper.h"

namespace glint::gui {
namespace {

// Of its blocks: while a footprint is dragged, making those that come in is quicker than the direct method.
constexpr double k_few = 0.3;

}  // namespace

std::shared_ptr<const MixtureAtlas> AtlasKeeper::for_picture(const Document& document, const MixtureSettings& settings,
                                                             const Surface& surface, const PndfGrid& grid,
                                                             JobControl& control) {
  const Footprint& footprint = document.footprint;
  forget_another_map(surface);
  if (!atlas_ || !atlas_->is_of(surface, document.intrinsic_roughness, settings, grid)) return nullptr;
  if (!atlas_->suits(footprint.covariance)) return nullptr;
  const double missing = atlas_->missing_share(footprint);
  if (missing > k_few) return nullptr;
  if (missing > 0 && !atlas_->build(footprint, control)) return nullptr;
  return atlas_;
}

void AtlasKeeper::forget_another_map(const Surface& surface) {
  if (atlas_ && atlas_->map() != surface.shared_map()) atlas_.reset();
}

void AtlasKeeper::prepare(const Document& document, const MixtureSettings& settings, const Surface& surface,
                          const PndfGrid& grid, JobSteps& steps) {
  const Footprint& footprint = document.footprint;
  const double roughness = document.intrinsic_roughness;
  if (!atlas_ || !atlas_->is_of(surface, roughness, settings, grid)) {
    atlas_ = std::make_shared<MixtureAtlas>(surface, roughness, settings, grid);
  }
  if (!atlas_->suits(footprint.covariance) || atlas_->missing_share(footprint) == 0) return;
  atlas_->build(footprint, steps.begin("preparing wide footprints"));
}

}  // namespace glint::gui
