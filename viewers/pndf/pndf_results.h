#pragma once
// What the jobs have computed for a document, as the panels draw it: immutable once published, tagged with the revision
// of the document it belongs to.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/document/workspace.h"
#include "core/pndf/pndf_grid.h"
#include "core/study/error_metrics.h"
#include "core/surface/normal_pyramid.h"

namespace glint::view {

/// A surface with what the window needs to draw it. Immutable; shared between threads.
struct SurfaceInUse {
  LoadedSurface loaded;
  SurfaceDescription description;                ///< what it was loaded from
  std::shared_ptr<const NormalPyramid> pyramid;  ///< of its map; never null
};

/// The P-NDF of one method. Its image has its own grid: that of a coarse or an older picture is not the results' grid.
struct MethodPicture {
  PndfMethod method = PndfMethod::exact;
  std::shared_ptr<const PndfImage> image;         ///< null: not computed yet
  bool coarse = false;                            ///< a quick first answer: fewer cells, and what `coarse_note` says
  std::string coarse_note;                        ///< "64² cells, 2 triangles", empty for a full picture
  Interpolation surface = Interpolation::smooth;  ///< what it was computed on: differences need equal surfaces
  std::vector<std::string> findings;              ///< of its method on that input (mixture_findings), but what the
                                                  ///< report of the map's file says
  double milliseconds = 0;                        ///< of `image` alone; nothing of building or waiting is in it
  std::optional<PndfErrors> errors;               ///< against the reference of its surface; unknown until that is there
  double reference_error = 0;                     ///< of the reference itself, where `errors` are known
  std::shared_ptr<const PndfImage> reference;     ///< in double precision on the same surface; null: not there yet
  double progress = 1;                            ///< of the better picture under way, 1 when there is none
  std::uint64_t revision = 0;                     ///< of the document it shows; older than the results': to be dimmed
};

/// Everything known about one snapshot of the document. Shared between the jobs, which make a new one for every step
/// forward, and the frame loop, which only ever reads the newest.
struct PndfResults {
  std::uint64_t revision = 0;                   ///< of the document
  Document document;                            ///< the snapshot it was computed for
  std::shared_ptr<const SurfaceInUse> surface;  ///< never null
  PndfGrid grid;                                ///< of the full pictures
  std::vector<MethodPicture> methods;           ///< in the order of the document
  std::shared_ptr<const PndfImage> reference;   ///< in double precision on the document's surface; null: not there yet
};

}  // namespace glint::view
