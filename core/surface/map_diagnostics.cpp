#include "core/surface/map_diagnostics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace glint {
namespace {

constexpr double k_least_z = 0.2;
constexpr std::size_t k_fewest_cells = 1024;
constexpr std::size_t k_most_cells = std::size_t{4} << 20;
constexpr std::size_t k_shortest_side = 8;

// A texel and the one below it, as slopes (h_u, h_v) of the surface that has these normals.
struct SlopePair {
  glm::dvec2 upper;
  glm::dvec2 lower;
  bool steep;  // too steep to take part
};

SlopePair slope_pair(glm::vec2 upper, glm::vec2 lower) {
  const auto z = [](glm::dvec2 n) { return std::sqrt(std::max(0.0, 1 - n.x * n.x - n.y * n.y)); };
  const glm::dvec2 a(upper);
  const glm::dvec2 b(lower);
  const double z_a = z(a);
  const double z_b = z(b);
  if (std::min(z_a, z_b) < k_least_z) return {{0, 0}, {0, 0}, true};
  return {{-a.x / z_a, a.y / z_a}, {-b.x / z_b, b.y / z_b}, false};
}

// Averages jumps that are finite.
class JumpMean {
 public:
  void add(double jump) {
    if (!std::isfinite(jump)) return;
    sum_ += jump;
    ++count_;
  }
  [[nodiscard]] double mean() const { return count_ == 0 ? 0 : sum_ / static_cast<double>(count_); }

 private:
  double sum_ = 0;
  std::size_t count_ = 0;
};

double ratio(const JumpMean& edge, const JumpMean& inner) {
  return inner.mean() > 0 ? edge.mean() / inner.mean() : 0;
}

// `jump(a, b)` compares two texels given by their index.
template <class Jump>
SeamRatios seam_ratios_of(int width, int height, Jump jump) {
  const auto columns = static_cast<std::size_t>(width);
  const auto rows = static_cast<std::size_t>(height);
  if (std::min(columns, rows) < k_shortest_side) return {};
  const std::size_t row_step = std::max<std::size_t>(1, columns * rows / k_most_cells);
  JumpMean inner_across;
  JumpMean inner_down;
  JumpMean edge_across;
  JumpMean edge_down;
  for (std::size_t j = 0; j + 1 < rows; j += row_step) {
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      inner_across.add(jump(j * columns + i, j * columns + i + 1));
      inner_down.add(jump(j * columns + i, (j + 1) * columns + i));
    }
  }
  for (std::size_t j = 0; j < rows; ++j) edge_across.add(jump(j * columns, j * columns + columns - 1));
  for (std::size_t i = 0; i < columns; ++i) edge_down.add(jump(i, (rows - 1) * columns + i));
  return {ratio(edge_across, inner_across), ratio(edge_down, inner_down)};
}

// An odd whole number, but for rounding: what 2 k - 255 is.
bool is_odd(double x, double tolerance) {
  return std::abs(x - (2 * std::floor(0.5 * x) + 1)) < tolerance;
}

// Whether n is some vector of odd numbers over `levels`, x and y alone or with z and then normalised.
bool is_of_levels(glm::dvec2 n, int levels) {
  const bool few = levels < 256;
  const double tolerance = few ? 1e-3 : 2e-2;  // floats, times the levels
  if (is_odd(n.x * levels, tolerance) && is_odd(n.y * levels, tolerance)) return true;
  const double z = std::sqrt(std::max(0.0, 1 - n.x * n.x - n.y * n.y)) * levels;
  if (z < 0.1 * levels) return false;
  // Of 8 bits any length from 0.5 to 1.5; of 16 only such as rounding leaves, or there would be too many to tell.
  const double least = few ? 0.5 * z : z - 4;
  const double greatest = std::min<double>(levels, few ? 1.5 * z : z + 4);
  for (double blue = 2 * std::floor(0.5 * least) + 1; blue <= greatest; blue += 2) {
    const double length = blue / z * levels;
    if (is_odd(n.x * length, tolerance) && is_odd(n.y * length, tolerance)) return true;
  }
  return false;
}

bool is_of_levels(std::span<const glm::vec2> normals, int levels) {
  constexpr std::size_t k_few = 16;  // after which it mostly is clear
  std::size_t fitting = 0;
  for (std::size_t k = 0; k < normals.size(); ++k) {
    if (k == k_few && fitting < k_few / 2) return false;
    fitting += is_of_levels(glm::dvec2(normals[k]), levels) ? 1 : 0;
  }
  return 10 * fitting >= 9 * normals.size();  // some may have been repaired
}

}  // namespace

std::optional<double> curl_ratio(const NormalMap& map) {
  const auto cells_across = static_cast<std::size_t>(map.width() - 1);
  const auto cells_down = static_cast<std::size_t>(map.height() - 1);
  if (cells_across * cells_down < k_fewest_cells || std::min(cells_across, cells_down) < k_shortest_side) return {};
  const std::size_t row_step = std::max<std::size_t>(1, cells_across * cells_down / k_most_cells);
  const std::size_t stride = cells_across + 1;
  const std::vector<glm::vec2>& normals = map.normals();
  double as_it_stands = 0;
  double negated = 0;
  std::size_t cells = 0;
  for (std::size_t j = 0; j < cells_down; j += row_step) {
    SlopePair left = slope_pair(normals[j * stride], normals[(j + 1) * stride]);
    for (std::size_t i = 1; i <= cells_across; ++i) {
      const SlopePair right = slope_pair(normals[j * stride + i], normals[(j + 1) * stride + i]);
      if (!left.steep && !right.steep) {
        const double dhu_dv = 0.5 * (left.lower.x + right.lower.x - left.upper.x - right.upper.x);
        const double dhv_du = 0.5 * (right.upper.y + right.lower.y - left.upper.y - left.lower.y);
        as_it_stands += (dhu_dv - dhv_du) * (dhu_dv - dhv_du);
        negated += (dhu_dv + dhv_du) * (dhu_dv + dhv_du);
        ++cells;
      }
      left = right;
    }
  }
  if (cells < k_fewest_cells) return {};
  constexpr double k_rounding = 1e-24;  // curl of a field that is flat but for rounding, squared, over the cells
  const double larger = std::max(as_it_stands, negated);
  if (larger <= k_rounding) return {};
  return negated / std::max(as_it_stands, 1e-12 * larger);
}

SeamRatios seam_ratios(const NormalMap& map) {
  const std::vector<glm::vec2>& normals = map.normals();
  return seam_ratios_of(map.width(), map.height(), [&](std::size_t a, std::size_t b) {
    const glm::vec2 d = normals[a] - normals[b];
    return static_cast<double>(std::abs(d.x)) + static_cast<double>(std::abs(d.y));
  });
}

SeamRatios seam_ratios(std::span<const float> heights, int width, int height) {
  return seam_ratios_of(width, height, [&](std::size_t a, std::size_t b) {
    return std::abs(static_cast<double>(heights[a]) - static_cast<double>(heights[b]));
  });
}

double value_step(const NormalMap& map) {
  constexpr std::size_t k_most_texels = 256;
  const std::vector<glm::vec2>& normals = map.normals();
  const std::size_t count = std::min(normals.size(), k_most_texels);
  std::vector<glm::vec2> sample;
  sample.reserve(count);
  const double spacing = static_cast<double>(normals.size()) / static_cast<double>(count);
  for (std::size_t k = 0; k < count; ++k) {
    // Shifted by shares of the golden ratio, or all would stand in one column.
    const double shift = std::fmod(0.618033988749895 * static_cast<double>(k), 1.0);
    sample.push_back(normals[static_cast<std::size_t>((static_cast<double>(k) + shift) * spacing)]);
  }
  const auto differs = [&](const glm::vec2& n) { return n != sample.front(); };
  if (std::none_of(sample.begin(), sample.end(), differs)) return 0;
  if (is_of_levels(sample, 255)) return k_step_of_8_bits;
  return is_of_levels(sample, 65535) ? k_step_of_16_bits : 0;
}

bool is_flat_in_pieces(const NormalMap& map, std::span<const glm::dvec2> positions) {
  constexpr double k_least_jump = 3 * k_step_of_8_bits;
  std::size_t pairs = 0;
  std::size_t equal = 0;
  std::size_t jumps = 0;
  const auto look = [&](std::int64_t i, std::int64_t j, std::int64_t across, std::int64_t down) {
    const auto along = [&](std::int64_t k) { return map.texel(i + k * across, j + k * down); };
    ++pairs;
    const glm::vec2 here = along(0);
    const glm::vec2 next = along(1);
    if (here == next) {
      ++equal;
      return;
    }
    const double jump = std::max(std::abs(next.x - here.x), std::abs(next.y - here.y));
    jumps += jump > k_least_jump && along(-1) == here && next == along(2) ? 1 : 0;
  };
  for (const glm::dvec2& u : positions) {
    const auto i = static_cast<std::int64_t>(std::floor(u.x));
    const auto j = static_cast<std::int64_t>(std::floor(u.y));
    look(i, j, 1, 0);
    look(i, j, 0, 1);
  }
  return jumps > 0 && 2 * equal >= pairs && 2 * jumps >= pairs - equal;
}

}  // namespace glint
