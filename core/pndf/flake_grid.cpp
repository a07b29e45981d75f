#include "core/pndf/flake_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace glint {
namespace {

constexpr double k_half_height = 0.42466090014400953;  // 1 / sqrt(8 ln 2)
constexpr double k_cell_deviations = 2;                // the side of a cell
constexpr double k_least_exponent = 24;                // 4e-11 is left out of Fourier series
constexpr double k_worth_a_look = 0.1;                 // narrower footprints have too many waves
constexpr double k_two_pi = 2 * std::numbers::pi;

struct Place {
  std::int64_t cell;    // within the domain
  std::int64_t period;  // how often the domain lies before it
};

Place place_of(std::int64_t cell, std::int64_t cells) {
  const std::int64_t rest = cell % cells;
  const std::int64_t inside = rest < 0 ? rest + cells : rest;
  return {inside, (cell - inside) / cells};
}

glm::dvec2 inside(glm::dvec2 u, glm::dvec2 domain) {
  const auto along = [](double x, double size) {
    const double reduced = x - size * std::floor(x / size);
    return reduced < size ? reduced : 0;
  };
  return {along(u.x, domain.x), along(u.y, domain.y)};
}

// A flake that was met in several periods has the sum of their weights.
void add_up_periods(std::vector<FlakeWeight>& weights) {
  std::stable_sort(weights.begin(), weights.end(),
                   [](const FlakeWeight& a, const FlakeWeight& b) { return a.flake < b.flake; });
  std::size_t kept = 0;
  for (const FlakeWeight& weight : weights) {
    if (kept > 0 && weights[kept - 1].flake == weight.flake) {
      weights[kept - 1].weight += weight.weight;
    } else {
      weights[kept++] = weight;
    }
  }
  weights.resize(kept);
}

void drop_light_ones(std::vector<FlakeWeight>& weights, double cut) {
  double most = 0;
  for (const FlakeWeight& weight : weights) most = std::max(most, weight.weight);
  const double least = most * std::exp(-0.5 * cut * cut);
  std::erase_if(weights, [&](const FlakeWeight& weight) { return weight.weight <= least; });
}

}  // namespace

FlakeGrid::FlakeGrid(std::vector<Flake> flakes, glm::dvec2 domain)
    : domain_(domain), deviation_(k_half_height * std::sqrt(domain.x * domain.y / static_cast<double>(flakes.size()))) {
  assert(!flakes.empty() && domain.x > 0 && domain.y > 0);
  // No more cells than flakes along a domain that is much longer than wide.
  const double most = static_cast<double>(flakes.size());
  const auto cells_along = [&](double size) {
    return static_cast<int>(std::clamp(std::round(size / (k_cell_deviations * deviation_)), 1.0, most));
  };
  cells_ = {cells_along(domain.x), cells_along(domain.y)};
  cell_ = domain / glm::dvec2(cells_);

  const auto columns = static_cast<std::size_t>(cells_.x);
  const auto cell_of = [&](const Flake& flake) {
    const auto i = std::min(static_cast<std::size_t>(flake.center.x / cell_.x), columns - 1);
    const auto j = std::min(static_cast<std::size_t>(flake.center.y / cell_.y), static_cast<std::size_t>(cells_.y) - 1);
    return j * columns + i;
  };
  begin_.resize(columns * static_cast<std::size_t>(cells_.y) + 1);
  for (Flake& flake : flakes) {
    flake.center = inside(flake.center, domain);
    ++begin_[cell_of(flake) + 1];
  }
  for (std::size_t k = 1; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  flakes_.resize(flakes.size());
  for (const Flake& flake : flakes) flakes_[next[cell_of(flake)]++] = flake;
}

std::size_t FlakeGrid::bytes() const {
  return flakes_.size() * sizeof(Flake) + begin_.size() * sizeof(std::uint32_t);
}

SymmetricMatrix2 FlakeGrid::widened(const SymmetricMatrix2& covariance) const {
  const double squared = deviation_ * deviation_;
  return {covariance.xx + squared, covariance.xy, covariance.yy + squared};
}

double FlakeGrid::share_of_domain(const SymmetricMatrix2& v) const {
  return std::sqrt(determinant(v)) / (domain_.x * domain_.y);
}

// By Poisson's formula the sum over periods is that over frequencies f = (k / width, l / height), of which few are left
// where V is wide. Those of one half plane, without f = 0.
std::vector<FlakeGrid::Wave> FlakeGrid::waves(const SymmetricMatrix2& v) const {
  const double whole = determinant(v);
  const FootprintWindow frequencies({domain_.x * domain_.x * v.yy / whole, -domain_.x * domain_.y * v.xy / whole,
                                     domain_.y * domain_.y * v.xx / whole});
  const double cut = std::sqrt(2 * k_least_exponent) / k_two_pi;
  const Whitening& white = frequencies.whitening();
  std::vector<Wave> found;
  for (double l = 0; l <= frequencies.reach_y(cut); ++l) {
    const std::optional<Interval> row = frequencies.columns({l, l}, cut);
    if (!row) continue;
    for (double k = l > 0 ? std::ceil(row->lo) : 1; k <= row->hi; ++k) {
      const glm::dvec2 f = white.apply({k, l});
      const double amplitude = 2 * std::exp(-0.5 * k_two_pi * k_two_pi * (f.x * f.x + f.y * f.y));
      found.push_back({k_two_pi * glm::dvec2(k, l) / domain_, amplitude});
    }
  }
  return found;
}

bool FlakeGrid::sees_all_alike(const Footprint& footprint) const {
  const SymmetricMatrix2 v = widened(footprint.covariance);
  return share_of_domain(v) > k_worth_a_look && waves(v).empty();
}

template <class See>
void FlakeGrid::visit(const FootprintWindow& window, glm::dvec2 center, double cut, const See& see) const {
  const auto cell_at = [](double x, double side) { return static_cast<std::int64_t>(std::floor(x / side)); };
  const double reach = window.reach_y(cut);
  const Whitening& white = window.whitening();
  for (std::int64_t j = cell_at(center.y - reach, cell_.y); j <= cell_at(center.y + reach, cell_.y); ++j) {
    const double top = static_cast<double>(j) * cell_.y - center.y;
    const std::optional<Interval> columns = window.columns({top, top + cell_.y}, cut);
    if (!columns) continue;
    const Place row = place_of(j, cells_.y);
    const std::int64_t last = cell_at(center.x + columns->hi, cell_.x);
    for (std::int64_t i = cell_at(center.x + columns->lo, cell_.x); i <= last; ++i) {
      const Place column = place_of(i, cells_.x);
      const glm::dvec2 origin =
          domain_ * glm::dvec2(static_cast<double>(column.period), static_cast<double>(row.period)) - center;
      const auto cell = static_cast<std::size_t>(row.cell * cells_.x + column.cell);
      for (std::uint32_t k = begin_[cell]; k < begin_[cell + 1]; ++k) {
        const glm::dvec2 d = white.apply(flakes_[k].center + origin);
        const double squared = d.x * d.x + d.y * d.y;
        if (squared < cut * cut) see(k, squared);
      }
    }
  }
}

std::vector<FlakeWeight> FlakeGrid::one_by_one(const FootprintWindow& window, double share, glm::dvec2 center,
                                               double cut) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (double reach = 2; !std::isfinite(nearest); reach *= 2) {
    visit(window, center, reach, [&](std::uint32_t, double squared) { nearest = std::min(nearest, squared); });
  }
  const double reach = std::sqrt(cut * cut + nearest);
  std::vector<FlakeWeight> found;
  if (std::numbers::pi * reach * reach * share > 1) {  // as many or more are met as there are
    std::vector<double> sums(flakes_.size());
    visit(window, center, reach,
          [&](std::uint32_t flake, double squared) { sums[flake] += std::exp(-0.5 * (squared - nearest)); });
    for (std::uint32_t flake = 0; flake < sums.size(); ++flake) {
      if (sums[flake] > 0) found.push_back({flake, sums[flake]});
    }
    return found;
  }
  visit(window, center, reach, [&](std::uint32_t flake, double squared) {
    found.push_back({flake, std::exp(-0.5 * (squared - nearest))});
  });
  if (2 * window.reach_x(reach) >= domain_.x || 2 * window.reach_y(reach) >= domain_.y) add_up_periods(found);
  return found;
}

std::vector<FlakeWeight> FlakeGrid::folded(const std::vector<Wave>& waves, glm::dvec2 center) const {
  std::vector<FlakeWeight> all(flakes_.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    const glm::dvec2 o = flakes_[k].center - center;
    double sum = 1;
    for (const Wave& wave : waves) sum += wave.amplitude * std::cos(wave.turn.x * o.x + wave.turn.y * o.y);
    all[k] = {static_cast<std::uint32_t>(k), sum};
  }
  return all;
}

std::vector<FlakeWeight> FlakeGrid::weights(const Footprint& footprint, double cut) const {
  const SymmetricMatrix2 v = widened(footprint.covariance);
  const FootprintWindow window(v);
  const glm::dvec2 center = inside(footprint.center, domain_);
  const double share = share_of_domain(v);
  const double periods = std::numbers::pi * cut * cut * share;
  std::vector<FlakeWeight> found;
  if (share > k_worth_a_look) {
    const std::vector<Wave> series = waves(v);
    if (static_cast<double>(series.size()) <= periods) found = folded(series, center);
  }
  if (found.empty()) found = one_by_one(window, share, center, cut);
  drop_light_ones(found, cut);
  return found;
}

}  // namespace glint
