#include "core/document/workspace.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/pndf/fitted_window.h"
#include "core/pndf/model_factory.h"

namespace glint {
namespace {

constexpr double k_coarse_cut = 4.2;
constexpr std::uint64_t k_coarse_samples = 100'000;

NormalMap with_wrap(NormalMap map, Wrap wrap) {
  if (map.wrap() == wrap) return map;
  return NormalMap(map.width(), map.height(), map.normals(), wrap, map.piecewise_constant());
}

Surface surface_over(NormalMap map, std::optional<Interpolation> interpolation) {
  const Interpolation natural = map.piecewise_constant() ? Interpolation::constant : Interpolation::smooth;
  return {std::make_shared<const NormalMap>(std::move(map)), interpolation.value_or(natural)};
}

Result<NormalMap> generated_map(const SurfaceDescription& description, JobControl& control) {
  switch (description.source) {
    case SurfaceSource::noise:
      return generate_noise(description.noise, control);
    case SurfaceSource::flakes:
      return generate_flakes(description.flakes, control);
    case SurfaceSource::file:
    case SurfaceSource::scratches:
      break;
  }
  return generate_scratches(description.scratches, control);
}

ModelSettings settings_of(const Document& document) {
  ModelSettings settings;
  settings.exact.vertex_shift = document.exact_vertex_shift;
  settings.precision = document.exact_precision;
  settings.mixture = document.mixture;
  settings.automatic = document.automatic;
  settings.binned = {document.binning_samples, document.seed, document.grid.size};
  return settings;
}

}  // namespace

Result<LoadedSurface> load_surface(const SurfaceDescription& description, JobControl& control, KeepStored keep) {
  if (description.source == SurfaceSource::file) {
    const auto stored = keep == KeepStored::yes ? std::make_shared<StoredSamples>() : nullptr;
    Result<ReadNormalMap> read = read_normal_map(description.path, description.reading, control, stored.get());
    if (!read) return read.error();
    return LoadedSurface{surface_over(std::move(read->map), description.interpolation), std::move(read->report),
                         stored};
  }
  Result<NormalMap> generated = generated_map(description, control);
  if (!generated) return generated.error();
  NormalMap map = with_wrap(std::move(*generated), description.reading.wrap);
  return LoadedSurface{surface_over(std::move(map), description.interpolation), std::nullopt};
}

std::optional<Error> footprint_position_fault(const Footprint& footprint, const NormalMap& map) {
  if (map.wrap() == Wrap::repeat) return std::nullopt;
  const glm::dvec2 c = footprint.center;
  if (c.x >= 0 && c.y >= 0 && c.x <= map.width() && c.y <= map.height()) return std::nullopt;
  return request_error("footprint.center", "lies outside the map of " + std::to_string(map.width()) + " x " +
                                               std::to_string(map.height()) +
                                               " texels, which clamps; a map that repeats would wrap it");
}

std::unique_ptr<PndfModel> make_document_model(const Document& document, PndfMethod method, const Surface& surface,
                                               std::shared_ptr<const MixtureAtlas> atlas) {
  ModelSettings settings = settings_of(document);
  settings.atlas = std::move(atlas);
  return make_model(method, surface, document.intrinsic_roughness, settings);
}

std::vector<MixtureFinding> document_findings(const Document& document, PndfMethod method, const Surface& surface) {
  if (method != PndfMethod::mixture) return {};
  return mixture_findings(surface, document.intrinsic_roughness, document.mixture, document.footprint);
}

std::vector<std::string> unreported_sentences(const std::vector<MixtureFinding>& findings,
                                              const std::optional<ReadReport>& report, double intrinsic_roughness) {
  const bool steps_reported = report && quantisation_note(*report, intrinsic_roughness);
  std::vector<std::string> sentences;
  for (const MixtureFinding& finding : findings) {
    if (steps_reported && finding.kind == MixtureFinding::Kind::value_step) continue;
    sentences.push_back(finding.sentence);
  }
  return sentences;
}

std::unique_ptr<PndfModel> make_coarse_model(const Document& document, PndfMethod method, const Surface& surface) {
  ModelSettings settings = settings_of(document);
  // No vertex shift: on cells of a whole texel its bound is so wide that hardly any cell is left out.
  settings.exact = {.subdivision = 1, .vertex_shift = false, .image_cut = k_coarse_cut};
  settings.precision = ExactPrecision::single_precision;
  settings.binned.samples = std::min(settings.binned.samples, k_coarse_samples);
  if (method == PndfMethod::automatic) {
    settings.mixture = mixture_of_step(1);
    method = PndfMethod::mixture;
  }
  return make_model(method, surface, document.intrinsic_roughness, settings);
}

PndfGrid coarse_grid(const PndfGrid& grid, int cells) {
  PndfGrid coarse = grid;
  coarse.columns = std::min(grid.columns, cells);
  coarse.rows = std::min(grid.rows, cells);
  return coarse;
}

PndfGrid document_grid(const Document& document, const Surface& surface) {
  const int size = document.grid.size;
  if (!document.grid.window) return fitted_window(surface, document.footprint, document.intrinsic_roughness, size);
  const glm::dvec4 w = *document.grid.window;
  return {w[0], w[1], w[2], w[3], size, size};
}

}  // namespace glint
