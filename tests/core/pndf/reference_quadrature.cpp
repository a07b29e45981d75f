#include "tests/core/pndf/reference_quadrature.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/core/math/slow_simplex.h"

namespace glint::test {
namespace {

constexpr double k_cut = 7.5;       // exp(-28)
constexpr double k_relevant = 2.5;  // beyond it eight digits are enough

// Lower triangular whitening, unlike core's: x' = x / a, y' = (y - x b) / c.
std::array<long double, 3> slow_whitening(const SymmetricMatrix2& c) {
  const long double a = std::sqrt(static_cast<long double>(c.xx));
  const long double b = c.xy / static_cast<long double>(c.xx);
  return {1 / a, b, 1 / std::sqrt(static_cast<long double>(c.yy) - c.xy * b)};
}

long wrapped_index(long k, long size, Wrap wrap) {
  if (wrap == Wrap::clamp) return std::min(std::max(k, 0L), size - 1);
  while (k < 0) k += size;
  while (k >= size) k -= size;
  return k;
}

glm::dvec2 texel_at(const NormalMap& map, long i, long j) {
  return glm::dvec2(map.texel(wrapped_index(i, map.width(), map.wrap()), wrapped_index(j, map.height(), map.wrap())));
}

glm::dvec2 cubic(const std::array<glm::dvec2, 4>& p, double x) {
  return 0.5 * (2.0 * p[1] + (p[2] - p[0]) * x + (2.0 * p[0] - 5.0 * p[1] + 4.0 * p[2] - p[3]) * x * x +
                (3.0 * p[1] - p[0] - 3.0 * p[2] + p[3]) * x * x * x);
}

// The normal in the cell right of and below the centre of texel (i, j).
glm::dvec2 bicubic_normal(const NormalMap& map, long i, long j, double x, double y) {
  std::array<glm::dvec2, 4> lines;
  for (long row = 0; row < 4; ++row) {
    std::array<glm::dvec2, 4> line;
    for (long column = 0; column < 4; ++column) {
      line[static_cast<std::size_t>(column)] = texel_at(map, i + column - 1, j + row - 1);
    }
    lines[static_cast<std::size_t>(row)] = cubic(line, x);
  }
  return cubic(lines, y);
}

glm::dvec2 vertex_normal(const Surface& surface, long i, long j, double x, double y) {
  const NormalMap& map = surface.map();
  switch (surface.interpolation()) {
    case Interpolation::constant:
      return texel_at(map, i, j);
    case Interpolation::linear:
      return texel_at(map, i + (x > 0.5 ? 1 : 0), j + (y > 0.5 ? 1 : 0));
    case Interpolation::smooth:
      break;
  }
  return bicubic_normal(map, i, j, x, y);
}

}  // namespace

double slow_normal_density(glm::dvec2 d, const SymmetricMatrix2& covariance) {
  const auto w = slow_whitening(covariance);
  const long double x = d.x * w[0];
  const long double y = (d.y - d.x * w[1]) * w[2];
  return static_cast<double>(w[0] * w[2] / (2 * std::numbers::pi_v<long double>)*std::exp(-(x * x + y * y) / 2));
}

SlowPndf::SlowPndf(const Surface& surface, int subdivision, const Footprint& footprint, glm::dvec2 roughness)
    : roughness_(roughness), whitening_(slow_whitening(footprint.covariance)) {
  const double reach_x = k_cut * std::sqrt(footprint.covariance.xx) + 2;
  const double reach_y = k_cut * std::sqrt(footprint.covariance.yy) + 2;
  const int parts = surface.interpolation() == Interpolation::smooth ? subdivision : 1;
  for (long j = std::lround(footprint.center.y - reach_y); j <= std::lround(footprint.center.y + reach_y); ++j) {
    for (long i = std::lround(footprint.center.x - reach_x); i <= std::lround(footprint.center.x + reach_x); ++i) {
      add_cell(surface, i, j, parts, footprint);
    }
  }
}

void SlowPndf::add_cell(const Surface& surface, long i, long j, int subdivision, const Footprint& footprint) {
  const double border = surface.interpolation() == Interpolation::constant ? 0.0 : 0.5;
  const double h = 1.0 / subdivision;
  const double x0 = static_cast<double>(i) + border - footprint.center.x;
  const double y0 = static_cast<double>(j) + border - footprint.center.y;
  const auto whitened = [&](double x, double y) {
    return glm::dvec2((x0 + x) * whitening_[0], ((y0 + y) - (x0 + x) * whitening_[1]) * whitening_[2]);
  };
  const auto beyond = [&](double x, double y, double size) {  // bound by the bounding box of the whitened square
    const glm::dvec2 a = whitened(x, y);
    const glm::dvec2 b = whitened(x + size, y + size);
    const glm::dvec2 c = whitened(x + size, y);
    const glm::dvec2 middle = 0.5 * (a + b);
    const double radius = std::max(std::hypot(a.x - b.x, a.y - b.y) / 2, std::hypot(c.x - middle.x, c.y - middle.y));
    return std::hypot(middle.x, middle.y) - radius > k_cut;
  };
  if (beyond(0, 0, 1)) return;
  std::vector<glm::dvec2> normals;
  for (int b = 0; b <= subdivision; ++b) {
    for (int a = 0; a <= subdivision; ++a) normals.push_back(vertex_normal(surface, i, j, a * h, b * h));
  }
  const auto normal = [&](int a, int b) { return normals[static_cast<std::size_t>(b * (subdivision + 1) + a)]; };
  for (int b = 0; b < subdivision; ++b) {
    for (int a = 0; a < subdivision; ++a) {
      if (beyond(a * h, b * h, h)) continue;
      const glm::dvec2 right = whitened((a + 1) * h, b * h);
      const glm::dvec2 below = whitened(a * h, (b + 1) * h);
      triangles_.push_back(
          {{whitened(a * h, b * h), right, below}, {normal(a, b), normal(a + 1, b), normal(a, b + 1)}, h * h});
      triangles_.push_back({{whitened((a + 1) * h, (b + 1) * h), below, right},
                            {normal(a + 1, b + 1), normal(a, b + 1), normal(a + 1, b)},
                            h * h});
    }
  }
}

double SlowPndf::density(glm::dvec2 s) const {
  const auto one = [](const std::array<double, 2>&) { return 1.0; };
  double sum = 0;
  for (const Triangle& triangle : triangles_) {
    SlowTriangle<double> t;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec2 change = (triangle.normals[k] - s) / roughness_;
      t[k].q = {triangle.white[k].x, triangle.white[k].y, change.x, change.y};
    }
    t[1].x = {1, 0};
    t[2].x = {0, 1};
    sum += triangle.area * slow_integral<double>(t, k_cut, k_relevant, 1, one);
  }
  const double pi2 = 4 * std::numbers::pi * std::numbers::pi;
  return sum * static_cast<double>(whitening_[0] * whitening_[2]) / (pi2 * roughness_.x * roughness_.y);
}

glm::dvec2 SlowPndf::draw_normal(RandomStream& random) const {
  std::array<double, 2> deviates{};
  random.fill_normal(deviates);
  for (const Triangle& triangle : triangles_) {
    const glm::dvec2 a = triangle.white[1] - triangle.white[0];
    const glm::dvec2 b = triangle.white[2] - triangle.white[0];
    const glm::dvec2 d = glm::dvec2(deviates[0], deviates[1]) - triangle.white[0];
    const double det = a.x * b.y - a.y * b.x;
    const double x = (d.x * b.y - d.y * b.x) / det;
    const double y = (a.x * d.y - a.y * d.x) / det;
    if (x < 0 || y < 0 || x + y > 1) continue;
    const auto& n = triangle.normals;
    return n[0] + x * (n[1] - n[0]) + y * (n[2] - n[0]);
  }
  return {0, 0};
}

NormalMoments SlowPndf::moments() const {
  std::array<double, 6> sums{};
  for (const Triangle& triangle : triangles_) {
    SlowTriangle<double> t;
    for (std::size_t k = 0; k < 3; ++k) t[k].q = {triangle.white[k].x, triangle.white[k].y, 0, 0};
    t[1].x = {1, 0};
    t[2].x = {0, 1};
    const auto& n = triangle.normals;
    for (std::size_t power = 0; power < sums.size(); ++power) {
      sums[power] += triangle.area * slow_integral<double>(t, k_cut, k_cut, 6, [&](const std::array<double, 2>& x) {
                       const glm::dvec2 m = n[0] + x[0] * (n[1] - n[0]) + x[1] * (n[2] - n[0]);
                       const std::array<double, 6> values = {1, m.x, m.y, m.x * m.x, m.x * m.y, m.y * m.y};
                       return values[power];
                     });
    }
  }
  for (double& sum : sums) sum *= static_cast<double>(whitening_[0] * whitening_[2]) / (2 * std::numbers::pi);
  const glm::dvec2 mean{sums[1], sums[2]};
  return {sums[0], mean, {sums[3] - mean.x * mean.x, sums[4] - mean.x * mean.y, sums[5] - mean.y * mean.y}};
}

SlowPndf::RootSum SlowPndf::roots(glm::dvec2 s) const {
  RootSum result{0, 1};
  for (const Triangle& triangle : triangles_) {
    const auto& n = triangle.normals;
    const glm::dvec2 a = n[1] - n[0];
    const glm::dvec2 b = n[2] - n[0];
    const glm::dvec2 d = s - n[0];
    const double det = a.x * b.y - a.y * b.x;
    const double x = (d.x * b.y - d.y * b.x) / det;
    const double y = (a.x * d.y - a.y * d.x) / det;
    const double least = std::min({x, y, 1 - x - y});
    result.margin = std::min(result.margin, std::abs(least));
    if (least < 0) continue;
    const glm::dvec2 w =
        triangle.white[0] + x * (triangle.white[1] - triangle.white[0]) + y * (triangle.white[2] - triangle.white[0]);
    const double footprint = static_cast<double>(whitening_[0] * whitening_[2]) / (2 * std::numbers::pi) *
                             std::exp(-0.5 * (w.x * w.x + w.y * w.y));
    result.density += footprint * triangle.area / std::abs(det);
  }
  return result;
}

double slow_smooth_density(const Surface& surface, const Footprint& footprint, double roughness, glm::dvec2 s) {
  constexpr double k_reach = 8;
  constexpr int k_parts = 8;  // of a texel, per axis
  const auto& rule = slow_rule<double>(4);
  const SymmetricMatrix2& c = footprint.covariance;
  const auto reach_x = static_cast<long>(k_reach * std::sqrt(c.xx) + 2);
  const auto reach_y = static_cast<long>(k_reach * std::sqrt(c.yy) + 2);
  const auto ci = static_cast<long>(std::floor(footprint.center.x - 0.5));
  const auto cj = static_cast<long>(std::floor(footprint.center.y - 0.5));
  double sum = 0;
  for (long j = cj - reach_y; j <= cj + reach_y; ++j) {
    for (int b = 0; b < k_parts; ++b) {
      for (std::size_t q = 0; q < rule.nodes.size(); ++q) {
        const double y = (b + rule.nodes[q]) / k_parts;
        for (long i = ci - reach_x; i <= ci + reach_x; ++i) {
          std::array<glm::dvec2, 4> columns;  // of the cell at this y
          for (long column = 0; column < 4; ++column) {
            std::array<glm::dvec2, 4> line;
            for (long row = 0; row < 4; ++row) {
              line[static_cast<std::size_t>(row)] = texel_at(surface.map(), i + column - 1, j + row - 1);
            }
            columns[static_cast<std::size_t>(column)] = cubic(line, y);
          }
          for (int a = 0; a < k_parts; ++a) {
            for (std::size_t p = 0; p < rule.nodes.size(); ++p) {
              const double x = (a + rule.nodes[p]) / k_parts;
              const glm::dvec2 d = (cubic(columns, x) - s) / roughness;
              const glm::dvec2 u{static_cast<double>(i) + 0.5 + x, static_cast<double>(j) + 0.5 + y};
              const double exponent = -0.5 * (d.x * d.x + d.y * d.y);
              if (exponent < -40) continue;
              sum +=
                  rule.weights[q] * rule.weights[p] * std::exp(exponent) * slow_normal_density(u - footprint.center, c);
            }
          }
        }
      }
    }
  }
  return sum / (k_parts * k_parts * 2 * std::numbers::pi * roughness * roughness);
}

}  // namespace glint::test
