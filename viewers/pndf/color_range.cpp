#include "viewers/pndf/color_range.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/image/color_map.h"
#include "viewers/pndf/axis_ticks.h"
#include "viewers/widgets/number_text.h"

namespace glint::view {
namespace {

// What the document takes for a density at an end of the bar.
constexpr double k_smallest_end = 1e-30;
constexpr double k_largest_end = 1e30;

double usable(double largest) {
  return std::isfinite(largest) && largest > 0 ? std::clamp(largest, 1e-20, 1e29) : 1;
}

double two_digits(double value) {
  return parsed_number(fmt::format("{:.1e}", value)).value_or(value);
}

}  // namespace

double DensityRange::position(double density) const {
  if (!logarithmic) return (density - lowest) / (highest - lowest);
  return density > 0 ? std::log(density / lowest) / std::log(highest / lowest) : -1;
}

double DensityRange::at(double position) const {
  return logarithmic ? lowest * std::pow(highest / lowest, position) : lowest + position * (highest - lowest);
}

Shading DensityRange::shading(bool nearest) const {
  return {.kind = Shading::Kind::density,
          .lo = static_cast<float>(lowest),
          .hi = static_cast<float>(highest),
          .logarithmic = logarithmic,
          .nearest = nearest};
}

DensityRange fitted_density_range(ColorScale scale, double largest) {
  if (scale == ColorScale::linear) return {0, rounded_up_step(usable(largest)), false};
  const LogScale fitted = fitted_scale(usable(largest));
  return {fitted.lo, fitted.hi, true};
}

DensityRange shown_density_range(const ViewSettings& view, double largest) {
  if (!view.density_range) return fitted_density_range(view.density_scale, largest);
  return {view.density_range->x, view.density_range->y, view.density_scale == ColorScale::logarithmic};
}

Shading DifferenceRange::shading(bool nearest) const {
  return {.kind = Shading::Kind::difference,
          .lo = static_cast<float>(lowest()),
          .hi = static_cast<float>(highest),
          .logarithmic = logarithmic,
          .nearest = nearest};
}

DifferenceRange shown_difference_range(const ViewSettings& view, double largest) {
  return {view.difference_range.value_or(rounded_up_step(usable(largest))),
          view.density_scale == ColorScale::logarithmic};
}

std::optional<std::string> density_range_fault(glm::dvec2 range) {
  for (const double end : {range.x, range.y}) {
    if (!(end > 0)) return "An end of the colour bar must be a density above 0.";
    if (!(end >= k_smallest_end && end <= k_largest_end)) {
      return "An end of the colour bar must lie between 1e-30 and 1e30.";
    }
  }
  if (!(range.x < range.y)) return "The lower end of the colour bar must be below its upper end.";
  return std::nullopt;
}

std::optional<std::string> difference_range_fault(double highest) {
  if (!(highest > 0)) return "The end of the difference bar must be above 0; its other end is the same below 0.";
  if (!(highest <= k_largest_end)) return "The end of the difference bar must be at most 1e30.";
  return std::nullopt;
}

glm::dvec2 dragged_density_range(const DensityRange& start, double grabbed, double share) {
  glm::dvec2 range{start.lowest, start.highest};
  if (start.logarithmic) {
    range *= std::pow(start.highest / start.lowest, -share);
  } else {
    const double held = std::clamp(grabbed, 0.05, 1.0);
    range.y = start.lowest + (start.highest - start.lowest) * held / std::clamp(held + share, 0.02, 20.0);
  }
  // A linear range may begin at 0 while it is fitted; one that is set begins just above, which looks the same.
  range.x = two_digits(std::clamp(std::max(range.x, range.y * 1e-9), k_smallest_end, 1e29));
  range.y = two_digits(std::clamp(range.y, k_smallest_end, k_largest_end));
  return range.x < range.y ? range : glm::dvec2(start.lowest, start.highest);
}

}  // namespace glint::view
