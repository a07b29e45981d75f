#include "core/pndf/mixture_sampler.h"

#include <array>
#include <cmath>
#include <numbers>

#include "core/surface/catmull_rom.h"

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
  if (frame.piecewise_constant) {
    return {glm::dvec2(frame.map->texel(static_cast<std::int64_t>(std::floor(seed.x)),
                                        static_cast<std::int64_t>(std::floor(seed.y))))};
  }
  const double i = std::floor(seed.x - 0.5);
  const double j = std::floor(seed.y - 0.5);
  const std::array<std::array<CubicWeights, 3>, 2> w{
      {{catmull_rom(seed.x - 0.5 - i), catmull_rom_derivative(seed.x - 0.5 - i),
        catmull_rom_second_difference(seed.x - 0.5 - i)},
       {catmull_rom(seed.y - 0.5 - j), catmull_rom_derivative(seed.y - 0.5 - j),
        catmull_rom_second_difference(seed.y - 0.5 - j)}}};
  const double half = 0.5 * frame.lattice.deviation * frame.lattice.deviation;
  const double correction = frame.elements == MixtureElements::corrected ? half : 0;
  const double sheared = frame.elements == MixtureElements::flat ? 0 : 1;
  SeedNormal out;
  for (std::size_t b = 0; b < 4; ++b) {
    for (std::size_t a = 0; a < 4; ++a) {
      const glm::dvec2 n(frame.map->texel(static_cast<std::int64_t>(i) - 1 + static_cast<std::int64_t>(a),
                                          static_cast<std::int64_t>(j) - 1 + static_cast<std::int64_t>(b)));
      const double bend = w[0][2][a] * w[1][0][b] + w[0][0][a] * w[1][2][b];
      out.normal += (w[0][0][a] * w[1][0][b] + correction * bend) * n;
      out.du += sheared * w[0][1][a] * w[1][0][b] * n;
      out.dv += sheared * w[0][0][a] * w[1][1][b] * n;
    }
  }
  return out;
}

}  // namespace

glm::dvec2 sample_mixture(const MixtureFrame& frame, RandomStream& random) {
  const MixtureLattice& lattice = frame.lattice;
  // Sigma_p = V - sigma_h^2 I.
  const double squared = lattice.deviation * lattice.deviation;
  const CholeskyFactor footprint = cholesky({frame.widened.xx - squared, frame.widened.xy, frame.widened.yy - squared});
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
