#include "core/pndf/mixture_pndf.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/math/flush_to_zero.h"
#include "core/pndf/cell_visit.h"
#include "core/pndf/mixture_query.h"
#include "core/pndf/mixture_rows.h"
#include "core/pndf/mixture_sampler.h"
#include "core/pndf/mixture_splat.h"

namespace glint {
namespace {

constexpr std::size_t k_most_groups = 8;  // of rows, each with an image of its own
constexpr double k_group_elements = 4000;

class MixtureFootprint final : public FootprintPndf {
 public:
  explicit MixtureFootprint(const MixtureFrame& frame) : frame_(frame) {
    if (frame.elements_within() <= k_most_prepared) prepared_.emplace(frame, frame.rows());
    mass_ = prepared_ ? prepared_->mass() : 1;
  }

  void evaluate(std::span<const glm::dvec2> s, std::span<double> density) const override {
    const FlushToZero quick;
    std::fill(density.begin(), density.end(), 0.0);
    const auto add = [&](const PreparedMixture& part) {
      for (std::size_t k = 0; k < s.size(); ++k) density[k] += part.density(s[k]);
    };
    if (prepared_) {
      add(*prepared_);
      return;
    }
    // So many that they are not kept: made again, some rows at a time.
    const auto [first, last] = frame_.rows();
    for (std::int64_t row = first; row <= last; row += k_streamed_rows) {
      add(PreparedMixture(frame_, {row, std::min(row + k_streamed_rows - 1, last)}));
    }
  }

  [[nodiscard]] glm::dvec2 sample(RandomStream& random) const override { return sample_mixture(frame_, random); }

  [[nodiscard]] double pdf(glm::dvec2 s) const override { return mass_ > 0 ? FootprintPndf::pdf(s) / mass_ : 0; }

  [[nodiscard]] PndfError error() const override { return {}; }

 private:
  static constexpr double k_most_prepared = 2e6;  // elements: 60 MB
  static constexpr std::int64_t k_streamed_rows = 32;

  MixtureFrame frame_;
  std::optional<PreparedMixture> prepared_;
  double mass_;  // of wide footprints, whose lattice does not ripple: 1
};

// Most of what such a footprint sees are the border's texels again and again.
bool is_for_exact(const MixtureFrame& frame) {
  const double seeds = static_cast<double>(frame.map->width()) * frame.map->height() / frame.lattice.area();
  return frame.map->wrap() == Wrap::clamp && frame.elements_within() > 4 * seeds + 1e6;
}

Surface modelled(const Surface& surface) {
  const bool constant = surface.interpolation() == Interpolation::constant;
  return {surface.shared_map(), constant ? Interpolation::constant : Interpolation::smooth};
}

}  // namespace

MixturePndf::MixturePndf(const Surface& surface, double intrinsic_roughness, const MixtureSettings& settings)
    : surface_(modelled(surface)), intrinsic_roughness_(intrinsic_roughness), settings_(settings) {}

PndfModelInfo MixturePndf::info() const {
  return {"mixture", surface_.interpolation(),
          "off by the step between its elements, which ripple as their lattice does", 0};
}

const FastExactPndf& MixturePndf::exact() const {
  std::call_once(exact_built_,
                 [this] { exact_ = std::make_unique<const FastExactPndf>(surface_, intrinsic_roughness_); });
  return *exact_;
}

FootprintPndf& MixturePndf::at(const Footprint& footprint, PndfWorkspace& workspace) const {
  const Footprint reduced{reduced_center(surface_.map(), footprint.center), footprint.covariance};
  const MixtureFrame frame(surface_, settings_, reduced, glm::dvec2(intrinsic_roughness_), k_query_cut);
  if (is_for_exact(frame)) return exact().at(footprint, workspace);
  return workspace.emplace<MixtureFootprint>(frame);
}

std::optional<PndfImage> MixturePndf::image(const Footprint& footprint, const PndfGrid& grid,
                                            JobControl& control) const {
  PndfImage image;
  image.grid = grid;
  image.widening = widening_for(grid, intrinsic_roughness_);
  const double variance = intrinsic_roughness_ * intrinsic_roughness_;
  const glm::dvec2 roughness{std::sqrt(variance + image.widening.x), std::sqrt(variance + image.widening.y)};
  const Footprint reduced{reduced_center(surface_.map(), footprint.center), footprint.covariance};
  const MixtureFrame frame(surface_, settings_, reduced, roughness, k_image_cut);
  if (is_for_exact(frame)) return exact().image(footprint, grid, control);
  const auto [first, last] = frame.rows();
  const auto count = static_cast<std::size_t>(last - first + 1);
  const std::size_t groups = std::clamp<std::size_t>(
      static_cast<std::size_t>(frame.elements_within() / k_group_elements), 1, std::min(count, k_most_groups));
  // Every group takes each so-manieth row: rows near the centre have more elements.
  std::vector<std::optional<MixtureCanvas>> canvases(groups);
  const auto splat_group = [&](std::size_t group) {
    const FlushToZero quick;
    MixtureCanvas& canvas = canvases[group].emplace(grid);
    MixtureRows rows(frame);
    ElementList list;
    for (std::size_t row = group; row < count && !control.cancelled(); row += groups) {
      list.count = 0;
      rows.append(first + static_cast<std::int64_t>(row), list);
      splat_elements(list, canvas);
    }
  };
  if (!parallel_blocks(groups, control, splat_group)) return std::nullopt;
  image.density.resize(grid.cells());
  for (const std::optional<MixtureCanvas>& canvas : canvases) canvas->add_to(image.density, 1 / frame.kept());
  return image;
}

}  // namespace glint
