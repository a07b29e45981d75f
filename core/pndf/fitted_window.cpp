#include "core/pndf/fitted_window.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/gaussian.h"
#include "core/pndf/cell_visit.h"

namespace glint {
namespace {

constexpr int k_positions = 16384;
constexpr double k_roughness_margin = 4.5;

struct Range {
  double lo;
  double hi;
};

// From the second smallest to the second largest.
Range trimmed_range(std::vector<double>& values) {
  std::nth_element(values.begin(), values.begin() + 1, values.end());
  const double lo = values[1];
  std::nth_element(values.begin(), values.end() - 2, values.end());
  return {lo, values[values.size() - 2]};
}

// The largest step of 1, 2, 5 x 10^n that is at most a fiftieth of `side`: window ends become short numbers.
double round_step(double side) {
  const double power = std::pow(10, std::floor(std::log10(side / 50)));
  const double factor = side / 50 / power;
  return power * (factor >= 5 ? 5 : factor >= 2 ? 2 : 1);
}

}  // namespace

PndfGrid fitted_window(const Surface& surface, const Footprint& footprint, double intrinsic_roughness, int cells) {
  const glm::dvec2 center = reduced_center(surface.map(), footprint.center);
  const CholeskyFactor factor = cholesky(footprint.covariance);
  std::vector<double> s(k_positions);
  std::vector<double> t(k_positions);
  for (int k = 0; k < k_positions; ++k) {
    const glm::dvec2 normal = surface.normal(center + factor.apply(spread_deviate(k, k_positions)));
    s[static_cast<std::size_t>(k)] = normal.x;
    t[static_cast<std::size_t>(k)] = normal.y;
  }
  const Range along_s = trimmed_range(s);
  const Range along_t = trimmed_range(t);
  const double margin = k_roughness_margin * intrinsic_roughness;
  double side = std::max(along_s.hi - along_s.lo, along_t.hi - along_t.lo) + 2 * margin;
  side = std::max(side, 1e-11 * cells);  // cells that a grid allows
  const double step = round_step(std::min(side, 2.0));
  side = std::min(2.0, step * std::ceil(side / step) + step);
  const auto place = [&](Range range) {
    const double lo = step * std::floor((0.5 * (range.lo + range.hi) - 0.5 * side) / step + 0.5);
    return std::clamp(lo, -1.0, 1.0 - side);
  };
  const double s_min = place(along_s);
  const double t_min = place(along_t);
  return {s_min, s_min + side, t_min, t_min + side, cells, cells};
}

}  // namespace glint
