#include "core/pndf/lean_points.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/math/quadrature.h"
#include "core/pndf/lean_footprint.h"

namespace glint {
namespace {

constexpr double k_step_deviations = 0.5;
constexpr double k_step_texels = 0.375;
constexpr int k_panel_points = 4;  // of a Gauss rule, on at most one deviation

// The footprint as N(p) N(q | p), with p the coordinate in which it is longer, so that q drifts at most as fast as p.
struct SplitFootprint {
  bool along_v;  // p is v
  double p_center;
  double q_center;
  double p_deviation;
  double q_deviation;  // at a given p
  double drift;        // of q's mean, dq / dp

  explicit SplitFootprint(const Footprint& footprint)
      : along_v(footprint.covariance.yy > footprint.covariance.xx),
        p_center(along_v ? footprint.center.y : footprint.center.x),
        q_center(along_v ? footprint.center.x : footprint.center.y) {
    const SymmetricMatrix2& c = footprint.covariance;
    const double pp = along_v ? c.yy : c.xx;
    p_deviation = std::sqrt(pp);
    q_deviation = std::sqrt(determinant(c) / pp);
    drift = c.xy / pp;
  }

  [[nodiscard]] glm::dvec2 position(double p, double q) const { return along_v ? glm::dvec2(q, p) : glm::dvec2(p, q); }
};

// Points k step, |k| <= reach, of a standard normal deviate.
struct DeviateLattice {
  double step;
  std::int64_t reach;

  explicit DeviateLattice(double deviation)
      : step(std::min(k_step_deviations, k_step_texels / deviation)),
        reach(static_cast<std::int64_t>(std::ceil(k_lean_cut / step))) {}
  DeviateLattice(double wished, std::int64_t points) : step(wished), reach(points) {}

  [[nodiscard]] double points() const { return 2 * static_cast<double>(reach) + 1; }
  [[nodiscard]] double at(std::int64_t k) const { return static_cast<double>(k) * step; }
};

double bell(double deviate) {
  return std::exp(-0.5 * deviate * deviate);
}

DeviateLattice bounded(const DeviateLattice& wished, double most_points) {
  if (wished.points() <= most_points) return wished;
  const auto reach = static_cast<std::int64_t>(0.5 * most_points);
  return {k_lean_cut / static_cast<double>(reach), reach};
}

// Adds the texels of one line p = const, whose flakes are cut where q is a whole number.
void add_flake_line(const Surface& surface, const SplitFootprint& split, double p, double weight, MomentSum& sum) {
  const double mean = split.q_center + split.drift * (p - split.p_center);
  const double reach = k_lean_cut * split.q_deviation;
  const double last = std::floor(mean + reach);
  double before = 0;
  for (double q = std::floor(mean - reach); q <= last; ++q) {
    const double up_to = q < last ? normal_cdf((q + 1 - mean) / split.q_deviation) : 1;
    const glm::dvec2 normal = surface.normal(split.position(p, q + 0.5));
    sum.add(weight * (up_to - before), {texel_slope(normal).slope, {0, 0, 0}});
    before = up_to;
  }
}

}  // namespace

SlopeMoments point_moments(const Surface& surface, const Footprint& footprint) {
  const SplitFootprint split(footprint);
  const DeviateLattice q_lattice(split.q_deviation);
  const DeviateLattice p_lattice = bounded(DeviateLattice(split.p_deviation), k_most_lean_points / q_lattice.points());
  std::vector<double> q_weights;
  for (std::int64_t k = -q_lattice.reach; k <= q_lattice.reach; ++k) q_weights.push_back(bell(q_lattice.at(k)));
  MomentSum sum;
  for (std::int64_t l = -p_lattice.reach; l <= p_lattice.reach; ++l) {
    const double p_offset = split.p_deviation * p_lattice.at(l);
    const double p_weight = bell(p_lattice.at(l));
    for (std::int64_t k = -q_lattice.reach; k <= q_lattice.reach; ++k) {
      const double q_offset = split.drift * p_offset + split.q_deviation * q_lattice.at(k);
      const glm::dvec2 normal = surface.normal(split.position(split.p_center + p_offset, split.q_center + q_offset));
      sum.add(p_weight * q_weights[static_cast<std::size_t>(k + q_lattice.reach)],
              {texel_slope(normal).slope, {0, 0, 0}});
    }
  }
  return sum.moments();
}

SlopeMoments flake_moments(const Surface& surface, const Footprint& footprint) {
  const SplitFootprint split(footprint);
  MomentSum sum;
  const double reach = k_lean_cut * split.p_deviation;
  const double flakes_across = 2 * k_lean_cut * split.q_deviation + 2;
  if (2 * reach * flakes_across * k_panel_points > k_most_lean_points) {
    const DeviateLattice lattice =
        bounded(DeviateLattice(split.p_deviation), std::max(k_most_lean_points / flakes_across, 3.0));
    for (std::int64_t l = -lattice.reach; l <= lattice.reach; ++l) {
      const double p = split.p_center + split.p_deviation * lattice.at(l);
      add_flake_line(surface, split, p, bell(lattice.at(l)), sum);
    }
    return sum.moments();
  }
  // Panels end where flakes do, and are short where the line's mass moves on from flake to flake within one.
  const double drift_over = split.q_deviation / std::max(std::abs(split.drift), 1e-9);
  const double longest = std::min(split.p_deviation, std::max(drift_over, split.p_deviation / 16));
  const GaussRule rule = gauss_legendre(k_panel_points);
  double from = split.p_center - reach;
  while (from < split.p_center + reach) {
    const double to = std::min({std::floor(from) + 1, from + longest, split.p_center + reach});
    if (!(to > from)) break;  // so narrow that doubles do not tell its points apart
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
      const double p = from + rule.nodes[k] * (to - from);
      const double weight = rule.weights[k] * (to - from) * bell((p - split.p_center) / split.p_deviation);
      add_flake_line(surface, split, p, weight, sum);
    }
    from = to;
  }
  if (!(sum.weight() > 0)) add_flake_line(surface, split, split.p_center, 1, sum);
  return sum.moments();
}

}  // namespace glint
