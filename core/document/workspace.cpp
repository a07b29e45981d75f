#include "core/document/workspace.h"

#include <utility>

#include "core/pndf/fitted_window.h"
#include "core/pndf/model_factory.h"

namespace glint {
namespace {

NormalMap with_wrap(NormalMap map, Wrap wrap) {
  if (map.wrap() == wrap) return map;
  return NormalMap(map.width(), map.height(), map.normals(), wrap, map.piecewise_constant());
}

Surface surface_over(NormalMap map, std::optional<Interpolation> interpolation) {
  const Interpolation natural = map.piecewise_constant() ? Interpolation::constant : Interpolation::smooth;
  return {std::make_shared<const NormalMap>(std::move(map)), interpolation.value_or(natural)};
}

}  // namespace

Result<LoadedSurface> load_surface(const SurfaceDescription& description, JobControl& control) {
  if (description.source == SurfaceSource::file) {
    Result<ReadNormalMap> read = read_normal_map(description.path, description.reading, control);
    if (!read) return read.error();
    return LoadedSurface{surface_over(std::move(read->map), description.interpolation), std::move(read->report)};
  }
  Result<NormalMap> generated = description.source == SurfaceSource::noise
                                    ? generate_noise(description.noise, control)
                                    : generate_scratches(description.scratches, control);
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

std::unique_ptr<PndfModel> make_document_model(const Document& document, PndfMethod method, const Surface& surface) {
  ModelSettings settings;
  settings.binned = {document.binning_samples, document.seed, document.grid.size};
  return make_model(method, surface, document.intrinsic_roughness, settings);
}

PndfGrid document_grid(const Document& document, const Surface& surface) {
  const int size = document.grid.size;
  if (!document.grid.window) return fitted_window(surface, document.footprint, document.intrinsic_roughness, size);
  const glm::dvec4 w = *document.grid.window;
  return {w[0], w[1], w[2], w[3], size, size};
}

}  // namespace glint
