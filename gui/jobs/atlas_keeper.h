#pragma once
// The atlas of wide footprints that the mixture's pictures are looked up in: kept while surface, roughness, settings
// and grid stay, made anew in the background when they change.

#include <memory>

#include "core/document/document.h"
#include "core/pndf/mixture_atlas.h"
#include "core/surface/surface.h"
#include "gui/jobs/latest_job.h"

namespace glint::gui {

/// Of the background thread alone.
class AtlasKeeper {
 public:
  /// The atlas for a picture of the document, if there is one with at most a few blocks missing, which are made; null
  /// where the footprint is for the direct method.
  std::shared_ptr<const MixtureAtlas> for_picture(const Document& document, const MixtureSettings& settings,
                                                  const Surface& surface, const PndfGrid& grid, JobControl& control);
  /// Makes what the footprint needs, as a step of the job, if it is wide enough for an atlas.
  void prepare(const Document& document, const MixtureSettings& settings, const Surface& surface, const PndfGrid& grid,
               JobSteps& steps);

 private:
  void forget_another_map(const Surface& surface);

  std::shared_ptr<MixtureAtlas> atlas_;
};

}  // namespace glint::gui
