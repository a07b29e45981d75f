// Declarations: the footprint, the methods and their settings, and the grid of a P-NDF image.

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/document/names.h"
#include "core/document/parameter_access.h"
#include "core/document/parameter_table.h"
#include "core/pndf/pndf_grid.h"

namespace glint {
namespace {

bool has_method(const Document& document, PndfMethod method) {
  return std::find(document.methods.begin(), document.methods.end(), method) != document.methods.end();
}
bool of_binning(const Document& document) {
  return has_method(document, PndfMethod::binning);
}
bool of_auto(const Document& document) {
  return has_method(document, PndfMethod::automatic);
}
bool of_mixture(const Document& document) {
  return has_method(document, PndfMethod::mixture);
}
bool of_exact(const Document& document) {
  return has_method(document, PndfMethod::exact);
}
// Only the smooth surface has 32 triangles; whether `auto` becomes smooth is for the map to tell.
bool of_exact_on_smooth(const Document& document) {
  return has_method(document, PndfMethod::exact) &&
         document.surface.interpolation.value_or(Interpolation::smooth) == Interpolation::smooth;
}

constexpr std::array<std::string_view, 2> k_x_y{"x", "y"};
constexpr std::array<std::string_view, 3> k_covariance{"sxx", "sxy", "syy"};
constexpr std::array<std::string_view, 4> k_window{"smin", "smax", "tmin", "tmax"};
constexpr std::string_view k_yan14_pndf = "Yan et al. 2014, eq. 3";

constexpr std::array k_parameters{
    Parameter{
        .path = "footprint.center",
        .label = "footprint centre",
        .short_label = "Centre",
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
              .short_label = "Covariance",
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
              .short_label = "Roughness σ",
              .symbol = "sigma_r",
              .kind = ParameterKind::number,
              .range = {1e-9, 1},
              .slider = {1e-3, 0.3, true},
              .help = "The roughness below the map's texels: the standard deviation of its Gaussian on the unit disk.",
              .source = k_yan14_pndf,
              .access = at<[](auto& d) -> auto& { return d.intrinsic_roughness; }>(),
              .matters = always},
    Parameter{
        .path = "methods",
        .label = "methods",
        .short_label = "Methods",
        .kind = ParameterKind::choices,
        .choices = k_choice_names<PndfMethod>,
        .help = "The methods that compute the P-NDF, in the order in which they are shown.",
        .source =
            "Yan et al. 2014, sections 4 to 6 (exact), 2016, section 4 (mixture), Olano and Baker 2010 (lean), and "
            "both papers of Yan et al., reference (binning); auto: this tool",
        .access = at<[](auto& d) -> auto& { return d.methods; }>(),
        .matters = always},
    Parameter{.path = "exact.vertex_shift",
              .label = "vertex shift",
              .short_label = "Vertex shift",
              .kind = ParameterKind::flag,
              .help = "Moves the vertices of the 32-triangle surface so that its triangles lose their O(h^2) bias.",
              .source = "this tool: exact evaluation",
              .access = at<[](auto& d) -> auto& { return d.exact_vertex_shift; }>(),
              .matters = of_exact_on_smooth},
    Parameter{.path = "exact.precision",
              .label = "precision of exact evaluation",
              .short_label = "Precision",
              .kind = ParameterKind::choice,
              .choices = k_choice_names<ExactPrecision>,
              .help = "What exact evaluation computes in: float is many times faster and within 1e-4 of double.",
              .source = "this tool: exact evaluation",
              .access = at<[](auto& d) -> auto& { return d.exact_precision; }>(),
              .matters = of_exact},
    Parameter{.path = "mixture.step",
              .label = "step between elements",
              .short_label = "Step h",
              .symbol = "h",
              .unit = "texels",
              .kind = ParameterKind::number,
              .range = {k_least_step, k_largest_step},
              .slider = {0.2, 2, true},
              .help = "How far apart the mixture's elements are seeded: half of it costs four times as much and is, "
                      "where elements are corrected, some six times closer.",
              .source = "Yan et al. 2016, section 4: 2, 1, 0.5, 1/3 or 0.25",
              .access = at<[](auto& d) -> auto& { return d.mixture.step; }>(),
              .matters = of_mixture},
    Parameter{.path = "mixture.kappa",
              .label = "width of elements",
              .short_label = "Kappa",
              .symbol = "sigma_h / h",
              .kind = ParameterKind::number,
              .range = {0.3, 1},
              .may_be_none = true,
              .help = "How wide an element is against the step: narrow ones ripple as their lattice does; automatic, "
                      "unless set, is 0.425, or 0.5 for steps up to 1/4.",
              .source = "Yan et al. 2016, section 4: 1 / sqrt(8 ln 2)",
              .access = at<[](auto& d) -> auto& { return d.mixture.kappa; }>(),
              .matters = of_mixture},
    Parameter{.path = "mixture.elements",
              .label = "kind of elements",
              .short_label = "Elements",
              .kind = ParameterKind::choice,
              .choices = k_choice_names<MixtureElements>,
              .help = "Flat elements do not follow the map's slope; curved ones do; corrected ones besides lose the "
                      "bias that its curvature gives them.",
              .source = "Yan et al. 2016, section 4; corrected: this tool",
              .access = at<[](auto& d) -> auto& { return d.mixture.elements; }>(),
              .matters = of_mixture},
    Parameter{.path = "auto.tolerance",
              .label = "tolerance of auto",
              .short_label = "Tolerance",
              .kind = ParameterKind::number,
              .range = {k_least_tolerance, k_largest_tolerance},
              .slider = {1e-3, 0.1, true},
              .help =
                  "The relative L1 error that auto may make: the cheapest of LEAN, mixtures and exact that meets it "
                  "by its own estimate answers.",
              .source = "this tool: auto",
              .access = at<[](auto& d) -> auto& { return d.automatic.tolerance; }>(),
              .matters = of_auto},
    Parameter{.path = "binning.samples",
              .label = "binning samples",
              .short_label = "Samples",
              .kind = ParameterKind::integer,
              .integer_range = {1, 10'000'000'000},
              .slider = {1e3, 1e8, true},
              .help = "How many normals the binning method draws; four times as many halve its noise.",
              .source = "Yan et al. 2014, comparison against reference",
              .access = at<[](auto& d) -> auto& { return d.binning_samples; }>(),
              .matters = of_binning},
    Parameter{.path = "grid.size",
              .label = "grid size",
              .short_label = "Grid size",
              .unit = "cells",
              .kind = ParameterKind::integer,
              .integer_range = {1, k_largest_grid_side},
              .slider = {16, 1024, true},
              .help = "Cells per side of a P-NDF image.",
              .source = "this tool: P-NDF images",
              .access = at<[](auto& d) -> auto& { return d.grid.size; }>(),
              .matters = always},
    Parameter{.path = "grid.window",
              .label = "grid window",
              .short_label = "Window",
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
              .short_label = "Seed",
              .kind = ParameterKind::integer,
              .integer_range = {0, UINT64_MAX},
              .help = "Chooses the random numbers of the methods that draw some; the same seed gives the same bytes.",
              .source = "this tool: PCG32 random streams",
              .access = at<[](auto& d) -> auto& { return d.seed; }>(),
              .matters = of_binning},
};

}  // namespace

std::span<const Parameter> pndf_parameters() {
  return k_parameters;
}

}  // namespace glint
