#pragma once
// A slow, plain twin of the exact kernel's innermost integral, for tests only: halve the edges until they are short,
// then a product Gauss rule. It shares no code with core.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace glint::test {

/// Gauss-Legendre on [0, 1]: the roots of P_n by bisection between sign changes.
struct SlowRule {
  std::vector<long double> nodes;
  std::vector<long double> weights;
};

inline long double legendre(int n, long double x) {
  long double before = 1;
  long double value = x;
  for (int k = 2; k <= n; ++k) {
    const long double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
    before = value;
    value = next;
  }
  return n == 0 ? 1 : value;
}

inline SlowRule make_slow_rule(int n) {
  SlowRule rule;
  constexpr int k_steps = 2000;
  for (int step = 0; step < k_steps; ++step) {
    // The grid is shifted off zero, which is a root of every odd rule.
    long double lo = -1 + 2 * (step + 0.3L) / (k_steps + 0.1L);
    long double hi = -1 + 2 * (step + 1.3L) / (k_steps + 0.1L);
    if (step == 0) lo = -1;
    if (legendre(n, lo) * legendre(n, hi) > 0) continue;
    for (int halving = 0; halving < 80; ++halving) {
      const long double middle = (lo + hi) / 2;
      (legendre(n, lo) * legendre(n, middle) > 0 ? lo : hi) = middle;
    }
    const long double x = (lo + hi) / 2;
    const long double slope = n * (x * legendre(n, x) - legendre(n - 1, x)) / (x * x - 1);
    rule.nodes.push_back((x + 1) / 2);
    rule.weights.push_back(1 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

template <class Real>
struct SlowNodes {
  std::vector<Real> nodes;
  std::vector<Real> weights;
};

template <class Real>
const SlowNodes<Real>& slow_rule(int n) {
  static const std::vector<SlowNodes<Real>> k_rules = [] {
    std::vector<SlowNodes<Real>> rules(13);
    for (int points = 1; points < 13; ++points) {
      const SlowRule rule = make_slow_rule(points);
      auto& out = rules[static_cast<std::size_t>(points)];
      for (const long double node : rule.nodes) out.nodes.push_back(static_cast<Real>(node));
      for (const long double weight : rule.weights) out.weights.push_back(static_cast<Real>(weight));
    }
    return rules;
  }();
  return k_rules[static_cast<std::size_t>(n)];
}

/// One vertex of a triangle: where it is in whitened space (any number of dimensions up to four, the rest zero), and
/// its simplex coordinates.
template <class Real>
struct SlowVertex {
  std::array<Real, 4> q{};
  std::array<Real, 2> x{};
};
template <class Real>
using SlowTriangle = std::array<SlowVertex<Real>, 3>;

template <class Real>
Real slow_distance(const std::array<Real, 4>& a, const std::array<Real, 4>& b) {
  Real sum = 0;
  for (std::size_t k = 0; k < 4; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum);
}

// Points per direction for a triangle with whitened edges up to `edge`, nowhere farther than `far` from the origin
// (or where what is farther does not count); 0: split it. By the error of Gauss's rule on exp(-g x): (n!)^4 g^2n / ((2n
// + 1) (2n)!^3) < 1e-11.
template <class Real>
int slow_points(Real edge, Real far) {
  const Real gradient = edge * far;
  if (edge <= Real(0.1) && gradient <= Real(0.1)) return 3;
  if (edge <= Real(0.25) && gradient <= Real(0.5)) return 4;
  if (edge <= Real(0.8) && gradient <= 2) return 6;
  if (edge <= Real(1.2) && gradient <= 5) return 8;
  return edge <= Real(1.2) && gradient <= 8 ? 12 : 0;
}

/// The integral over the triangle, in simplex coordinates, of weight(x) exp(-|q|^2 / 2). What lies beyond `cut` is left
/// out, and what lies beyond `relevant` need not be accurate. A weight that is not constant needs its own least number
/// of points per direction.
template <class Real, class Weight>
Real slow_integral(const SlowTriangle<Real>& t, Real cut, Real relevant, int least_points, const Weight& weight) {
  std::array<Real, 4> centroid{};
  for (const auto& vertex : t) {
    for (std::size_t k = 0; k < 4; ++k) centroid[k] += vertex.q[k] / 3;
  }
  Real edge = 0;
  Real far = 0;
  Real radius = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    edge = std::max(edge, slow_distance(t[k].q, t[(k + 1) % 3].q));
    far = std::max(far, slow_distance(t[k].q, {}));
    radius = std::max(radius, slow_distance(t[k].q, centroid));
  }
  if (slow_distance(centroid, {}) - radius > cut) return 0;
  const int points = slow_points(edge, std::min(far, relevant));
  if (points == 0) {
    SlowTriangle<Real> middle;  // middle[k] halves the edge opposite vertex k
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& a = t[(k + 1) % 3];
      const auto& b = t[(k + 2) % 3];
      for (std::size_t m = 0; m < 4; ++m) middle[k].q[m] = (a.q[m] + b.q[m]) / 2;
      for (std::size_t m = 0; m < 2; ++m) middle[k].x[m] = (a.x[m] + b.x[m]) / 2;
    }
    return slow_integral<Real>({t[0], middle[2], middle[1]}, cut, relevant, least_points, weight) +
           slow_integral<Real>({middle[2], t[1], middle[0]}, cut, relevant, least_points, weight) +
           slow_integral<Real>({middle[1], middle[0], t[2]}, cut, relevant, least_points, weight) +
           slow_integral<Real>(middle, cut, relevant, least_points, weight);
  }
  const auto& rule = slow_rule<Real>(std::max(points, least_points));
  Real sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const Real a = rule.nodes[i];
    Real line = 0;
    for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
      const Real b = rule.nodes[j];
      Real squared = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const Real q = t[0].q[k] + a * (t[1].q[k] - t[0].q[k] + b * (t[2].q[k] - t[1].q[k]));
        squared += q * q;
      }
      const std::array<Real, 2> x = {t[0].x[0] + a * (t[1].x[0] - t[0].x[0] + b * (t[2].x[0] - t[1].x[0])),
                                     t[0].x[1] + a * (t[1].x[1] - t[0].x[1] + b * (t[2].x[1] - t[1].x[1]))};
      line += rule.weights[j] * weight(x) * std::exp(-squared / 2);
    }
    sum += rule.weights[i] * a * line;
  }
  const Real twice_area =
      std::abs((t[1].x[0] - t[0].x[0]) * (t[2].x[1] - t[0].x[1]) - (t[1].x[1] - t[0].x[1]) * (t[2].x[0] - t[0].x[0]));
  return twice_area * sum;
}

}  // namespace glint::test
