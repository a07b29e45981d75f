#include "viewers/map/map_elements.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

namespace glint::view {
namespace {

constexpr std::string_view k_zoom_in = "zoom in to see the elements";
constexpr double k_far = std::numeric_limits<double>::infinity();
constexpr PlaneRectangle k_everywhere{{-k_far, -k_far}, {k_far, k_far}};

bool contains(const PlaneRectangle& part, glm::dvec2 u, double margin) {
  return u.x >= part.min.x - margin && u.y >= part.min.y - margin && u.x <= part.max.x + margin &&
         u.y <= part.max.y + margin;
}

PlaneRectangle grown(const PlaneRectangle& part, double by) {
  return {part.min - by, part.max + by};
}

// Seeds, or the texels between them where those are more.
double visited(const MixtureFrame& frame, const PlaneRectangle& part) {
  return seeds_visited(frame, part) * std::max(1.0, frame.lattice.area());
}

bool same_elements(const ElementRequest& a, const ElementRequest& b) {
  return a.surface == b.surface && a.mixture == b.mixture && a.intrinsic_roughness == b.intrinsic_roughness &&
         a.footprint == b.footprint;
}

bool same_view(const ElementRequest& a, const ElementRequest& b) {
  return a.part.min == b.part.min && a.part.max == b.part.max && a.pixels_per_texel == b.pixels_per_texel;
}

}  // namespace

bool operator==(const ElementRequest& a, const ElementRequest& b) {
  return same_elements(a, b) && same_view(a, b) && a.crosshair == b.crosshair;
}

const ShownElements& MapElements::at(const ElementRequest& request) {
  if (request_ && *request_ == request) return shown_;
  const bool same = request_ && same_elements(*request_, request);
  if (!same || !(whole_ || same_view(*request_, request))) gather(request);
  choose(request);
  request_ = request;
  return shown_;
}

void MapElements::gather(const ElementRequest& request) {
  elements_.clear();
  heaviest_ = 0;
  instead_ = {};
  whole_ = false;
  const MixtureFrame& frame = frame_.emplace(
      element_frame(request.surface->loaded.surface, request.mixture, request.footprint, request.intrinsic_roughness));
  if (!frame.sums_elements()) {
    whole_ = true;
    instead_ = "evaluated exactly here: no elements";
    return;
  }
  if (spacing(request) < k_least_spacing) return;
  // Few elements may lie in a wide box, that of a long footprint.
  whole_ = frame.elements_within() <= k_most_kept && visited(frame, k_everywhere) <= k_most_visited;
  const PlaneRectangle part = whole_ ? k_everywhere : grown(request.part, frame.lattice.deviation);
  if (!whole_ && visited(frame, part) > k_most_visited) {
    instead_ = k_zoom_in;
    return;
  }
  elements_ = elements_in(frame, part, std::move(elements_));
  for (const MixtureElement& element : elements_) heaviest_ = std::max(heaviest_, element.weight);
}

// Pixels between elements.
double MapElements::spacing(const ElementRequest& request) const {
  return std::min(frame_->lattice.step.x, frame_->lattice.step.y) * request.pixels_per_texel;
}

// The parts of the elements that light up.
void MapElements::divide(const ElementRequest& request) {
  if (!shown_.by_density || shown_.largest <= 0 || spacing(request) < k_part_spacing) return;
  for (const auto& [share, index] : order_) {
    if (share < k_least_lit) continue;
    const MixtureElement& element = elements_[index];
    const glm::dmat2 jacobian = element_jacobian(*frame_, request.surface->loaded.surface, element.seed);
    shown_.parts.push_back(part_towards(*frame_, element, jacobian, *request.crosshair));
  }
}

void MapElements::choose(const ElementRequest& request) {
  shown_ = {.radius = frame_->lattice.deviation, .instead = instead_};
  if (shown_.instead.empty() && spacing(request) < k_least_spacing) shown_.instead = k_zoom_in;
  if (!shown_.instead.empty()) return;
  shown_.by_density = request.crosshair.has_value();
  shown_.largest = heaviest_;
  if (request.crosshair) {
    densities_.resize(elements_.size());
    shown_.largest = 0;
    for (std::size_t k = 0; k < elements_.size(); ++k) {
      densities_[k] = elements_[k].density(*request.crosshair);
      shown_.largest = std::max(shown_.largest, densities_[k]);
    }
  }
  order_.clear();
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    const MixtureElement& element = elements_[k];
    if (!contains(request.part, element.seed, shown_.radius)) continue;
    const double value = request.crosshair ? densities_[k] : element.weight;
    const double share = shown_.largest > 0 ? value / shown_.largest : 0;
    if (element.weight >= k_least_share * heaviest_ || share >= k_least_share) order_.emplace_back(share, k);
  }
  if (order_.size() > ShownElements::k_most) {
    shown_.left_out = order_.size() - ShownElements::k_most;
    const auto last = order_.begin() + ShownElements::k_most;
    std::nth_element(order_.begin(), last, order_.end(), std::greater<>());
    order_.erase(last, order_.end());
  }
  std::sort(order_.begin(), order_.end());
  for (const auto& [share, index] : order_) {
    shown_.elements.push_back({elements_[index].seed, static_cast<float>(share)});
  }
  if (order_.empty()) shown_.instead = "no elements in view";
  divide(request);
}

std::string reason_without_elements(const Document& document) {
  const std::vector<PndfMethod>& methods = document.methods;
  const bool has = std::find(methods.begin(), methods.end(), PndfMethod::mixture) != methods.end();
  return has ? "" : "The mixture is not among the methods";
}

}  // namespace glint::view
