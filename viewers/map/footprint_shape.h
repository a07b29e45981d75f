#pragma once
// The footprint as an ellipse: widths and angle from its covariance and back, its rings, and what dragging one of its
// handles does. Pure functions.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "core/math/gaussian.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

/// Standard deviations along two perpendicular axes, in texels. Axis 0 has the direction (cos angle, sin angle) in
/// texture space, u right and v down: a positive angle turns clockwise on the screen. Axis 1 is a right angle further.
struct FootprintShape {
  glm::dvec2 widths{1, 1};  ///< sigma_1, sigma_2
  double angle = 0;         ///< radians, in (-pi/2, pi/2]
};

inline constexpr double k_smallest_width = 0.05;  ///< texels, that dragging a handle reaches
inline constexpr double k_largest_width = 1e4;

/// sigma_1 >= sigma_2; the angle of a circle is 0. `covariance` must be positive definite.
FootprintShape shape_of(const SymmetricMatrix2& covariance);
SymmetricMatrix2 covariance_of(const FootprintShape& shape);
/// Unit vector of axis 0 or 1.
glm::dvec2 axis_direction(const FootprintShape& shape, int axis);

/// One of the four ends of the axes.
struct AxisEnd {
  int axis = 0;  ///< 0 or 1
  int side = 1;  ///< +1 or -1

  friend bool operator==(const AxisEnd&, const AxisEnd&) = default;
};
/// map.handle.1 to map.handle.4, in this order.
inline constexpr std::array<AxisEnd, 4> k_axis_ends{AxisEnd{0, 1}, {1, 1}, {0, -1}, {1, -1}};

/// What dragging holds fast.
struct DragRule {
  bool keep_angle = false;  ///< the axis keeps its direction: only its width follows
  bool keep_ratio = false;  ///< the other width grows in proportion; else it keeps its length
};

/// The shape whose axis ends at `offset` from the centre (texels), made from the shape at the begin of the drag. The
/// axes keep their numbers, whichever is longer; widths stay within the limits above.
FootprintShape with_axis_end(const FootprintShape& start, AxisEnd end, glm::dvec2 offset, DragRule rule);

/// An ellipse on the screen: center + a cos(theta) + b sin(theta), a and b perpendicular or not.
struct ScreenEllipse {
  glm::dvec2 center;
  glm::dvec2 a;
  glm::dvec2 b;
};
/// The ring at `deviations` standard deviations of a footprint at `center` (pixels).
ScreenEllipse ring(const FootprintShape& shape, glm::dvec2 center, double pixels_per_texel, double deviations);
/// Half the extents of its bounding box.
glm::dvec2 half_extent(const ScreenEllipse& ellipse);

struct Arc {
  std::vector<ImVec2> points;
  bool closed = false;  ///< all of the ellipse
};
/// The parts of an ellipse inside `area`, as lines that leave it by less than a quarter of a pixel. However large it
/// is, the number of points stays bounded by the size of the area.
std::vector<Arc> visible_arcs(const ScreenEllipse& ellipse, const Rectangle& area);

/// Where the handles of an ellipse stand: at the ends of its axes, but at least `least_distance` from the centre, so
/// that a small ellipse can be taken hold of. In the order of k_axis_ends.
std::array<ImVec2, 4> handle_positions(const ScreenEllipse& one_sigma, double least_distance);
/// The nearest handle within `reach` of the mouse along both axes of the screen, by index.
std::optional<int> handle_at(std::span<const ImVec2, 4> handles, ImVec2 mouse, float reach);

}  // namespace glint::view
