// Declarations: where the normal map comes from, how it is read or generated, and the surface laid over it.

#include <array>
#include <cstdint>

#include "core/document/names.h"
#include "core/document/parameter_access.h"
#include "core/document/parameter_table.h"
#include "core/surface/normal_map.h"

namespace glint {
namespace {

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
bool of_flakes(const Document& document) {
  return document.surface.source == SurfaceSource::flakes;
}

constexpr std::array<std::string_view, 2> k_shortest_longest{"shortest", "longest"};
constexpr std::array<std::string_view, 2> k_smallest_largest{"smallest", "largest"};
constexpr IntegerRange k_map_side{8, k_largest_map_side};
constexpr IntegerRange k_any_seed{0, UINT64_MAX};
constexpr double k_longest_feature = k_largest_map_side;  // texels, on a generated map

constexpr std::string_view k_this_tool_reading = "this tool: reading a normal map";
constexpr std::string_view k_yan14_maps = "Yan et al. 2014, the scratched cutlery";
constexpr std::string_view k_flakes = "Yan et al. 2016, flakes";
constexpr std::string_view k_band_noise = "this tool: the isotropic map of the speed tables";
constexpr std::string_view k_yan14_noise = "Yan et al. 2014, normal maps with a Gaussian power spectrum";

constexpr std::array k_parameters{
    Parameter{.path = "surface.source",
              .label = "source",
              .short_label = "Source",
              .kind = ParameterKind::choice,
              .choices = k_choice_names<SurfaceSource>,
              .help = "Where the normal map comes from: a file, or one of the generators.",
              .source = "Yan et al. 2014, the normal maps of the results",
              .access = at<[](auto& d) -> auto& { return d.surface.source; }>(),
              .matters = always},
    Parameter{.path = "surface.path",
              .label = "file",
              .short_label = "File",
              .kind = ParameterKind::path,
              .help = "The picture that holds the normal map; in a preset, relative to the preset's folder.",
              .source = k_this_tool_reading,
              .access = at<[](auto& d) -> auto& { return d.surface.path; }>(),
              .matters = of_file},
    Parameter{.path = "surface.range",
              .label = "value range",
              .short_label = "Range",
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
              .short_label = "Green",
              .kind = ParameterKind::choice,
              .choices = k_choice_names<GreenDirection>,
              .help = "Whether green points to the top of the picture (up, OpenGL) or to its bottom (down, DirectX).",
              .source = k_this_tool_reading,
              .access = at<[](auto& d) -> auto& { return d.surface.reading.green; }>(),
              .matters = of_file},
    Parameter{.path = "surface.height_scale",
              .label = "height scale",
              .short_label = "Height scale",
              .unit = "texels",
              .kind = ParameterKind::number,
              .range = {.lowest = -1e6, .highest = 1e6, .without_zero = true},
              .slider = {0.1, 100, true},
              .may_be_none = true,
              .help = "If set, the file holds heights, and a value of 1 in it is this many texels high.",
              .source = k_this_tool_reading,
              .access = at<[](auto& d) -> auto& { return d.surface.reading.height_scale; }>(),
              .matters = of_file},
    Parameter{.path = "surface.wrap",
              .label = "wrap",
              .short_label = "Wrap",
              .kind = ParameterKind::choice,
              .choices = k_choice_names<Wrap>,
              .help = "What lies beyond the border of the map: the map again (repeat), or its border texels (clamp).",
              .source = k_this_tool_reading,
              .access = at<[](auto& d) -> auto& { return d.surface.reading.wrap; }>(),
              .matters = always},
    Parameter{.path = "surface.interpolation",
              .label = "interpolation",
              .short_label = "Surface",
              .kind = ParameterKind::choice,
              .choices = k_choice_names<std::optional<Interpolation>>,
              .help = "The surface between the samples: bicubic (smooth), two triangles per texel (linear), one normal "
                      "per texel (constant); auto is smooth unless the map is flagged piecewise constant.",
              .source = "Yan et al. 2014, 2 or 32 triangles per texel",
              .access = at<[](auto& d) -> auto& { return d.surface.interpolation; }>(),
              .matters = always},
    Parameter{.path = "surface.generator.size",
              .label = "map size",
              .short_label = "Map size",
              .unit = "texels",
              .kind = ParameterKind::integer,
              .integer_range = k_map_side,
              .slider = {32, 4096, true},
              .help = "Width and height of the generated map; a power of two for scratches and for Gaussian noise.",
              .source = k_yan14_maps,
              .access = at_all_generators<[](auto& g) -> auto& { return g.size; }>(),
              .matters = of_generator},
    Parameter{.path = "surface.generator.seed",
              .label = "map seed",
              .short_label = "Map seed",
              .kind = ParameterKind::integer,
              .integer_range = k_any_seed,
              .help = "Chooses one of all maps of this kind; the same seed gives the same map.",
              .source = "this tool: PCG32 random streams",
              .access = at_all_generators<[](auto& g) -> auto& { return g.seed; }>(),
              .matters = of_generator},
    Parameter{.path = "surface.generator.spectrum",
              .label = "spectrum",
              .short_label = "Spectrum",
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
              .short_label = "RMS slope",
              .kind = ParameterKind::number,
              .range = {0, 10},
              .slider = {0, 1},
              .help = "How rough the noise is: the root mean square of its slope per axis; 0 is a flat map.",
              .source = k_yan14_noise,
              .access = at<[](auto& d) -> auto& { return d.surface.noise.rms_slope; }>(),
              .matters = of_noise},
    Parameter{
        .path = "surface.generator.correlation_length",
        .label = "correlation length",
        .short_label = "Correlation",
        .symbol = "l",
        .unit = "texels",
        .kind = ParameterKind::number,
        .range = {1.5, k_longest_feature / 4},
        .slider = {1.5, 64, true},
        .help = "The distance over which the heights of Gaussian noise lose their likeness (autocorrelation 1/e).",
        .source = k_yan14_noise,
        .access = at<[](auto& d) -> auto& { return d.surface.noise.correlation_length; }>(),
        .matters = of_gaussian_noise},
    Parameter{.path = "surface.generator.wavelengths",
              .label = "wavelengths",
              .short_label = "Wavelengths",
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
              .short_label = "Scratches",
              .kind = ParameterKind::integer,
              .integer_range = {0, 100'000},
              .slider = {0, 5000},
              .help = "The number of scratches on the whole map.",
              .source = k_yan14_maps,
              .access = at<[](auto& d) -> auto& { return d.surface.scratches.count; }>(),
              .matters = of_scratches},
    Parameter{.path = "surface.generator.length",
              .label = "scratch length",
              .short_label = "Length",
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
        .short_label = "Half width",
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
              .short_label = "Flank slope",
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
              .short_label = "Direction",
              .unit = "degrees",
              .kind = ParameterKind::number,
              .range = {-360, 360},
              .slider = {-180, 180},
              .help = "The mean direction of the scratches, from the u axis towards the top of the picture.",
              .source = k_yan14_maps,
              .access = at<[](auto& d) -> auto& { return d.surface.scratches.direction; }>(),
              .matters = of_scratches},
    Parameter{.path = "surface.generator.spread",
              .label = "spread",
              .short_label = "Spread",
              .unit = "degrees",
              .kind = ParameterKind::number,
              .range = {0, 90},
              .slider = {0, 90},
              .help = "The largest deviation of a scratch from the mean direction; 90 is every direction.",
              .source = k_yan14_maps,
              .access = at<[](auto& d) -> auto& { return d.surface.scratches.spread; }>(),
              .matters = of_scratches},
    Parameter{.path = "surface.generator.blur",
              .label = "blur",
              .short_label = "Blur",
              .unit = "texels",
              .kind = ParameterKind::number,
              .range = {0, 16},
              .slider = {0, 4},
              .help = "The standard deviation of the blur that rounds the scratches' edges; 0 is none.",
              .source = k_yan14_maps,
              .access = at<[](auto& d) -> auto& { return d.surface.scratches.blur; }>(),
              .matters = of_scratches},
    Parameter{.path = "surface.generator.dent_rms_slope",
              .label = "dent slope",
              .short_label = "Dent slope",
              .kind = ParameterKind::number,
              .range = {0, 10},
              .slider = {0, 0.2},
              .help = "How rough the dents below the scratches are: their RMS slope per axis; 0 is none.",
              .source = k_yan14_maps,
              .access = at<[](auto& d) -> auto& { return d.surface.scratches.dent_rms_slope; }>(),
              .matters = of_scratches},
    Parameter{.path = "surface.generator.radius",
              .label = "flake radius",
              .short_label = "Flake radius",
              .unit = "texels",
              .kind = ParameterKind::number,
              .range = {1, k_longest_feature / 4},
              .slider = {1, 64, true},
              .help = "The Poisson-disk radius: the least distance between the centres of two flakes; at most a "
                      "quarter of the map's size.",
              .source = k_flakes,
              .access = at<[](auto& d) -> auto& { return d.surface.flakes.radius; }>(),
              .matters = of_flakes},
    Parameter{.path = "surface.generator.alpha",
              .label = "Beckmann alpha",
              .short_label = "Beckmann α",
              .symbol = "alpha",
              .kind = ParameterKind::number,
              .range = {0, 10},
              .slider = {0, 1.5},
              .help = "How far flakes are turned: the Beckmann roughness of their slopes, whose variance is alpha² / 2 "
                      "per axis; 0 is level.",
              .source = "Walter et al. 2007, Beckmann distribution",
              .access = at<[](auto& d) -> auto& { return d.surface.flakes.alpha; }>(),
              .matters = of_flakes},
    Parameter{.path = "surface.generator.flat_share",
              .label = "flat share",
              .short_label = "Flat share",
              .kind = ParameterKind::number,
              .range = {0, 1},
              .slider = {0, 1},
              .help = "The share of flakes that lie level.",
              .source = "this tool: flakes",
              .access = at<[](auto& d) -> auto& { return d.surface.flakes.flat_share; }>(),
              .matters = of_flakes},
};

}  // namespace

std::span<const Parameter> surface_parameters() {
  return k_parameters;
}

}  // namespace glint
