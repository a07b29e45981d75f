#pragma once
// The one place that turns a document into surfaces, models and grids: the window and the command line both go through
// it, so they cannot disagree.

#include <memory>
#include <optional>

#include "core/document/document.h"
#include "core/image/normal_map_reader.h"
#include "core/math/parallel.h"
#include "core/math/result.h"
#include "core/pndf/pndf_grid.h"
#include "core/pndf/pndf_model.h"
#include "core/surface/surface.h"

namespace glint {

struct LoadedSurface {
  Surface surface;
  std::optional<ReadReport> report;  ///< of a file; generated maps have nothing to report
};

/// Reads or generates the map of a description and lays the asked surface over it.
Result<LoadedSurface> load_surface(const SurfaceDescription& description, JobControl& control);

/// The fault of a document's footprint on that map, if any: a centre outside a map that clamps.
std::optional<Error> footprint_position_fault(const Footprint& footprint, const NormalMap& map);

/// The model of one of the document's methods on `surface`.
std::unique_ptr<PndfModel> make_document_model(const Document& document, PndfMethod method, const Surface& surface);

/// The grid of the document's P-NDF images: its window, or one fitted to the lobe.
PndfGrid document_grid(const Document& document, const Surface& surface);

}  // namespace glint
