#include "core/pndf/prepared_flakes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glint {
namespace {

constexpr double k_cell_deviations = 2;  // the least side of a cell of normals

// The integral of a Gaussian over the disk whose squared radius, in deviations, is `room`.
double share_within(double room) {
  return -std::expm1(-0.5 * room);
}

std::size_t cell_of(double x, double corner, double side, std::size_t count) {
  return static_cast<std::size_t>(std::clamp((x - corner) / side, 0.0, static_cast<double>(count - 1)));
}

}  // namespace

PreparedFlakes::PreparedFlakes(std::span<const Flake> flakes, std::span<const FlakeWeight> weights,
                               glm::dvec2 roughness, double cut)
    : roughness_(roughness), cut_(cut) {
  double heaviest = 0;
  glm::dvec2 corner = flakes[weights.front().flake].normal;
  glm::dvec2 opposite = corner;
  for (const FlakeWeight& w : weights) {
    const glm::dvec2 n = flakes[w.flake].normal;
    heaviest = std::max(heaviest, w.weight);
    corner = {std::min(corner.x, n.x), std::min(corner.y, n.y)};
    opposite = {std::max(opposite.x, n.x), std::max(opposite.y, n.y)};
  }
  const double most = std::ceil(std::sqrt(static_cast<double>(weights.size())));
  const auto cells_along = [&](double extent, double deviation) {
    return std::clamp(std::ceil(extent / (k_cell_deviations * deviation)), 1.0, most);
  };
  const glm::dvec2 extent = opposite - corner;
  const glm::dvec2 cells{cells_along(extent.x, roughness.x), cells_along(extent.y, roughness.y)};
  corner_ = corner;
  // Not 0 where all normals are the same.
  cell_ = {std::max(extent.x / cells.x, roughness.x), std::max(extent.y / cells.y, roughness.y)};
  columns_ = static_cast<std::size_t>(cells.x);
  rows_ = static_cast<std::size_t>(cells.y);

  const auto cell = [&](const FlakeWeight& w) {
    const glm::dvec2 n = flakes[w.flake].normal;
    return row_of(n.y) * columns_ + column_of(n.x);
  };
  begin_.resize(columns_ * rows_ + 1);
  for (const FlakeWeight& w : weights) ++begin_[cell(w) + 1];
  for (std::size_t k = 1; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  elements_.resize(weights.size());
  for (const FlakeWeight& w : weights) {
    const double room = cut * cut + 2 * std::log(w.weight / heaviest);
    elements_[next[cell(w)]++] = {flakes[w.flake].normal, w.weight, room};
  }

  cumulative_.resize(elements_.size());
  double total = 0;
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    total += elements_[k].amplitude * share_within(elements_[k].room);
    cumulative_[k] = total;
  }
  const double scale = 1 / (2 * std::numbers::pi * roughness.x * roughness.y * total);
  for (Element& element : elements_) element.amplitude *= scale;
}

std::size_t PreparedFlakes::column_of(double s) const {
  return cell_of(s, corner_.x, cell_.x, columns_);
}
std::size_t PreparedFlakes::row_of(double t) const {
  return cell_of(t, corner_.y, cell_.y, rows_);
}

double PreparedFlakes::density(glm::dvec2 s) const {
  const glm::dvec2 reach = cut_ * roughness_;
  const std::size_t left = column_of(s.x - reach.x);
  const std::size_t right = column_of(s.x + reach.x);
  double sum = 0;
  for (std::size_t row = row_of(s.y - reach.y); row <= row_of(s.y + reach.y); ++row) {
    for (std::size_t k = begin_[row * columns_ + left]; k < begin_[row * columns_ + right + 1]; ++k) {
      const Element& element = elements_[k];
      const glm::dvec2 d = (s - element.normal) / roughness_;
      const double squared = d.x * d.x + d.y * d.y;
      if (squared < element.room) sum += element.amplitude * std::exp(-0.5 * squared);
    }
  }
  return sum;
}

glm::dvec2 PreparedFlakes::sample(RandomStream& random) const {
  const double share = random.next_uniform() * cumulative_.back();
  const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, share);
  const Element& element = elements_[static_cast<std::size_t>(found - cumulative_.begin())];
  const double distance = std::sqrt(-2 * std::log1p(-random.next_uniform() * share_within(element.room)));
  const double direction = 2 * std::numbers::pi * random.next_uniform();
  return element.normal + distance * roughness_ * glm::dvec2(std::cos(direction), std::sin(direction));
}

void PreparedFlakes::copy_to(ElementList& out, std::size_t first, std::size_t count) const {
  constexpr std::size_t k_padding = 16;  // whole vectors are read
  out.reserve(count + k_padding);
  out.count = count;
  const auto w11 = static_cast<float>(1 / roughness_.x);
  const auto w22 = static_cast<float>(1 / roughness_.y);
  for (std::size_t k = 0; k < count; ++k) {
    const Element& element = elements_[first + k];
    out.x[k] = static_cast<float>(element.normal.x);
    out.y[k] = static_cast<float>(element.normal.y);
    out.w11[k] = w11;
    out.w12[k] = 0;
    out.w22[k] = w22;
    out.amplitude[k] = static_cast<float>(element.amplitude);
    out.room[k] = static_cast<float>(element.room);
    out.u[k] = 0;
  }
}

}  // namespace glint
