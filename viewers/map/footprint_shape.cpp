#include "viewers/map/footprint_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glint::view {
namespace {

using std::numbers::pi;

double dot(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.x + a.y * b.y;
}

double length(glm::dvec2 a) {
  return std::hypot(a.x, a.y);
}

// An axis has no direction: the angle is known up to half a turn.
double half_turn_angle(double angle) {
  const double turned = angle - pi * std::ceil(angle / pi - 0.5);
  return turned <= -pi / 2 ? turned + pi : turned;
}

double within_limits(double width) {
  return std::clamp(width, k_smallest_width, k_largest_width);
}

// The angles at which one coordinate of the ellipse, center + a cos + b sin, passes `edge`.
void add_crossings(std::vector<double>& angles, double center, double a, double b, double edge) {
  const double reach = std::hypot(a, b);
  if (std::abs(edge - center) >= reach) return;
  const double middle = std::atan2(b, a);
  const double half = std::acos((edge - center) / reach);
  angles.push_back(middle - half);
  angles.push_back(middle + half);
}

glm::dvec2 point_at(const ScreenEllipse& e, double angle) {
  return e.center + std::cos(angle) * e.a + std::sin(angle) * e.b;
}

// Chords leave a circle of radius r by r (1 - cos(step / 2)), about r step^2 / 8.
Arc arc_between(const ScreenEllipse& e, double from, double to, bool closed) {
  constexpr double k_most_off = 0.2;  // pixels
  const double radius = std::max({length(e.a), length(e.b), 1.0});
  const double step = std::min(0.2, std::sqrt(8 * k_most_off / radius));
  const int count = static_cast<int>(std::clamp(std::ceil((to - from) / step), 1.0, 4000.0));
  Arc arc;
  arc.closed = closed;
  for (int k = 0; k < count + (closed ? 0 : 1); ++k) {
    const glm::dvec2 p = point_at(e, from + (to - from) * k / count);
    arc.points.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
  }
  return arc;
}

}  // namespace

FootprintShape shape_of(const SymmetricMatrix2& covariance) {
  const glm::dvec2 variances = eigenvalues(covariance);
  FootprintShape shape;
  shape.widths = {std::sqrt(variances.x), std::sqrt(variances.y)};
  const double difference = covariance.xx - covariance.yy;
  // A circle up to rounding has no direction; a meaningless one would show as an angle.
  if (std::hypot(difference, 2 * covariance.xy) > 1e-12 * variances.x) {
    shape.angle = half_turn_angle(0.5 * std::atan2(2 * covariance.xy, difference));
  }
  return shape;
}

SymmetricMatrix2 covariance_of(const FootprintShape& shape) {
  const double c = std::cos(shape.angle);
  const double s = std::sin(shape.angle);
  const double first = shape.widths.x * shape.widths.x;
  const double second = shape.widths.y * shape.widths.y;
  return {first * c * c + second * s * s, (first - second) * c * s, first * s * s + second * c * c};
}

glm::dvec2 axis_direction(const FootprintShape& shape, int axis) {
  const double c = std::cos(shape.angle);
  const double s = std::sin(shape.angle);
  return axis == 0 ? glm::dvec2(c, s) : glm::dvec2(-s, c);
}

FootprintShape with_axis_end(const FootprintShape& start, AxisEnd end, glm::dvec2 offset, DragRule rule) {
  const glm::dvec2 outward = offset * static_cast<double>(end.side);
  FootprintShape shape = start;
  double width = length(outward);
  if (rule.keep_angle) {
    width = dot(outward, axis_direction(start, end.axis));
  } else if (width > 1e-9) {
    shape.angle = half_turn_angle(std::atan2(outward.y, outward.x) - (end.axis == 0 ? 0 : pi / 2));
  }
  const int other = 1 - end.axis;
  shape.widths[end.axis] = within_limits(width);
  if (rule.keep_ratio) {
    const double ratio = start.widths[other] / start.widths[end.axis];
    shape.widths[other] = within_limits(shape.widths[end.axis] * ratio);
    shape.widths[end.axis] = within_limits(shape.widths[other] / ratio);  // the ratio holds at the limits too
  } else {
    shape.widths[other] = within_limits(start.widths[other]);
  }
  return shape;
}

ScreenEllipse ring(const FootprintShape& shape, glm::dvec2 center, double pixels_per_texel, double deviations) {
  const double scale = pixels_per_texel * deviations;
  return {center, scale * shape.widths.x * axis_direction(shape, 0), scale * shape.widths.y * axis_direction(shape, 1)};
}

glm::dvec2 half_extent(const ScreenEllipse& ellipse) {
  return {std::hypot(ellipse.a.x, ellipse.b.x), std::hypot(ellipse.a.y, ellipse.b.y)};
}

std::vector<Arc> visible_arcs(const ScreenEllipse& ellipse, const Rectangle& area) {
  std::vector<double> angles;
  add_crossings(angles, ellipse.center.x, ellipse.a.x, ellipse.b.x, static_cast<double>(area.min.x));
  add_crossings(angles, ellipse.center.x, ellipse.a.x, ellipse.b.x, static_cast<double>(area.max.x));
  add_crossings(angles, ellipse.center.y, ellipse.a.y, ellipse.b.y, static_cast<double>(area.min.y));
  add_crossings(angles, ellipse.center.y, ellipse.a.y, ellipse.b.y, static_cast<double>(area.max.y));
  const auto inside = [&](double angle) {
    const glm::dvec2 p = point_at(ellipse, angle);
    return area.contains({static_cast<float>(p.x), static_cast<float>(p.y)});
  };
  std::vector<Arc> arcs;
  if (angles.empty()) {
    if (inside(0)) arcs.push_back(arc_between(ellipse, 0, 2 * pi, true));
    return arcs;
  }
  for (double& angle : angles) angle -= 2 * pi * std::floor(angle / (2 * pi));
  std::sort(angles.begin(), angles.end());
  angles.push_back(angles.front() + 2 * pi);
  for (std::size_t k = 0; k + 1 < angles.size(); ++k) {
    if (angles[k + 1] > angles[k] && inside(0.5 * (angles[k] + angles[k + 1]))) {
      arcs.push_back(arc_between(ellipse, angles[k], angles[k + 1], false));
    }
  }
  return arcs;
}

std::array<ImVec2, 4> handle_positions(const ScreenEllipse& one_sigma, double least_distance) {
  std::array<ImVec2, 4> positions;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const glm::dvec2 axis = k_axis_ends[k].axis == 0 ? one_sigma.a : one_sigma.b;
    const double reach = std::max(length(axis), 1e-12);
    const double stretch = std::max(1.0, least_distance / reach) * k_axis_ends[k].side;
    const glm::dvec2 p = one_sigma.center + stretch * axis;
    positions[k] = {static_cast<float>(p.x), static_cast<float>(p.y)};
  }
  return positions;
}

std::optional<int> handle_at(std::span<const ImVec2, 4> handles, ImVec2 mouse, float reach) {
  std::optional<int> nearest;
  float least = 0;
  for (std::size_t k = 0; k < handles.size(); ++k) {
    const float dx = std::abs(handles[k].x - mouse.x);
    const float dy = std::abs(handles[k].y - mouse.y);
    if (std::max(dx, dy) > reach) continue;
    const float distance = std::hypot(dx, dy);
    if (nearest && distance >= least) continue;
    nearest = static_cast<int>(k);
    least = distance;
  }
  return nearest;
}

}  // namespace glint::view
