// All declarations, joined into one table.

#include "core/document/parameter_table.h"

#include <array>
#include <vector>

#include "core/document/parameter_access.h"

namespace glint {
namespace {

constexpr std::array k_preset_parameters{
    Parameter{.path = "name",
              .label = "name",
              .short_label = "Name",
              .kind = ParameterKind::text,
              .help = "The name of the preset, as the lists show it.",
              .source = "this tool: presets",
              .access = at<[](auto& d) -> auto& { return d.name; }>(),
              .matters = never},
};

std::vector<Parameter> joined() {
  std::vector<Parameter> all(k_preset_parameters.begin(), k_preset_parameters.end());
  for (const std::span<const Parameter> part : {surface_parameters(), pndf_parameters(), view_parameters()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace

std::span<const Parameter> parameters() {
  static const std::vector<Parameter> all = joined();
  return all;
}

}  // namespace glint
