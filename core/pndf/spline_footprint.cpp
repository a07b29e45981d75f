#include "core/pndf/spline_footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "core/math/gaussian.h"
#include "core/pndf/footprint_window.h"

namespace glint {
namespace {

constexpr double k_cut = 4;         // deviations of the weights
constexpr int k_points = 4;         // of the quadrature, a pitch
constexpr double k_uniform = 0.81;  // squared deviations over the squared side: see MixtureFrame::uniform
constexpr double k_uniform_rest = 1e-6;

double square(double x) {
  return x * x;
}

// The variance of a window is H^2 / 3, which the weights leave out.
SymmetricMatrix2 of_weights(const SplineLattice& lattice, const SymmetricMatrix2& covariance) {
  return {covariance.xx - square(lattice.pitch.x) / 3, covariance.xy, covariance.yy - square(lattice.pitch.y) / 3};
}

// Weights on the nodes of the rectangle that holds the ellipse of k_cut deviations, 0 outside the ellipse.
struct WeightGrid {
  std::int64_t first_i, first_j;
  std::size_t columns, rows;
  std::vector<double> weights;  // by rows; they sum to 1

  [[nodiscard]] double at(std::int64_t i, std::int64_t j) const {
    if (i < first_i || j < first_j) return 0;
    const auto column = static_cast<std::size_t>(i - first_i);
    const auto row = static_cast<std::size_t>(j - first_j);
    return column < columns && row < rows ? weights[row * columns + column] : 0;
  }
};

WeightGrid weight_grid(const SplineLattice& lattice, const Footprint& footprint) {
  const SymmetricMatrix2 covariance = of_weights(lattice, footprint.covariance);
  const Whitening whiten = whitening(covariance);
  const glm::dvec2 reach{k_cut * std::sqrt(covariance.xx), k_cut * std::sqrt(covariance.yy)};
  const glm::dvec2 lo = (footprint.center - reach) / lattice.pitch;
  const glm::dvec2 hi = (footprint.center + reach) / lattice.pitch;
  WeightGrid grid{static_cast<std::int64_t>(std::ceil(lo.x)), static_cast<std::int64_t>(std::ceil(lo.y)), 0, 0, {}};
  grid.columns = static_cast<std::size_t>(static_cast<std::int64_t>(std::floor(hi.x)) - grid.first_i + 1);
  grid.rows = static_cast<std::size_t>(static_cast<std::int64_t>(std::floor(hi.y)) - grid.first_j + 1);
  grid.weights.resize(grid.columns * grid.rows);
  double sum = 0;
  for (std::size_t row = 0; row < grid.rows; ++row) {
    for (std::size_t column = 0; column < grid.columns; ++column) {
      const glm::dvec2 node{static_cast<double>(grid.first_i + static_cast<std::int64_t>(column)) * lattice.pitch.x,
                            static_cast<double>(grid.first_j + static_cast<std::int64_t>(row)) * lattice.pitch.y};
      const glm::dvec2 w = whiten.apply(node - footprint.center);
      const double squared = w.x * w.x + w.y * w.y;
      if (squared > k_cut * k_cut) continue;
      sum += grid.weights[row * grid.columns + column] = std::exp(-0.5 * squared);
    }
  }
  for (double& weight : grid.weights) weight /= sum;
  return grid;
}

// The integral of |G_p - sum of windows|.
double distance(const SplineLattice& lattice, const Footprint& footprint, const WeightGrid& grid) {
  std::array<std::array<double, 4>, k_points> splines{};
  for (int k = 0; k < k_points; ++k) splines[static_cast<std::size_t>(k)] = cubic_b_splines((k + 0.5) / k_points);
  const Whitening whiten = whitening(footprint.covariance);
  const double cell = lattice.pitch.x * lattice.pitch.y;
  const double peak = cell * whiten.determinant() / (2 * std::numbers::pi);
  const auto columns = static_cast<std::int64_t>(grid.columns);
  const auto rows = static_cast<std::int64_t>(grid.rows);
  std::vector<double> combined(grid.columns + 8);  // along v, of nodes first_i - 4 on
  double total = 0;
  double mass = 0;
  // Cells two beyond the outermost nodes' windows; the Gaussian's mass beyond them is added below.
  for (std::int64_t j = -4; j < rows + 3; ++j) {
    for (int b = 0; b < k_points; ++b) {
      const std::array<double, 4>& along_v = splines[static_cast<std::size_t>(b)];
      for (std::int64_t i = -4; i < columns + 4; ++i) {
        double sum = 0;
        for (std::int64_t k = 0; k < 4; ++k) {
          sum += along_v[static_cast<std::size_t>(k)] * grid.at(grid.first_i + i, grid.first_j + j - 1 + k);
        }
        combined[static_cast<std::size_t>(i + 4)] = sum;
      }
      const double v = (static_cast<double>(grid.first_j + j) + (b + 0.5) / k_points) * lattice.pitch.y;
      for (std::int64_t i = -3; i < columns + 2; ++i) {
        for (int a = 0; a < k_points; ++a) {
          const double u = (static_cast<double>(grid.first_i + i) + (a + 0.5) / k_points) * lattice.pitch.x;
          const glm::dvec2 w = whiten.apply(glm::dvec2(u, v) - footprint.center);
          const double gaussian = peak * std::exp(-0.5 * (w.x * w.x + w.y * w.y));
          double sum = 0;
          for (std::int64_t k = 0; k < 4; ++k) {
            sum += splines[static_cast<std::size_t>(a)][static_cast<std::size_t>(k)] *
                   combined[static_cast<std::size_t>(i + 3 + k)];
          }
          total += std::abs(gaussian - sum);
          mass += gaussian;
        }
      }
    }
  }
  constexpr double k_weight = 1.0 / (k_points * k_points);
  return 1.1 * total * k_weight + std::max(0.0, 1 - mass * k_weight);
}

}  // namespace

SplineLattice SplineLattice::for_footprint(const NormalMap& map, const SymmetricMatrix2& covariance) {
  const double widest = std::sqrt(eigenvalues(covariance).y) / k_least_ratio;
  SplineLattice lattice{};
  // Pitches are about 8 texels times powers of sqrt 2.
  lattice.level = static_cast<int>(std::floor(2 * std::log2(widest / 8)));
  const double pitch = 8 * std::exp2(0.5 * lattice.level);
  lattice.periodic = map.wrap() == Wrap::repeat;
  if (!lattice.periodic) {
    lattice.pitch = {pitch, pitch};
    lattice.count = {0, 0};
    return lattice;
  }
  const auto nodes = [&](int side) { return std::max(4, static_cast<int>(std::ceil(side / pitch))); };
  lattice.count = {nodes(map.width()), nodes(map.height())};
  lattice.pitch = {static_cast<double>(map.width()) / lattice.count.x,
                   static_cast<double>(map.height()) / lattice.count.y};
  // Beyond the coarsest of a map all levels are one.
  if (lattice.count == glm::ivec2(4, 4)) lattice.level = std::numeric_limits<int>::max();
  return lattice;
}

std::array<double, 4> cubic_b_splines(double x) {
  const double y = 1 - x;
  return {y * y * y / 6, (4 - 6 * x * x + 3 * x * x * x) / 6, (4 - 6 * y * y + 3 * y * y * y) / 6, x * x * x / 6};
}

double SplineFootprint::node_count(const SplineLattice& lattice, const SymmetricMatrix2& covariance) {
  const double area = std::sqrt(std::max(determinant(of_weights(lattice, covariance)), 0.0));
  return std::numbers::pi * k_cut * k_cut * area / (lattice.pitch.x * lattice.pitch.y);
}

SplineFootprint::SplineFootprint(const SplineLattice& lattice, const NormalMap& map, const Footprint& footprint) {
  const double side = std::max(map.width(), map.height());
  if (lattice.periodic && eigenvalues(footprint.covariance).y >= k_uniform * side * side) {
    const double weight = 1.0 / (static_cast<double>(lattice.count.x) * lattice.count.y);
    for (int j = 0; j < lattice.count.y; ++j) {
      for (int i = 0; i < lattice.count.x; ++i) nodes_.push_back({i, j, weight});
    }
    bound_ = k_uniform_rest;
    return;
  }
  const WeightGrid grid = weight_grid(lattice, footprint);
  bound_ = distance(lattice, footprint, grid);
  std::map<std::pair<std::int64_t, std::int64_t>, double> folded;
  const auto inside = [&](std::int64_t k, int count) {
    if (!lattice.periodic) return k;
    const std::int64_t rest = k % count;
    return rest < 0 ? rest + count : rest;
  };
  for (std::size_t row = 0; row < grid.rows; ++row) {
    for (std::size_t column = 0; column < grid.columns; ++column) {
      const double weight = grid.weights[row * grid.columns + column];
      if (weight == 0) continue;
      folded[{inside(grid.first_j + static_cast<std::int64_t>(row), lattice.count.y),
              inside(grid.first_i + static_cast<std::int64_t>(column), lattice.count.x)}] += weight;
    }
  }
  for (const auto& [node, weight] : folded) nodes_.push_back({node.second, node.first, weight});
}

}  // namespace glint
