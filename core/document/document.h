#pragma once
// What can be edited, saved and undone: plain values. Every field is declared once, with its unit, range, default and
// help, in core/document/parameter.h; presets, recipes, the command line and the window follow from that declaration.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "core/image/normal_map_reader.h"
#include "core/pndf/footprint.h"
#include "core/pndf/model_factory.h"
#include "core/surface/flakes.h"
#include "core/surface/noise.h"
#include "core/surface/scratches.h"
#include "core/surface/surface.h"

namespace glint {

enum class SurfaceSource { file, noise, scratches, flakes };

/// How densities become colours.
enum class ColorScale { logarithmic, linear };

/// What the colours of the map show: the normal, how steep it is, or how fast it turns.
enum class MapColors { normal, slope, curvature };

struct SurfaceDescription {
  SurfaceSource source = SurfaceSource::scratches;
  std::filesystem::path path;  ///< of the file, when source is file
  ReadOptions reading;         ///< how the file is read; its wrap holds for generated maps too
  /// None: smooth, or constant where the map is flagged piecewise constant.
  std::optional<Interpolation> interpolation;
  /// All generators' size and seed are one field each (surface.generator.size, .seed) and are set together.
  NoiseSettings noise;
  ScratchSettings scratches;
  FlakeSettings flakes;

  friend bool operator==(const SurfaceDescription&, const SurfaceDescription&) = default;
};

struct GridDescription {
  int size = 256;                    ///< cells per side
  std::optional<glm::dvec4> window;  ///< smin, smax, tmin, tmax; none: fitted to the lobe

  friend bool operator==(const GridDescription&, const GridDescription&) = default;
};

/// How pictures look; nothing here changes what is computed.
struct ViewSettings {
  ColorScale density_scale = ColorScale::logarithmic;
  std::optional<glm::dvec2> density_range;  ///< densities at the ends of the colour bar; none: fitted to the pictures
  std::optional<double> difference_range;   ///< |difference| at the ends of its colour bar; none: fitted
  MapColors map_colors = MapColors::normal;
  bool elements = false;  ///< whether the map shows the mixture's elements

  friend bool operator==(const ViewSettings&, const ViewSettings&) = default;
};

struct Document {
  std::string name = "untitled";
  SurfaceDescription surface;
  Footprint footprint{{512, 512}, {25, 0, 25}};
  double intrinsic_roughness = 0.02;  ///< sigma_r
  std::vector<PndfMethod> methods{PndfMethod::exact};
  bool exact_vertex_shift = false;  ///< see ExactSettings::vertex_shift
  ExactPrecision exact_precision = ExactPrecision::single_precision;
  MixtureSettings mixture;
  AutoSettings automatic;
  std::uint64_t binning_samples = 1'000'000;
  GridDescription grid;
  std::uint64_t seed = 1;
  ViewSettings view;

  friend bool operator==(const Document&, const Document&) = default;
};

}  // namespace glint
