#include "viewers/map/map_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace glint::view {
namespace {

std::uint8_t eight_bits(float x) {
  return static_cast<std::uint8_t>(std::lrint(255.0F * std::clamp(0.5F * x + 0.5F, 0.0F, 1.0F)));
}

float z_of(glm::vec2 n) {
  return std::sqrt(std::max(0.0F, 1 - n.x * n.x - n.y * n.y));
}

// Viridis at x in [0, 1], one of 256 entries as in the shader; a tile has too many texels to interpolate for each.
DisplayColor viridis_entry(double x) {
  static const std::array<DisplayColor, 256> k_table = viridis_table();
  if (!(x >= 0)) return k_underflow_color;
  if (x > 1) return k_overflow_color;
  return k_table[static_cast<std::size_t>(std::lrint(255 * x))];
}

DisplayColor color_at_slope(double slope) {
  return viridis_entry(slope / k_steepest_slope);
}

DisplayColor color_at_curvature(double curvature) {
  static const double k_per_log = 1 / std::log(k_curvature_scale.hi / k_curvature_scale.lo);
  return curvature > 0 ? viridis_entry(std::log(curvature / k_curvature_scale.lo) * k_per_log) : k_underflow_color;
}

// The value a texel has in a picture of slope or curvature.
double scalar_of(const NormalPyramid& pyramid, MapColors colors, int level, int i, int j) {
  return colors == MapColors::slope ? slope_of(pyramid.texel(level, i, j)) : curvature_of(pyramid, level, i, j);
}

// Two of a hundred values lie outside [low, high].
struct Spread {
  double low;
  double high;
};
Spread spread_of(std::vector<double> values) {
  const auto rank = [&](double share) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  return {rank(0.01), rank(0.99)};
}

void store(std::vector<std::uint8_t>& texels, DisplayColor color) {
  texels.insert(texels.end(), {color.x, color.y, color.z, 255});
}

Overview overview_of_normals(const NormalPyramid& pyramid, int level) {
  const std::vector<glm::vec2>& normals = pyramid.texels(level);
  std::vector<double> sizes;
  sizes.reserve(normals.size());
  for (const glm::vec2 n : normals) sizes.push_back(std::max(std::abs(n.x), std::abs(n.y)));
  const auto stretch =
      static_cast<float>(std::clamp(0.7 / std::max(spread_of(std::move(sizes)).high, 1e-9), 1.0, 40.0));
  Overview overview{{pyramid.width(level), pyramid.height(level)}, {}};
  for (const glm::vec2 n : normals) {
    glm::vec2 stretched(n.x * stretch, n.y * stretch);
    const float length = std::hypot(stretched.x, stretched.y);
    if (length > 1) stretched = {stretched.x / length, stretched.y / length};
    store(overview.texels, normal_color(stretched));
  }
  return overview;
}

Overview overview_of_scalars(const NormalPyramid& pyramid, MapColors colors, int level) {
  Overview overview{{pyramid.width(level), pyramid.height(level)}, {}};
  std::vector<double> values;
  for (int j = 0; j < overview.size.y; ++j) {
    for (int i = 0; i < overview.size.x; ++i) values.push_back(scalar_of(pyramid, colors, level, i, j));
  }
  const Spread spread = spread_of(values);
  const double span = spread.high > spread.low && std::isfinite(spread.high) ? spread.high - spread.low : 1;
  for (const double value : values) {
    store(overview.texels, viridis_entry(std::clamp((value - spread.low) / span, 0.0, 1.0)));
  }
  return overview;
}

}  // namespace

double slope_of(glm::vec2 normal) {
  const double s = normal.x;
  const double t = normal.y;
  const double zz = 1 - s * s - t * t;
  return zz > 0 ? std::sqrt((s * s + t * t) / zz) : std::numeric_limits<double>::infinity();
}

double curvature_of(const NormalPyramid& pyramid, int level, std::int64_t i, std::int64_t j) {
  const glm::vec2 right = pyramid.texel(level, i + 1, j);
  const glm::vec2 left = pyramid.texel(level, i - 1, j);
  const glm::vec2 below = pyramid.texel(level, i, j + 1);
  const glm::vec2 above = pyramid.texel(level, i, j - 1);
  const glm::dvec2 du(right.x - left.x, right.y - left.y);
  const glm::dvec2 dv(below.x - above.x, below.y - above.y);
  return std::sqrt(du.x * du.x + du.y * du.y + dv.x * dv.x + dv.y * dv.y) / std::ldexp(2.0, level);
}

DisplayColor normal_color(glm::vec2 normal) {
  return {eight_bits(normal.x), eight_bits(normal.y), eight_bits(z_of(normal))};
}

DisplayColor texel_color(const NormalPyramid& pyramid, MapColors colors, int level, std::int64_t i, std::int64_t j) {
  switch (colors) {
    case MapColors::slope:
      return color_at_slope(slope_of(pyramid.texel(level, i, j)));
    case MapColors::curvature:
      return color_at_curvature(curvature_of(pyramid, level, i, j));
    case MapColors::normal:
      break;
  }
  return normal_color(pyramid.texel(level, i, j));
}

std::vector<std::uint8_t> colored_texels(const NormalPyramid& pyramid, MapColors colors, int level, glm::ivec2 first,
                                         glm::ivec2 size) {
  std::vector<std::uint8_t> texels(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 4);
  std::uint8_t* at = texels.data();
  for (int j = first.y; j < first.y + size.y; ++j) {
    for (int i = first.x; i < first.x + size.x; ++i) {
      const DisplayColor color = texel_color(pyramid, colors, level, i, j);
      *at++ = color.x;
      *at++ = color.y;
      *at++ = color.z;
      *at++ = 255;
    }
  }
  return texels;
}

Overview overview_of(const NormalPyramid& pyramid, MapColors colors, int side) {
  int level = 0;
  while (level + 1 < pyramid.levels() && std::max(pyramid.width(level + 1), pyramid.height(level + 1)) >= side) {
    ++level;
  }
  return colors == MapColors::normal ? overview_of_normals(pyramid, level)
                                     : overview_of_scalars(pyramid, colors, level);
}

}  // namespace glint::view
