// The declarations themselves. Adding a field: one entry here, and one member in document.h.

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "core/document/names.h"
#include "core/document/parameter.h"
#include "core/document/parameter_access.h"
#include "core/pndf/pndf_grid.h"
#include "core/surface/normal_map.h"

namespace glint {
namespace {

// --- when a field matters ---

bool always(const Document&) {
  return true;
}
bool never(const Document&) {
  return false;
}
bool of_file(const Document& document) {
  return document.surface.source == SurfaceSource::file;
}
bool of_generator(const Document& document) {
  return !of_file(document);
}
bool of_noise(const Document& document) {
  return document.surface.source == SurfaceSource::noise;
}
bool of_gaussian_noise(const Document& document) {
  return of_noise(document) && document.surface.noise.spectrum == NoiseSettings::Spectrum::gaussian;
}
bool of_band_noise(const Document& document) {
  return of_noise(document) && document.surface.noise.spectrum == NoiseSettings::Spectrum::band;
}
bool of_scratches(const Document& document) {
  return document.surface.source == SurfaceSource::scratches;
}
bool of_binning(const Document& document) {
  return std::find(document.methods.begin(), document.methods.end(), PndfMethod::binning) != document.methods.end();
}

// --- the declarations ---

constexpr std::array<std::string_view, 2> k_shortest_longest{"shortest", "longest"};
constexpr std::array<std::string_view, 2> k_smallest_largest{"smallest", "largest"};
constexpr std::array<std::string_view, 2> k_x_y{"x", "y"};
constexpr std::array<std::string_view, 3> k_covariance{"sxx", "sxy", "syy"};
constexpr std::array<std::string_view, 4> k_window{"smin", "smax", "tmin", "tmax"};
constexpr IntegerRange k_map_side{8, k_largest_map_side};
constexpr IntegerRange k_any_seed{0, UINT64_MAX};
constexpr double k_longest_feature = k_largest_map_side;  // texels, on a generated map

constexpr std::string_view k_this_tool_presets = "this tool: presets";
constexpr std::string_view k_this_tool_reading = "this tool: reading a normal map";
constexpr std::string_view k_yan14_pndf = "Yan et al. 2014, eq. 3";
constexpr std::string_view k_yan14_maps = "Yan et al. 2014, the scratched cutlery";
constexpr std::string_view k_band_noise = "this tool: the isotropic map of the speed tables";
constexpr std::string_view k_yan14_noise = "Yan et al. 2014, normal maps with a Gaussian power spectrum";

constexpr std::array k_parameters{
    Parameter{.path = "name",
              .label = "name",
              .kind = ParameterKind::text,
              .help = "The name of the preset, as the lists show it.",
              .source = k_this_tool_presets,
              .access = at<[](auto& d) -> auto& { return d.name; }>(),
              .matters = never},
    Parameter{.path = "surface.source",
              .label = "source",
              .kind = ParameterKind::choice,
              .choices = k_choice_names<SurfaceSource>,
              .help = "Where the normal map comes from: a file, or one of the generators.",
              .source = "Yan et al. 2014, the normal maps of the results",
              .access = at<[](auto& d) -> auto& { return d.surface.source; }>(),
              .matters = always},
    Parameter{.path = "surface.path",
              .label = "file",
              .kind = ParameterKind::path,
              .help = "The picture that holds the normal map; in a preset, relative to the preset's folder.",
              .source = k_this_tool_reading,
              .access = at<[](auto& d) -> auto& { return d.surface.path; }>(),
              .matters = of_file},
    Parameter{.path = "surface.range",
              .label = "value range",
              .kind = ParameterKind::choice,
              .choices = k_choice_names<ValueRange>,
              .help =
                  "Whether a float file holds components from -1 to 1 (signed), from 0 to 1 (unsigned), or whichever "
                  "its values suggest (auto).",
              .source = k_this_tool_reading,
              .access = at<[](auto& d) -> auto& { return d.surface.reading.range; }>(),
              .matters = of_file},
    Parameter{.path = "surface.green",
              .label = "green channel",
              .kind = ParameterKind::choice,
              .choices = k_choice_names<GreenDirection>,
              .help = "Whether green points to the top of the picture (up, OpenGL) or to its bottom (down, DirectX).",
              .source = k_this_tool_reading,
              .access = at<[](auto& d) -> auto& { return d.surface.reading.green; }>(),
              .matters = of_file},
    Parameter{.path = "surface.height_scale",
              .label = "height scale",
              .unit = "texels",
              .kind = ParameterKind::number,
              .range = {.lowest = -1e6, .highest = 1e6, .without_zero = true},
              .may_be_none = true,
              .help = "If set, the file holds heights, and a value of 1 in it is this many texels high.",
              .source = k_this_tool_reading,
              .access = at<[](auto& d) -> auto& { return d.surface.reading.height_scale; }>(),
              .matters = of_file},
    Parameter{.path = "surface.wrap",
              .label = "wrap",
              .kind = ParameterKind::choice,
              .choices = k_choice_names<Wrap>,
              .help = "What lies beyond the border of the map: the map again (repeat), or its border texels (clamp).",
              .source = k_this_tool_reading,
              .access = at<[](auto& d) -> auto& { return d.surface.reading.wrap; }>(),
              .matters = always},
    Parameter{.path = "surface.interpolation",
              .label = "interpolation",
              .kind = ParameterKind::choice,
              .choices = k_choice_names<std::optional<Interpolation>>,
              .help = "The surface between the samples: bicubic (smooth), two triangles per texel (linear), one normal "
                      "per texel (constant); auto is smooth unless the map is flagged piecewise constant.",
              .source = "Yan et al. 2014, 2 or 32 triangles per texel",
              .access = at<[](auto& d) -> auto& { return d.surface.interpolation; }>(),
              .matters = always},
    Parameter{.path = "surface.generator.size",
              .label = "map size",
              .unit = "texels",
              .kind = ParameterKind::integer,
              .integer_range = k_map_side,
              .help = "Width and height of the generated map; a power of two for scratches and for Gaussian noise.",
              .source = k_yan14_maps,
              .access = at_both_generators<[](auto& g) -> auto& { return g.size; }>(),
              .matters = of_generator},
    Parameter{.path = "surface.generator.seed",
              .label = "map seed",
              .kind = ParameterKind::integer,
              .integer_range = k_any_seed,
              .help = "Chooses one of all maps of this kind; the same seed gives the same map.",
              .source = "this tool: PCG32 random streams",
              .access = at_both_generators<[](auto& g) -> auto& { return g.seed; }>(),
              .matters = of_generator},
    Parameter{.path = "surface.generator.spectrum",
              .label = "spectrum",
              .kind = ParameterKind::choice,
              .choices = k_choice_names<NoiseSettings::Spectrum>,
              .help =
                  "Which waves the noise holds: all, with a Gaussian autocorrelation (gaussian), or wavelengths of an "
                  "interval (band).",
              .source = k_yan14_noise,
              .access = at<[](auto& d) -> auto& { return d.surface.noise.spectrum; }>(),
              .matters = of_noise},
    Parameter{.path = "surface.generator.rms_slope",
              .label = "RMS slope",
              .kind = ParameterKind::number,
              .range = {0, 10},
              .help = "How rough the noise is: the root mean square of its slope per axis; 0 is a flat map.",
              .source = k_yan14_noise,
              .access = at<[](auto& d) -> auto& { return d.surface.noise.rms_slope; }>(),
              .matters = of_noise},
    Parameter{
        .path = "surface.generator.correlation_length",
        .label = "correlation length",
        .symbol = "l",
        .unit = "texels",
        .kind = ParameterKind::number,
        .range = {1.5, k_longest_feature / 4},
        .help = "The distance over which the heights of Gaussian noise lose their likeness (autocorrelation 1/e).",
        .source = k_yan14_noise,
        .access = at<[](auto& d) -> auto& { return d.surface.noise.correlation_length; }>(),
        .matters = of_gaussian_noise},
    Parameter{.path = "surface.generator.wavelengths",
              .label = "wavelengths",
              .unit = "texels",
              .kind = ParameterKind::numbers,
              .range = {2, k_longest_feature},
              .components = k_shortest_longest,
              .ascending = true,
              .help = "The shortest and the longest wave of the band noise.",
              .source = k_band_noise,
              .access = at<[](auto& d) -> auto& { return d.surface.noise.wavelengths; }>(),
              .matters = of_band_noise},
    Parameter{.path = "surface.generator.count",
              .label = "scratches",
              .kind = ParameterKind::integer,
              .integer_range = {0, 100'000},
              .help = "The number of scratches on the whole map.",
              .source = k_yan14_maps,
              .access = at<[](auto& d) -> auto& { return d.surface.scratches.count; }>(),
              .matters = of_scratches},
    Parameter{.path = "surface.generator.length",
              .label = "scratch length",
              .unit = "texels",
              .kind = ParameterKind::numbers,
              .range = {1, k_longest_feature},
              .components = k_shortest_longest,
              .ascending = true,
              .help = "The shortest and the longest scratch; lengths between them are log-uniform.",
              .source = k_yan14_maps,
              .access = at<[](auto& d) -> auto& { return d.surface.scratches.length; }>(),
              .matters = of_scratches},
    Parameter{
        .path = "surface.generator.half_width",
        .label = "half width",
        .symbol = "w",
        .unit = "texels",
        .kind = ParameterKind::numbers,
        .range = {0.25, 64},
        .components = k_smallest_largest,
        .ascending = true,
        .help = "The distance from a scratch's middle to its steepest point, smallest and largest; uniform between.",
        .source = k_yan14_maps,
        .access = at<[](auto& d) -> auto& { return d.surface.scratches.half_width; }>(),
        .matters = of_scratches},
    Parameter{.path = "surface.generator.flank_slope",
              .label = "flank slope",
              .kind = ParameterKind::numbers,
              .range = {0.001, 10},
              .components = k_smallest_largest,
              .ascending = true,
              .help = "The largest slope of a scratch's flank, smallest and largest; uniform between.",
              .source = k_yan14_maps,
              .access = at<[](auto& d) -> auto& { return d.surface.scratches.flank_slope; }>(),
              .matters = of_scratches},
    Parameter{.path = "surface.generator.direction",
              .label = "direction",
              .unit = "degrees",
              .kind = ParameterKind::number,
              .range = {-360, 360},
              .help = "The mean direction of the scratches, from the u axis towards the top of the picture.",
              .source = k_yan14_maps,
              .access = at<[](auto& d) -> auto& { return d.surface.scratches.direction; }>(),
              .matters = of_scratches},
    Parameter{.path = "surface.generator.spread",
              .label = "spread",
              .unit = "degrees",
              .kind = ParameterKind::number,
              .range = {0, 90},
              .help = "The largest deviation of a scratch from the mean direction; 90 is every direction.",
              .source = k_yan14_maps,
              .access = at<[](auto& d) -> auto& { return d.surface.scratches.spread; }>(),
              .matters = of_scratches},
    Parameter{.path = "surface.generator.blur",
              .label = "blur",
              .unit = "texels",
              .kind = ParameterKind::number,
              .range = {0, 16},
              .help = "The standard deviation of the blur that rounds the scratches' edges; 0 is none.",
              .source = k_yan14_maps,
              .access = at<[](auto& d) -> auto& { return d.surface.scratches.blur; }>(),
              .matters = of_scratches},
    Parameter{.path = "surface.generator.dent_rms_slope",
              .label = "dent slope",
              .kind = ParameterKind::number,
              .range = {0, 10},
              .help = "How rough the dents below the scratches are: their RMS slope per axis; 0 is none.",
              .source = k_yan14_maps,
              .access = at<[](auto& d) -> auto& { return d.surface.scratches.dent_rms_slope; }>(),
              .matters = of_scratches},
    Parameter{
        .path = "footprint.center",
        .label = "footprint centre",
        .symbol = "u_p",
        .unit = "texels",
        .kind = ParameterKind::numbers,
        .range = {-1e9, 1e9},
        .components = k_x_y,
        .help = "Where the pixel looks: the centre of its footprint; texel (i, j) has its centre at i + 0.5, j + 0.5.",
        .source = k_yan14_pndf,
        .access = at<[](auto& d) -> auto& { return d.footprint.center; }>(),
        .matters = always},
    Parameter{.path = "footprint.covariance",
              .label = "footprint covariance",
              .symbol = "Sigma_p",
              .unit = "texels squared",
              .kind = ParameterKind::numbers,
              .range = {-1e10, 1e10},
              .components = k_covariance,
              .help = "Size and shape of the pixel's footprint: the covariance of its Gaussian.",
              .source = k_yan14_pndf,
              .access = at<[](auto& d) -> auto& { return d.footprint.covariance; }>(),
              .matters = always},
    Parameter{.path = "intrinsic_roughness",
              .label = "intrinsic roughness",
              .symbol = "sigma_r",
              .kind = ParameterKind::number,
              .range = {1e-9, 1},
              .help = "The roughness below the map's texels: the standard deviation of its Gaussian on the unit disk.",
              .source = k_yan14_pndf,
              .access = at<[](auto& d) -> auto& { return d.intrinsic_roughness; }>(),
              .matters = always},
    Parameter{.path = "methods",
              .label = "methods",
              .kind = ParameterKind::choices,
              .choices = k_choice_names<PndfMethod>,
              .help = "The methods that compute the P-NDF, in the order in which they are shown.",
              .source = "Yan et al. 2014, sections 4 to 6 (exact) and the comparison against reference (binning)",
              .access = at<[](auto& d) -> auto& { return d.methods; }>(),
              .matters = always},
    Parameter{.path = "binning.samples",
              .label = "binning samples",
              .kind = ParameterKind::integer,
              .integer_range = {1, 10'000'000'000},
              .help = "How many normals the binning method draws; four times as many halve its noise.",
              .source = "Yan et al. 2014, comparison against reference",
              .access = at<[](auto& d) -> auto& { return d.binning_samples; }>(),
              .matters = of_binning},
    Parameter{.path = "grid.size",
              .label = "grid size",
              .unit = "cells",
              .kind = ParameterKind::integer,
              .integer_range = {1, k_largest_grid_side},
              .help = "Cells per side of a P-NDF image.",
              .source = "this tool: P-NDF images",
              .access = at<[](auto& d) -> auto& { return d.grid.size; }>(),
              .matters = always},
    Parameter{.path = "grid.window",
              .label = "grid window",
              .symbol = "s, t",
              .kind = ParameterKind::numbers,
              .range = {-100, 100},
              .components = k_window,
              .ascending = true,
              .strictly = true,
              .instead = "fit",
              .help = "The part of the disk of normals that a P-NDF image shows, or fit: as much as the lobe needs.",
              .source = "this tool: P-NDF images",
              .access = at<[](auto& d) -> auto& { return d.grid.window; }>(),
              .matters = always},
    Parameter{.path = "seed",
              .label = "seed",
              .kind = ParameterKind::integer,
              .integer_range = k_any_seed,
              .help = "Chooses the random numbers of the methods that draw some; the same seed gives the same bytes.",
              .source = "this tool: PCG32 random streams",
              .access = at<[](auto& d) -> auto& { return d.seed; }>(),
              .matters = of_binning},
};

}  // namespace

std::span<const Parameter> parameters() {
  return k_parameters;
}

}  // namespace glint
