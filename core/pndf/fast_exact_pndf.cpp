#include "core/pndf/fast_exact_pndf.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/math/flush_to_zero.h"
#include "core/pndf/cell_visit.h"
#include "core/pndf/exact_query.h"
#include "core/pndf/folded_footprint.h"
#include "core/pndf/surface_sampling.h"

namespace glint {
namespace {

// Of the double-precision twin's first attempt: where that folds, single normals go there at once.
constexpr double k_folded_cut = 7.5;
constexpr double k_least_roughness = 1e-6;  // below it a float does not hold a normal to a deviation
constexpr double k_most_groups = 1e6;

// Children without cells are told by bounds 32 squared roughnesses away.
static_assert(FastExactPndf::k_query_cut * FastExactPndf::k_query_cut < 31);

// Of cells that the footprint reaches.
double group_estimate(const NormalMap& map, const FootprintWindow& window, double cut) {
  const double width = std::min(NormalBounds::k_group, map.width());
  const double height = std::min(NormalBounds::k_group, map.height());
  return (2 * window.reach_x(cut) / width + 2) * (2 * window.reach_y(cut) / height + 2);
}

ExactSettings with_image_cut(ExactSettings settings) {
  settings.image_cut = std::min(settings.image_cut, FastExactPndf::k_image_cut);
  return settings;
}

// Queries of one footprint; asks double precision where it must.
class FastExactFootprint final : public FootprintPndf {
 public:
  FastExactFootprint(const ExactPndf& model, const NormalBounds& bounds, const Footprint& footprint,
                     const FootprintWindow& window)
      : model_(model),
        footprint_(footprint),
        frame_(make_query_frame(model.cells(), bounds, window, footprint.center, model.intrinsic_roughness(),
                                FastExactPndf::k_query_cut)) {}

  void evaluate(std::span<const glm::dvec2> s, std::span<double> density) const override {
    thread_local QueryScratch scratch;
    const FlushToZero quick;
    for (std::size_t k = 0; k < s.size(); ++k) {
      const std::optional<double> value = exact_query(frame_, s[k], scratch);
      density[k] = value ? *value : in_double(s[k]);
    }
  }

  [[nodiscard]] glm::dvec2 sample(RandomStream& random) const override {
    return SurfaceSampler(model_.cells().surface(), footprint_, model_.intrinsic_roughness()).sample(random);
  }

  [[nodiscard]] PndfError error() const override { return {PndfError::Kind::estimated, 5e-5}; }

 private:
  [[nodiscard]] double in_double(glm::dvec2 s) const {
    PndfWorkspace workspace;
    return model_.at(footprint_, workspace).pdf(s);
  }

  const ExactPndf& model_;
  Footprint footprint_;
  QueryFrame frame_;
};

}  // namespace

FastExactPndf::FastExactPndf(Surface surface, double intrinsic_roughness, const ExactSettings& settings)
    : exact_(std::move(surface), intrinsic_roughness, with_image_cut(settings)), bounds_(exact_.cells()) {}

PndfModelInfo FastExactPndf::info() const {
  PndfModelInfo info = exact_.info();
  info.guarantee = "exact for its triangles, in single precision within 1e-4";
  info.bytes += bounds_.bytes();
  return info;
}

FootprintPndf& FastExactPndf::at(const Footprint& footprint, PndfWorkspace& workspace) const {
  const NormalMap& map = exact_.cells().surface().map();
  const Footprint reduced{reduced_center(map, footprint.center), footprint.covariance};
  const FootprintWindow window(reduced.covariance);
  if (FoldedFootprint::pays(map, reduced.covariance, k_folded_cut) ||
      exact_.intrinsic_roughness() < k_least_roughness || !suits_single_precision(window, k_query_cut) ||
      !can_query(exact_.cells(), window, reduced.center, k_query_cut) ||
      group_estimate(map, window, k_query_cut) > k_most_groups) {
    return exact_.at(footprint, workspace);
  }
  return workspace.emplace<FastExactFootprint>(exact_, bounds_, reduced, window);
}

}  // namespace glint
