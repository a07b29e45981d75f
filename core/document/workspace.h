#pragma once
// The one place that turns a document into surfaces, models and grids: the window and the command line both go through
// it, so they cannot disagree.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/image/normal_map_reader.h"
#include "core/image/stored_samples.h"
#include "core/math/parallel.h"
#include "core/math/result.h"
#include "core/pndf/mixture_advice.h"
#include "core/pndf/pndf_grid.h"
#include "core/pndf/pndf_model.h"
#include "core/surface/surface.h"

namespace glint {

struct LoadedSurface {
  Surface surface;
  std::optional<ReadReport> report;  ///< of a file; generated maps have nothing to report
  /// What the file holds, texel by texel; null unless it was asked for, and for generated maps.
  std::shared_ptr<const StoredSamples> stored = {};
};

/// Whether the values of the file are kept beside the map: only a read-out at the cursor needs them.
enum class KeepStored { no, yes };

/// Reads or generates the map of a description and lays the asked surface over it.
Result<LoadedSurface> load_surface(const SurfaceDescription& description, JobControl& control,
                                   KeepStored keep = KeepStored::no);

/// The fault of a document's footprint on that map, if any: a centre outside a map that clamps.
std::optional<Error> footprint_position_fault(const Footprint& footprint, const NormalMap& map);

/// The model of one of the document's methods on `surface`. Mixtures look wide footprints up in the atlas, if there is
/// one.
std::unique_ptr<PndfModel> make_document_model(const Document& document, PndfMethod method, const Surface& surface,
                                               std::shared_ptr<const MixtureAtlas> atlas = nullptr);

/// What is to be said of one of the document's methods on that surface: of the mixture, nothing of others.
std::vector<MixtureFinding> document_findings(const Document& document, PndfMethod method, const Surface& surface);

/// The sentences of those findings that the report of the map's file does not already make (quantisation_note).
std::vector<std::string> unreported_sentences(const std::vector<MixtureFinding>& findings,
                                              const std::optional<ReadReport>& report, double intrinsic_roughness);

/// A cheap model of the same method, for a first picture while the document's own is computed: exact with 2 triangles a
/// texel on the smooth surface and a joint cut that loses 1e-3 of the mass, binning with at most 100 000 samples, the
/// mixture of step 1 in place of auto.
std::unique_ptr<PndfModel> make_coarse_model(const Document& document, PndfMethod method, const Surface& surface);

/// The same window with at most `cells` cells a side.
PndfGrid coarse_grid(const PndfGrid& grid, int cells = 64);

/// The grid of the document's P-NDF images: its window, or one fitted to the lobe.
PndfGrid document_grid(const Document& document, const Surface& surface);

}  // namespace glint
