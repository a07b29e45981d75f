#include "core/pndf/exact_pndf.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/pndf/cell_visit.h"
#include "core/pndf/folded_footprint.h"
#include "core/pndf/surface_sampling.h"
#include "core/pndf/triangle_kernel.h"

namespace glint {
namespace {

constexpr double k_first_cut = 8.5;
constexpr double k_widest_cut = 40;  // exp(-800): beyond it a double holds nothing
constexpr double k_folded_error = 1e-8;
constexpr double k_truncation = 1e-9;  // largest neglected share of a value

// What a joint cut neglects of D_P(s) is at most G_r(0) exp(-R^2 / 2) (1 + R^2 / 2), whatever the surface is: in the
// plane of whitened offsets, exp(-d_s^2 / 2) <= exp(-max(0, R^2 - d_u^2) / 2) outside the cut.
// A folded footprint is not cut, and the bound is that of the roughness alone.
double neglected(double cut, double roughness_peak, bool folded) {
  const double half = 0.5 * cut * cut;
  return roughness_peak * std::exp(-half) * (folded ? 1 : 1 + half);
}

class ExactFootprint final : public FootprintPndf {
 public:
  ExactFootprint(const ExactPndf& model, const Footprint& footprint)
      : model_(model),
        footprint_{reduced_center(model.cells().surface().map(), footprint.center), footprint.covariance},
        window_(footprint_.covariance) {
    const NormalMap& map = model.cells().surface().map();
    if (FoldedFootprint::pays(map, footprint_.covariance, ExactPndf::k_folded_cut)) {
      folded_ = std::make_unique<FoldedFootprint>(map, footprint_, model.cells().border());
    }
  }

  void evaluate(std::span<const glm::dvec2> s, std::span<double> density) const override {
    for (std::size_t k = 0; k < s.size(); ++k) density[k] = evaluate_one(s[k]);
  }

  [[nodiscard]] glm::dvec2 sample(RandomStream& random) const override {
    return SurfaceSampler(model_.cells().surface(), footprint_, model_.intrinsic_roughness()).sample(random);
  }

  [[nodiscard]] PndfError error() const override {
    // The series and polynomials of a folded footprint are good to their rounding, which nobody has bounded.
    if (folded_) return {0, k_folded_error};
    return {k_truncation, 0};
  }

 private:
  [[nodiscard]] double evaluate_one(glm::dvec2 s) const {
    const double roughness = model_.intrinsic_roughness();
    const double peak = 1 / (2 * std::numbers::pi * roughness * roughness);
    // Widen the cut until what it neglects does not count; far out in the tail that takes several steps.
    double cut = folded_ ? ExactPndf::k_folded_cut : k_first_cut;
    double density = folded_ ? folded_sum(s, cut) : plain_sum(s, cut);
    while (cut < k_widest_cut && neglected(cut, peak, folded_ != nullptr) > k_truncation * density) {
      cut = density > 0 ? std::max(cut + 0.5, cut_for(k_truncation * density / peak)) : cut * 1.5;
      cut = std::min(cut, k_widest_cut);
      density = folded_ ? folded_sum(s, cut) : plain_sum(s, cut);
    }
    return density;
  }

  // The cut R with exp(-R^2 / 2) (1 + R^2 / 2) = share.
  static double cut_for(double share) {
    double half = -std::log(share);
    for (int iteration = 0; iteration < 4; ++iteration) half = std::log1p(half) - std::log(share);
    return std::sqrt(2 * half) + 1e-6;
  }

  [[nodiscard]] double plain_sum(glm::dvec2 s, double cut) const {
    const glm::dvec2 roughness(model_.intrinsic_roughness());
    const double limit = cut * cut;
    CellVertices vertices;
    double sum = 0;
    visit_cells(
        model_.cells(), window_, footprint_.center, cut, {},
        [&](const NormalBox& box) { return box.squared_distance(s, roughness); },
        [&](CellIndex cell, const OffsetBox& box, const NormalBox&) {
          model_.cells().vertices(cell, box, vertices);
          double cell_sum = 0;
          vertices.for_each_triangle([&](const SurfaceTriangle& triangle) {
            const double squared =
                window_.squared_distance(triangle.offsets()) + triangle.normal_box().squared_distance(s, roughness);
            if (squared < limit) cell_sum += TriangleKernel(triangle, window_.whitening(), roughness).density(s, cut);
          });
          sum += cell_sum;
        });
    return sum;
  }

  [[nodiscard]] double folded_sum(glm::dvec2 s, double cut) const {
    const glm::dvec2 roughness(model_.intrinsic_roughness());
    const double limit = cut * cut;
    CellVertices vertices;
    double sum = 0;
    visit_period(
        model_.cells(), {}, [&](const NormalBox& box) { return box.squared_distance(s, roughness) < limit; },
        [&](CellIndex cell) {
          model_.cells().vertices(cell, {{0, 1}, {0, 1}}, vertices);
          const CellPolynomial weight = folded_->over_cell(cell.i, cell.j);
          double cell_sum = 0;
          vertices.for_each_triangle([&](const SurfaceTriangle& triangle) {
            if (triangle.normal_box().squared_distance(s, roughness) >= limit) return;
            cell_sum += weighted_density(triangle, s, roughness, cut, weight);
          });
          sum += cell_sum;
        });
    return sum;
  }

  const ExactPndf& model_;
  Footprint footprint_;
  FootprintWindow window_;
  std::unique_ptr<FoldedFootprint> folded_;
};

}  // namespace

ExactPndf::ExactPndf(Surface surface, double intrinsic_roughness, ExactSettings settings)
    : cells_(std::move(surface), settings.subdivision, settings.vertex_shift),
      intrinsic_roughness_(intrinsic_roughness),
      image_cut_(settings.image_cut),
      cell_means_(settings.cell_means) {}

PndfModelInfo ExactPndf::info() const {
  const Interpolation asked = cells_.surface().interpolation();
  const bool two_triangles = asked == Interpolation::smooth && cells_.subdivision() == 1;
  return {"exact", two_triangles ? Interpolation::linear : asked, "exact for its triangles, in double precision",
          cells_.bytes()};
}

FootprintPndf& ExactPndf::at(const Footprint& footprint, PndfWorkspace& workspace) const {
  return workspace.emplace<ExactFootprint>(*this, footprint);
}

}  // namespace glint
