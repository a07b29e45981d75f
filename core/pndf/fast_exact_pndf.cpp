#include "core/pndf/fast_exact_pndf.h"

#include <algorithm>
#include <utility>

#include "core/math/flush_to_zero.h"
#include "core/pndf/cell_visit.h"
#include "core/pndf/exact_query.h"
#include "core/pndf/folded_footprint.h"
#include "core/pndf/surface_sampling.h"

namespace glint {
namespace {

ExactSettings with_image_cut(ExactSettings settings) {
  settings.image_cut = std::min(settings.image_cut, FastExactPndf::k_image_cut);
  return settings;
}

// Queries of one footprint.
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
    for (std::size_t first = 0; first < s.size(); first += k_query_batch) {
      const std::size_t count = std::min(k_query_batch, s.size() - first);
      exact_query(frame_, s.subspan(first, count), scratch, density.subspan(first, count));
    }
  }

  [[nodiscard]] glm::dvec2 sample(RandomStream& random) const override {
    return SurfaceSampler(model_.cells().surface(), footprint_, model_.intrinsic_roughness()).sample(random);
  }

  [[nodiscard]] PndfError error() const override { return {0, 1.3e-4}; }

 private:
  const ExactPndf& model_;
  Footprint footprint_;
  QueryFrame frame_;
};

}  // namespace

FastExactPndf::FastExactPndf(Surface surface, double intrinsic_roughness, const ExactSettings& settings)
    : exact_(std::move(surface), intrinsic_roughness, with_image_cut(settings)) {}

const NormalBounds& FastExactPndf::bounds() const {
  std::call_once(bounds_built_, [this] { bounds_ = std::make_unique<const NormalBounds>(exact_.cells()); });
  return *bounds_;
}

PndfModelInfo FastExactPndf::info() const {
  PndfModelInfo info = exact_.info();
  info.guarantee = "exact for its triangles, in single precision within 1e-4";
  info.bytes += NormalBounds::bytes_for(exact_.cells());
  return info;
}

FootprintPndf& FastExactPndf::at(const Footprint& footprint, PndfWorkspace& workspace) const {
  const NormalMap& map = exact_.cells().surface().map();
  const Footprint reduced{reduced_center(map, footprint.center), footprint.covariance};
  const FootprintWindow window(reduced.covariance);
  if (FoldedFootprint::pays(map, reduced.covariance, ExactPndf::k_folded_cut) ||
      !can_query(exact_.cells(), window, reduced.center, exact_.intrinsic_roughness(), k_query_cut)) {
    return exact_.at(footprint, workspace);
  }
  return workspace.emplace<FastExactFootprint>(exact_, bounds(), reduced, window);
}

}  // namespace glint
