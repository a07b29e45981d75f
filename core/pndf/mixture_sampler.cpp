#include "core/pndf/mixture_sampler.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/pndf/footprint_window.h"
#include "core/pndf/mixture_cells.h"

namespace glint {
namespace {

constexpr double k_kernel_cut = 6.5;  // deviations of a seed's Gaussian: 1e-9 of its peak beyond

// The seeds along one axis whose Gaussians matter at u, and the sum of those relative to one seed's peak.
class SeedChoice {
 public:
  SeedChoice(double u, double step, double deviation) : step_(step), deviation_(deviation), u_(u) {
    first_ = static_cast<std::int64_t>(std::ceil((u - k_kernel_cut * deviation) / step - 0.5));
    last_ = static_cast<std::int64_t>(std::floor((u + k_kernel_cut * deviation) / step - 0.5));
    for (std::int64_t k = first_; k <= last_; ++k) sum_ += weight(k);
  }

  [[nodiscard]] double sum() const { return sum_; }

  // A seed drawn with its share; `xi` is uniform in [0, 1).
  [[nodiscard]] std::int64_t draw(double xi) const {
    double left = xi * sum_;
    for (std::int64_t k = first_; k < last_; ++k) {
      left -= weight(k);
      if (left < 0) return k;
    }
    return last_;
  }

 private:
  [[nodiscard]] double weight(std::int64_t k) const {
    const double x = (u_ - (static_cast<double>(k) + 0.5) * step_) / deviation_;
    return std::exp(-0.5 * x * x);
  }

  double step_;
  double deviation_;
  double u_;
  std::int64_t first_;
  std::int64_t last_;
  double sum_ = 0;
};

// The largest sum of the seeds' Gaussians, at a seed.
double largest_sum(double step, double deviation) {
  return SeedChoice(0.5 * step, step, deviation).sum();
}

struct SeedNormal {
  glm::dvec2 normal{0, 0};
  glm::dvec2 du{0, 0};
  glm::dvec2 dv{0, 0};
};

SeedNormal seed_normal(const MixtureFrame& frame, glm::dvec2 seed) {
  const AxisStencil u(seed.x, frame.piecewise_constant);
  const AxisStencil v(seed.y, frame.piecewise_constant);
  const double half = 0.5 * frame.lattice.deviation * frame.lattice.deviation;
  const double correction = frame.elements == MixtureElements::corrected ? half : 0;
  const double sheared = frame.elements == MixtureElements::flat ? 0 : 1;
  SeedNormal out;
  const std::size_t taps = frame.piecewise_constant ? 1 : 4;
  for (std::size_t b = 0; b < taps; ++b) {
    for (std::size_t a = 0; a < taps; ++a) {
      const glm::dvec2 n(
          frame.map->texel(u.first + static_cast<std::int64_t>(a), v.first + static_cast<std::int64_t>(b)));
      const double bend = u.bend[a] * v.value[b] + u.value[a] * v.bend[b];
      out.normal += (u.value[a] * v.value[b] + correction * bend) * n;
      out.du += sheared * u.slope[a] * v.value[b] * n;
      out.dv += sheared * u.value[a] * v.slope[b] * n;
    }
  }
  return out;
}

}  // namespace

// By Poisson's formula the sum over frequencies f = (k / step.x, l / step.y) of exp(-2 pi^2 f^T V f) cos(2 pi f.(u_p -
// u_0)), of which few are left: V is at least sigma_h^2 I.
double sum_of_weights(const MixtureFrame& frame) {
  constexpr double k_least_exponent = 36;  // 2e-16 is left out
  constexpr double k_turn = 2 * std::numbers::pi;
  const glm::dvec2 step = frame.lattice.step;
  const double whole = determinant(frame.widened);
  // V of offsets in steps, inverted: within the cut are those frequencies that count.
  const FootprintWindow frequencies({step.x * step.x * frame.widened.yy / whole,
                                     -step.x * step.y * frame.widened.xy / whole,
                                     step.y * step.y * frame.widened.xx / whole});
  const double cut = std::sqrt(2 * k_least_exponent) / k_turn;
  const glm::dvec2 phase = k_turn * (frame.center / step - 0.5);
  const Whitening& white = frequencies.whitening();
  double sum = 0;
  const double last = std::floor(frequencies.reach_y(cut));
  for (double l = -last; l <= last; ++l) {
    const std::optional<Interval> row = frequencies.columns({l, l}, cut);
    if (!row) continue;
    for (double k = std::ceil(row->lo); k <= row->hi; ++k) {
      const glm::dvec2 f = white.apply({k, l});
      sum += std::exp(-0.5 * k_turn * k_turn * (f.x * f.x + f.y * f.y)) * std::cos(k * phase.x + l * phase.y);
    }
  }
  return sum;
}

glm::dvec2 sample_mixture(const MixtureFrame& frame, RandomStream& random) {
  const MixtureLattice& lattice = frame.lattice;
  const CholeskyFactor footprint = cholesky(frame.footprint);
  const double most = largest_sum(lattice.step.x, lattice.deviation) * largest_sum(lattice.step.y, lattice.deviation);
  while (true) {
    std::array<double, 4> xi{};
    random.fill_normal(xi);
    const glm::dvec2 u = frame.center + footprint.apply({xi[0], xi[1]});
    const SeedChoice column(u.x, lattice.step.x, lattice.deviation);
    const SeedChoice row(u.y, lattice.step.y, lattice.deviation);
    if (random.next_uniform() * most > column.sum() * row.sum()) continue;
    const double k = static_cast<double>(column.draw(random.next_uniform()));
    const double l = static_cast<double>(row.draw(random.next_uniform()));
    const glm::dvec2 seed{(k + 0.5) * lattice.step.x, (l + 0.5) * lattice.step.y};
    const SeedNormal n = seed_normal(frame, seed);
    return n.normal + (u.x - seed.x) * n.du + (u.y - seed.y) * n.dv + frame.roughness * glm::dvec2(xi[2], xi[3]);
  }
}

}  // namespace glint
