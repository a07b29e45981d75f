// Declarations: how pictures look. None of these matters to what is computed, so no recipe holds them.

#include <array>

#include "core/document/names.h"
#include "core/document/parameter_access.h"
#include "core/document/parameter_table.h"

namespace glint {
namespace {

constexpr std::array<std::string_view, 2> k_lowest_highest{"lowest", "highest"};
constexpr std::string_view k_this_tool_window = "this tool: the window";

constexpr std::array k_parameters{
    Parameter{.path = "view.density_scale",
              .label = "density scale",
              .short_label = "Scale",
              .kind = ParameterKind::choice,
              .choices = k_choice_names<ColorScale>,
              .help = "Whether colours follow the logarithm of a density (log) or the density itself (linear).",
              .source = k_this_tool_window,
              .access = at<[](auto& d) -> auto& { return d.view.density_scale; }>(),
              .matters = never},
    Parameter{.path = "view.density_range",
              .label = "density range",
              .short_label = "Densities",
              .kind = ParameterKind::numbers,
              .range = {1e-30, 1e30},
              .components = k_lowest_highest,
              .ascending = true,
              .strictly = true,
              .instead = "fit",
              .help = "The densities at the ends of the colour bar, or fit: as the pictures beside it need.",
              .source = k_this_tool_window,
              .access = at<[](auto& d) -> auto& { return d.view.density_range; }>(),
              .matters = never},
    Parameter{.path = "view.difference_range",
              .label = "difference range",
              .short_label = "Difference",
              .kind = ParameterKind::number,
              .range = {.lowest = 0, .highest = 1e30, .open_lowest = true},
              .may_be_none = true,
              .help = "If set, the difference of two densities at the ends of its colour bar; else as it needs.",
              .source = k_this_tool_window,
              .access = at<[](auto& d) -> auto& { return d.view.difference_range; }>(),
              .matters = never},
    Parameter{.path = "view.map_colors",
              .label = "map colours",
              .short_label = "Map colours",
              .kind = ParameterKind::choice,
              .choices = k_choice_names<MapColors>,
              .help = "What the colours of the map show: its normals, their slope, or their curvature.",
              .source = k_this_tool_window,
              .access = at<[](auto& d) -> auto& { return d.view.map_colors; }>(),
              .matters = never},
    Parameter{.path = "view.elements",
              .label = "elements on the map",
              .short_label = "Map elements",
              .kind = ParameterKind::flag,
              .help =
                  "Draws the mixture's elements over the map, coloured by their weight under the footprint or, while "
                  "there is a crosshair, by what they add to the density at its normal.",
              .source = k_this_tool_window,
              .access = at<[](auto& d) -> auto& { return d.view.elements; }>(),
              .matters = never},
};

}  // namespace

std::span<const Parameter> view_parameters() {
  return k_parameters;
}

}  // namespace glint
