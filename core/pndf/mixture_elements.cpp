#include "core/pndf/mixture_elements.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "core/math/flush_to_zero.h"
#include "core/pndf/cell_visit.h"
#include "core/pndf/exact_query.h"
#include "core/pndf/footprint_window.h"
#include "core/pndf/mixture_pndf.h"

namespace glint {
namespace {

MixtureFrame::Seeds rows_in(const MixtureFrame& frame, const PlaneRectangle& part) {
  const MixtureFrame::Seeds rows = frame.rows();
  const auto seed = [&](double v, auto round) { return round(v / frame.lattice.step.y - 0.5); };
  const double first = seed(part.min.y, [](double x) { return std::ceil(x); });
  const double last = seed(part.max.y, [](double x) { return std::floor(x); });
  return {static_cast<std::int64_t>(std::max(first, static_cast<double>(rows.first))),
          static_cast<std::int64_t>(std::min(last, static_cast<double>(rows.last)))};
}

}  // namespace

double MixtureElement::density(glm::dvec2 s) const {
  const glm::dvec2 distance = whitening.apply(s - mean);
  const double squared = distance.x * distance.x + distance.y * distance.y;
  if (squared >= room) return 0;
  return weight * whitening.determinant() / (2 * std::numbers::pi) * std::exp(-0.5 * squared);
}

MixtureFrame element_frame(const Surface& surface, const MixtureSettings& settings, const Footprint& footprint,
                           double intrinsic_roughness) {
  const Footprint reduced{reduced_center(surface.map(), footprint.center), footprint.covariance};
  return {surface, settings, reduced, glm::dvec2(intrinsic_roughness), MixturePndf::k_query_cut};
}

double seeds_visited(const MixtureFrame& frame, const PlaneRectangle& part) {
  const auto [first, last] = rows_in(frame, part);
  const auto [left, right] = frame.columns();
  return std::max(0.0, static_cast<double>(last - first + 1)) * std::max(0.0, static_cast<double>(right - left + 1));
}

std::vector<MixtureElement> elements_in(const MixtureFrame& frame, const PlaneRectangle& part,
                                        std::vector<MixtureElement> reused) {
  std::vector<MixtureElement> elements = std::move(reused);
  elements.clear();
  const auto [first, last] = rows_in(frame, part);
  if (first > last) return elements;
  const FlushToZero quick;
  MixtureRows rows(frame);
  ElementList list;
  for (std::int64_t row = first; row <= last; ++row) {
    list.count = 0;
    rows.append(row, list);
    const double v = (static_cast<double>(row) + 0.5) * frame.lattice.step.y;
    for (std::size_t k = 0; k < list.count; ++k) {
      const double u = frame.center.x + static_cast<double>(list.u[k]);
      if (u < part.min.x || u > part.max.x) continue;
      const auto field = [&](const std::vector<float>& of) { return static_cast<double>(of[k]); };
      const Whitening whitening{field(list.w11), field(list.w12), field(list.w22)};
      const double weight = 2 * std::numbers::pi * field(list.amplitude) / whitening.determinant();
      elements.push_back({{u, v}, {field(list.x), field(list.y)}, whitening, weight, field(list.room)});
    }
  }
  return elements;
}

glm::dmat2 element_jacobian(const MixtureFrame& frame, const Surface& surface, glm::dvec2 seed) {
  if (frame.elements == MixtureElements::flat || frame.piecewise_constant) return glm::dmat2(0);
  return Surface(surface.shared_map(), Interpolation::smooth).jacobian(seed);
}

ElementPart part_towards(const MixtureFrame& frame, const MixtureElement& element, const glm::dmat2& jacobian,
                         glm::dvec2 s) {
  // With Sigma_e = L L^T and A = diag(1 / roughness) J L the covariance is L (I + A^T A)^-1 L^T: nothing is inverted
  // that could be singular.
  const CholeskyFactor& l = frame.spread;
  const auto scaled = [&](glm::dvec2 u) { return (jacobian * u) / frame.roughness; };
  const glm::dvec2 a0 = scaled({l.l11, l.l21});
  const glm::dvec2 a1 = scaled({0, l.l22});
  const double xx = 1 + a0.x * a0.x + a0.y * a0.y;
  const double xy = a0.x * a1.x + a0.y * a1.y;
  const double yy = 1 + a1.x * a1.x + a1.y * a1.y;
  const double turned = a0.x * a1.y - a0.y * a1.x;
  const double whole = xx + yy - 1 + turned * turned;  // xx yy - xy^2 in terms that do not cancel
  // M = (I + A^T A)^-1
  const double m_xx = yy / whole;
  const double m_xy = -xy / whole;
  const double m_yy = xx / whole;
  ElementPart part{};
  const double low = l.l21 * m_xx + l.l22 * m_xy;
  part.covariance = {l.l11 * l.l11 * m_xx, l.l11 * low, l.l21 * low + l.l22 * (l.l21 * m_xy + l.l22 * m_yy)};
  const glm::dvec2 off = (s - element.mean) / frame.roughness;
  const glm::dvec2 pull{a0.x * off.x + a0.y * off.y, a1.x * off.x + a1.y * off.y};
  const glm::dvec2 moved = l.apply({m_xx * pull.x + m_xy * pull.y, m_xy * pull.x + m_yy * pull.y});
  const glm::dvec2 o = element.seed - frame.center;
  const SymmetricMatrix2& k = frame.drift;
  part.center = element.seed - glm::dvec2(k.xx * o.x + k.xy * o.y, k.xy * o.x + k.yy * o.y) + moved;
  return part;
}

}  // namespace glint
