#include "core/math/simplex_integral.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/math/gaussian.h"
#include "core/math/quadrature.h"

namespace glint {
namespace {

// What lies farther than this beyond the triangle's nearest point adds less than exp(-26) of the result.
constexpr double k_window = 7.25;
constexpr double k_panel = 3;            // length of a panel of the strip rule, standard deviations
constexpr double k_panel_gradient = 12;  // largest change of the exponent along a panel
constexpr int k_panel_points = 12;

double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

// Vertices ordered so that apex is opposite the edge from a to b.
struct Ordered {
  glm::dvec2 apex;
  glm::dvec2 a;
  glm::dvec2 b;
};

struct Shape {
  std::array<glm::dvec2, 3> vertices;
  std::array<double, 3> lengths;  // of the edge opposite each vertex
  double twice_area;
  double farthest;  // largest distance of a vertex from the origin
  [[nodiscard]] Ordered opposite_of(std::size_t k) const {
    return {vertices[k], vertices[(k + 1) % 3], vertices[(k + 2) % 3]};
  }
};

Shape shape_of(const WhitenedTriangle& t) {
  Shape shape{};
  shape.vertices = {t.w0, t.w0 + glm::dvec2(t.r11, 0), t.w0 + glm::dvec2(t.r12, t.r22)};
  shape.lengths = {std::hypot(t.r12 - t.r11, t.r22), std::hypot(t.r12, t.r22), std::abs(t.r11)};
  shape.twice_area = std::abs(t.r11 * t.r22);
  for (const glm::dvec2& v : shape.vertices) shape.farthest = std::max(shape.farthest, glm::length(v));
  return shape;
}

// Signed distances of the origin from the three edges, positive inside. Meaningless for a degenerate triangle.
std::array<double, 3> edge_distances(const Shape& shape, bool counter_clockwise) {
  std::array<double, 3> distances{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Ordered o = shape.opposite_of(k);
    distances[k] = (counter_clockwise ? 1 : -1) * cross(o.a, o.b) / shape.lengths[k];
  }
  return distances;
}

double distance_to_segment(glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 edge = b - a;
  const double squared = glm::dot(edge, edge);
  const double along = squared > 0 ? std::clamp(-glm::dot(a, edge) / squared, 0.0, 1.0) : 0.0;
  return glm::length(a + along * edge);
}

// Small triangles: a product rule on the rays from the apex to the shortest edge, weight z along the ray. `value` takes
// the position on the ray, z, and on the edge.
template <class Value>
double ray_cubature(int along, int across, Value value) {
  const GaussRule ray = gauss_legendre(along);
  const GaussRule edge = gauss_legendre(across);
  double sum = 0;
  for (std::size_t q = 0; q < edge.nodes.size(); ++q) {
    double line = 0;
    for (std::size_t k = 0; k < ray.nodes.size(); ++k) {
      line += ray.weights[k] * ray.nodes[k] * value(ray.nodes[k], edge.nodes[q]);
    }
    sum += edge.weights[q] * line;
  }
  return sum;
}

// The point at z of the ray from the apex to the point q of the opposite edge.
glm::dvec2 on_ray(const Ordered& o, double z, double q) {
  return o.apex + z * (o.a + q * (o.b - o.a) - o.apex);
}

// The mean of exp(-x^2 / 2) over [a, a + length]: a difference of erfc of one sign, or Gauss where that would cancel.
double fibre(double a, double length) {
  const double b = a + length;
  if (length < 0.5 && length * std::max(std::abs(a), std::abs(b)) < 2) {
    const GaussRule rule = gauss_legendre(7);
    double sum = 0;
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
      const double x = a + length * rule.nodes[k];
      sum += rule.weights[k] * std::exp(-0.5 * x * x);
    }
    return sum;
  }
  constexpr double r = 1 / std::numbers::sqrt2;
  double difference = 0;
  if (a > 0) {
    difference = std::erfc(a * r) - std::erfc(b * r);
  } else if (b < 0) {
    difference = std::erfc(-b * r) - std::erfc(-a * r);
  } else {
    difference = std::erf(b * r) - std::erf(a * r);
  }
  return std::sqrt(std::numbers::pi / 2) * difference / length;
}

// Composite Gauss over [begin, end] in `count` panels.
template <class Value>
double composite(double begin, double end, int count, Value value) {
  const double width = (end - begin) / count;
  const GaussRule rule = gauss_legendre(k_panel_points);
  double sum = 0;
  for (int panel = 0; panel < count; ++panel) {
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
      sum += rule.weights[k] * value(begin + (panel + rule.nodes[k]) * width);
    }
  }
  return sum * width;
}

// One side of the strip rule: from a base vertex to the foot of the apex, xi(z) = xi0 + slope z, eta in
// [eta0, eta0 + height z].
struct Side {
  double xi0;
  double slope;
  double eta0;
  double height;
};

int panel_count(double along, double across, double nearest) {
  const double gradient = (along + across) * (nearest + k_panel) / k_panel_gradient;
  return static_cast<int>(std::ceil(std::max({along / k_panel, across / k_panel, gradient, 1.0})));
}

// Integrates z fibre(z) over one side, cut to the window round the triangle's nearest point. `fibre_mean` takes z and
// returns the mean over the fibre of everything but the factor in xi.
template <class FibreMean>
double side_integral(const Side& side, double nearest, double window, FibreMean fibre_mean) {
  double begin = 0;
  double end = 1;
  if (side.slope != 0) {
    const double first = (-window - side.xi0) / side.slope;
    const double second = (window - side.xi0) / side.slope;
    begin = std::max(begin, std::min(first, second));
    end = std::min(end, std::max(first, second));
  }
  // Below the window the fibre is empty; above it, it has all it can get and its integral depends on z no more.
  double saturation = 1;
  if (side.height > 0) {
    begin = std::max(begin, (-window - side.eta0) / side.height);
    saturation = (window - side.eta0) / side.height;
  }
  if (!(begin < end)) return 0;
  saturation = std::clamp(saturation, begin, end);
  const auto value = [&](double z) {
    const double xi = side.xi0 + side.slope * z;
    return z * std::exp(-0.5 * xi * xi) * fibre_mean(z);
  };
  double sum = 0;
  if (begin < saturation) {
    const double part = saturation - begin;
    const int count = panel_count(part * std::abs(side.slope), part * side.height, nearest);
    sum += composite(begin, saturation, count, value);
  }
  if (saturation < end) {
    const int count = panel_count((end - saturation) * std::abs(side.slope), 0, nearest);
    sum += composite(saturation, end, count, value);
  }
  return sum;
}

// A strip on the longest edge from a to b: its two sides, left and right of the apex's foot, and their shares.
struct Strip {
  Side at_a;
  Side at_b;
  double share_a;
  double share_b;
};

Strip strip_of(const Ordered& o, double base_length, double twice_area) {
  const glm::dvec2 along = (o.b - o.a) / base_length;
  const double height = twice_area / base_length;
  const double foot = std::clamp(glm::dot(o.apex - o.a, along), 0.0, base_length);
  // eta grows from the base towards the apex.
  const double sign = cross(along, o.apex - o.a) < 0 ? -1 : 1;
  const double eta0 = sign * cross(along, o.a);
  const double rest = base_length - foot;
  return {{glm::dot(o.a, along), foot, eta0, height},
          {glm::dot(o.b, along), -rest, eta0, height},
          foot / base_length,
          rest / base_length};
}

double distance_to_boundary(const Shape& shape) {
  double nearest = shape.farthest;
  for (std::size_t k = 0; k < 3; ++k) {
    const Ordered o = shape.opposite_of(k);
    nearest = std::min(nearest, distance_to_segment(o.a, o.b));
  }
  return nearest;
}

std::size_t index_of(const std::array<double, 3>& lengths, double length) {
  return static_cast<std::size_t>(std::find(lengths.begin(), lengths.end(), length) - lengths.begin());
}

// Large triangles: Gauss across the strip, the fibre towards the apex in closed form.
double strip_rule(const Shape& shape, std::size_t longest, double nearest, double window) {
  const Strip strip = strip_of(shape.opposite_of(longest), shape.lengths[longest], shape.twice_area);
  const auto integrate = [&](const Side& side) {
    return side_integral(side, nearest, window, [&](double z) { return fibre(side.eta0, side.height * z); });
  };
  double sum = 0;
  if (strip.share_a > 0) sum += strip.share_a * integrate(strip.at_a);
  if (strip.share_b > 0) sum += strip.share_b * integrate(strip.at_b);
  return sum;
}

// A polynomial of degree 4 through the values at 0, 1/4, 1/2, 3/4 and 1.
using FibreValues = std::array<double, 5>;

FibreValues fibre_polynomial(const FibreValues& v) {
  return {v[0], (-25 * v[0] + 48 * v[1] - 36 * v[2] + 16 * v[3] - 3 * v[4]) / 3,
          (70 * v[0] - 208 * v[1] + 228 * v[2] - 112 * v[3] + 22 * v[4]) / 3,
          (-80 * v[0] + 288 * v[1] - 384 * v[2] + 224 * v[3] - 48 * v[4]) / 3,
          (32 * v[0] - 128 * v[1] + 192 * v[2] - 128 * v[3] + 32 * v[4]) / 3};
}

double polynomial_at(const FibreValues& c, double x) {
  return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * c[4])));
}

// The integral over tau in [0, 1] of a polynomial times exp(-(a + length tau)^2 / 2): by the moments of the Gaussian
// about its middle, where the fibre is long enough for them not to cancel, else by Gauss.
double weighted_fibre(double a, double length, const FibreValues& polynomial) {
  if (length < 0.75) {
    const GaussRule rule = gauss_legendre(12);
    double sum = 0;
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
      const double x = a + length * rule.nodes[k];
      sum += rule.weights[k] * polynomial_at(polynomial, rule.nodes[k]) * std::exp(-0.5 * x * x);
    }
    return sum;
  }
  const double b = a + length;
  // Coefficients in x = a + length tau: the polynomial expanded about tau = -a / length, by repeated division.
  FibreValues about = polynomial;
  const double middle = -a / length;
  for (std::size_t order = 0; order < about.size(); ++order) {
    for (std::size_t k = about.size() - 1; k-- > order;) about[k] += middle * about[k + 1];
  }
  const double at_a = std::exp(-0.5 * a * a);
  const double at_b = std::exp(-0.5 * b * b);
  FibreValues moments{fibre(a, length) * length, at_a - at_b};
  double power_a = at_a;
  double power_b = at_b;
  for (std::size_t k = 2; k < moments.size(); ++k) {
    power_a *= a;
    power_b *= b;
    moments[k] = static_cast<double>(k - 1) * moments[k - 2] + power_a - power_b;
  }
  double sum = 0;
  double scale = 1 / length;
  for (std::size_t k = 0; k < moments.size(); ++k) {
    sum += about[k] * scale * moments[k];
    scale /= length;
  }
  return std::max(sum, 0.0);
}

// The same with a weight, taken as a polynomial along each fibre; `corners` are the simplex coordinates of the apex, a
// and b.
double weighted_strip_rule(const Shape& shape, std::size_t longest, double nearest, double window,
                           const Ordered& corners, const std::function<double(glm::dvec2)>& weight) {
  const Strip strip = strip_of(shape.opposite_of(longest), shape.lengths[longest], shape.twice_area);
  const auto integrate = [&](const Side& side, double share, glm::dvec2 from, glm::dvec2 to) {
    return side_integral(side, nearest, window, [&](double z) {
      const glm::dvec2 bottom = from + share * z * (to - from);
      const glm::dvec2 span = from + z * (corners.apex - from) - bottom;
      FibreValues values{};
      for (std::size_t k = 0; k < values.size(); ++k) {
        values[k] = weight(bottom + 0.25 * static_cast<double>(k) * span);
      }
      return weighted_fibre(side.eta0, side.height * z, fibre_polynomial(values));
    });
  };
  double sum = 0;
  if (strip.share_a > 0) sum += strip.share_a * integrate(strip.at_a, strip.share_a, corners.a, corners.b);
  if (strip.share_b > 0) sum += strip.share_b * integrate(strip.at_b, strip.share_b, corners.b, corners.a);
  return sum;
}

}  // namespace

int gauss_points(double length, double reach) {
  struct Rule {
    double length;
    double gradient;
    int points;
  };
  // Measured: the largest length and length x reach for which the rule of so many points is good to 1e-12.
  static constexpr std::array k_rules = {Rule{0.05, 0.3, 4}, Rule{0.2, 0.75, 5},  Rule{0.5, 1.6, 6},
                                         Rule{0.75, 2.8, 7}, Rule{1.0, 4.2, 8},   Rule{1.5, 5.8, 9},
                                         Rule{2.0, 8.1, 10}, Rule{2.5, 13.0, 12}, Rule{3.0, 19.0, 14}};
  for (const Rule& rule : k_rules) {
    if (length <= rule.length && length * reach <= rule.gradient) return rule.points;
  }
  return 0;
}

double gaussian_over_simplex(const WhitenedTriangle& triangle, double cut) {
  const Shape shape = shape_of(triangle);
  const auto [shortest, longest] = std::minmax({shape.lengths[0], shape.lengths[1], shape.lengths[2]});
  std::array<double, 3> distances{-1, -1, -1};
  if (shape.twice_area > 0) distances = edge_distances(shape, triangle.r11 * triangle.r22 > 0);
  std::sort(distances.begin(), distances.end());
  const double nearest = distances[0] >= 0 ? 0 : distance_to_boundary(shape);
  if (nearest >= cut) return 0;

  const int along = gauss_points(longest, shape.farthest);
  if (along > 0) {
    const Ordered o = shape.opposite_of(index_of(shape.lengths, shortest));
    return ray_cubature(along, gauss_points(shortest, shape.farthest), [&](double z, double q) {
      const glm::dvec2 w = on_ray(o, z, q);
      return std::exp(-0.5 * glm::dot(w, w));
    });
  }
  // One edge at most within reach: a half plane.
  if (distances[0] > -1 && distances[1] > k_window + 1) {
    return 2 * std::numbers::pi * normal_cdf(distances[0]) / shape.twice_area;
  }
  return strip_rule(shape, index_of(shape.lengths, longest), nearest, std::min(cut, std::hypot(nearest, k_window)));
}

double weighted_gaussian_over_simplex(const WhitenedTriangle& triangle, double cut,
                                      const std::function<double(glm::dvec2)>& weight) {
  constexpr int k_weight_points = 3;
  const Shape shape = shape_of(triangle);
  const auto [shortest, longest] = std::minmax({shape.lengths[0], shape.lengths[1], shape.lengths[2]});
  const auto corners_opposite = [](std::size_t k) {
    constexpr std::array<glm::dvec2, 3> k_corners = {glm::dvec2{0, 0}, glm::dvec2{1, 0}, glm::dvec2{0, 1}};
    return Ordered{k_corners[k], k_corners[(k + 1) % 3], k_corners[(k + 2) % 3]};
  };
  std::array<double, 3> distances{-1, -1, -1};
  if (shape.twice_area > 0) distances = edge_distances(shape, triangle.r11 * triangle.r22 > 0);
  const bool inside = *std::min_element(distances.begin(), distances.end()) >= 0;
  const double nearest = inside ? 0 : distance_to_boundary(shape);
  if (nearest >= cut) return 0;

  const int along = gauss_points(longest, shape.farthest);
  if (along > 0) {
    const std::size_t k = index_of(shape.lengths, shortest);
    const Ordered o = shape.opposite_of(k);
    const Ordered corners = corners_opposite(k);
    const int across = gauss_points(shortest, shape.farthest);
    return ray_cubature(std::max(along, k_weight_points + 1), std::max(across, k_weight_points),
                        [&](double z, double q) {
                          const glm::dvec2 w = on_ray(o, z, q);
                          return weight(on_ray(corners, z, q)) * std::exp(-0.5 * glm::dot(w, w));
                        });
  }
  const std::size_t k = index_of(shape.lengths, longest);
  return weighted_strip_rule(shape, k, nearest, std::min(cut, std::hypot(nearest, k_window)), corners_opposite(k),
                             weight);
}

}  // namespace glint
