#pragma once
// The range of a colour bar: which values its ends stand for, fitted or set. Pure functions.

#include <optional>
#include <string>

#include <glm/vec2.hpp>

#include "core/document/document.h"
#include "viewers/gl/frame_pictures.h"

namespace glint::view {

/// Densities at the ends of the colour bar.
struct DensityRange {
  double lowest = 1e-4;
  double highest = 1;
  bool logarithmic = true;

  /// 0 at the lowest, 1 at the highest; below 0 and above 1 outside. What is not above zero lies below every
  /// logarithmic range.
  [[nodiscard]] double position(double density) const;
  [[nodiscard]] double at(double position) const;
  [[nodiscard]] Shading shading(bool nearest) const;

  friend bool operator==(const DensityRange&, const DensityRange&) = default;
};

/// Logarithmic: four decades below `largest`, rounded up to 1, 2 or 5 x 10^n; linear: from 0 up to that. A largest
/// density that is zero or no number fits like 1.
DensityRange fitted_density_range(ColorScale scale, double largest);
/// The range of the document, or the fitted one.
DensityRange shown_density_range(const ViewSettings& view, double largest);

/// |difference| at the ends of its bar; `logarithmic` is symmetric about zero, two decades to either side.
struct DifferenceRange {
  double highest = 1;
  bool logarithmic = true;

  [[nodiscard]] double lowest() const { return highest * 1e-2; }
  [[nodiscard]] Shading shading(bool nearest) const;
};
DifferenceRange shown_difference_range(const ViewSettings& view, double largest);

/// Why these cannot be the ends of the density bar, as a sentence, or nothing.
std::optional<std::string> density_range_fault(glm::dvec2 range);
/// The same of the difference bar.
std::optional<std::string> difference_range_fault(double highest);

/// The range after the colours were dragged by `share` of the bar's length (up is positive) from `grabbed`, a position
/// on the bar: logarithmic ranges shift, linear ones keep their lower end and scale. Ends have two significant digits.
glm::dvec2 dragged_density_range(const DensityRange& start, double grabbed, double share);

}  // namespace glint::view
