#include "core/pndf/mixture_pndf.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/math/flush_to_zero.h"
#include "core/pndf/cell_visit.h"
#include "core/pndf/exact_query.h"
#include "core/pndf/footprint_window.h"
#include "core/pndf/mixture_merge.h"
#include "core/pndf/mixture_query.h"
#include "core/pndf/mixture_rows.h"
#include "core/pndf/mixture_sampler.h"
#include "core/pndf/mixture_search.h"
#include "core/pndf/mixture_splat.h"

namespace glint {
namespace {

constexpr std::size_t k_most_groups = 8;  // of rows, each with an image of its own
constexpr double k_group_elements = 4000;
constexpr std::size_t k_group_cells = 1U << 24U;  // of all groups' images together
constexpr std::size_t k_most_summed = 1U << 15U;  // elements added up in single precision

class MixtureFootprint final : public FootprintPndf {
 public:
  MixtureFootprint(const MixtureFrame& frame, const MixtureBounds* bounds) : frame_(frame) {
    const double elements = frame.elements_within();
    is_streamed_ = elements > k_most_prepared;
    preparing_cost_ = k_preparing_cost + elements;
    query_cost_ = k_query_cost + k_query_cost_element * elements;
    if (bounds != nullptr && !is_streamed_ && MixtureSearch::can_search(frame)) search_.emplace(frame, *bounds);
  }

  void expect_queries(std::size_t count) const override {
    const bool many = static_cast<double>(count) * query_cost_ >= preparing_cost_;
    plan_.store(many ? Plan::prepare : Plan::search, std::memory_order_relaxed);
  }

  void evaluate(std::span<const glm::dvec2> s, std::span<double> density) const override {
    const FlushToZero quick;
    if (search_ && !should_prepare(s.size())) {
      double spent = 0;
      for (std::size_t k = 0; k < s.size(); ++k) density[k] = search_->density(s[k], spent);
      spent_.fetch_add(spent, std::memory_order_relaxed);
      return;
    }
    std::fill(density.begin(), density.end(), 0.0);
    const auto add = [&](const PreparedMixture& part) {
      for (std::size_t k = 0; k < s.size(); ++k) density[k] += part.density(s[k]);
    };
    if (!is_streamed_) {
      add(prepared());
      return;
    }
    // So many that they are not kept: made again, some rows at a time.
    const auto [first, last] = frame_.rows();
    for (std::int64_t row = first; row <= last; row += k_streamed_rows) {
      add(PreparedMixture(frame_, {row, std::min(row + k_streamed_rows - 1, last)}));
    }
  }

  [[nodiscard]] glm::dvec2 sample(RandomStream& random) const override { return sample_mixture(frame_, random); }

  [[nodiscard]] double pdf(glm::dvec2 s) const override {
    double mass = mass_.load(std::memory_order_relaxed);
    if (mass < 0) {
      mass = sum_of_weights(frame_);
      mass_.store(mass, std::memory_order_relaxed);
    }
    return mass > 0 ? FootprintPndf::pdf(s) / mass : 0;
  }

  [[nodiscard]] PndfError error() const override { return {}; }

 private:
  static constexpr double k_most_prepared = 4e6;  // elements: 110 MB
  static constexpr std::int64_t k_streamed_rows = 32;
  // As measured, in elements that are prepared in that time.
  static constexpr double k_preparing_cost = 350;        // beside its elements
  static constexpr double k_query_cost = 30;             // of a query without preparing
  static constexpr double k_query_cost_element = 0.025;  // and for each element within the cut

  enum class Plan { undecided, search, prepare };

  // Once queries have taken as long as preparing would have, which then was the better choice at most by half.
  [[nodiscard]] bool should_prepare(std::size_t more) const {
    const Plan plan = plan_.load(std::memory_order_relaxed);
    if (plan != Plan::undecided) return plan == Plan::prepare;
    return spent_.load(std::memory_order_relaxed) + static_cast<double>(more) * query_cost_ >= preparing_cost_;
  }

  const PreparedMixture& prepared() const {
    std::call_once(prepared_once_, [this] { prepared_.emplace(frame_, frame_.rows()); });
    return *prepared_;
  }

  MixtureFrame frame_;
  std::optional<MixtureSearch> search_;
  bool is_streamed_;
  double preparing_cost_;
  double query_cost_;
  mutable std::atomic<double> spent_{0};
  mutable std::atomic<Plan> plan_{Plan::undecided};
  mutable std::once_flag prepared_once_;
  mutable std::optional<PreparedMixture> prepared_;
  mutable std::atomic<double> mass_{-1};
};

}  // namespace

Surface MixturePndf::modelled(const Surface& surface) {
  const bool constant = surface.interpolation() == Interpolation::constant;
  return {surface.shared_map(), constant ? Interpolation::constant : Interpolation::smooth};
}

MixturePndf::MixturePndf(const Surface& surface, double intrinsic_roughness, const MixtureSettings& settings,
                         std::shared_ptr<const MixtureAtlas> atlas)
    : surface_(modelled(surface)),
      intrinsic_roughness_(intrinsic_roughness),
      settings_(settings),
      atlas_(std::move(atlas)) {}

PndfModelInfo MixturePndf::info() const {
  const MixtureBounds* built = bounds_in_use_.load(std::memory_order_acquire);
  const std::size_t bytes = built != nullptr ? built->bytes() : 0;
  return {"mixture", surface_.interpolation(),
          "off by the step between its elements, which ripple as their lattice does", bytes};
}

const FastExactPndf& MixturePndf::exact() const {
  std::call_once(exact_built_,
                 [this] { exact_ = std::make_unique<const FastExactPndf>(surface_, intrinsic_roughness_); });
  return *exact_;
}

const MixtureBounds* MixturePndf::bounds() const {
  std::call_once(bounds_built_, [this] {
    const bool constant = surface_.interpolation() == Interpolation::constant;
    if (std::optional<CellSeeds> seeds = CellSeeds::of(surface_.map(), constant, settings_)) {
      bounds_ = std::make_unique<const MixtureBounds>(surface_.shared_map(), *std::move(seeds), intrinsic_roughness_);
      bounds_in_use_.store(bounds_.get(), std::memory_order_release);
    }
  });
  return bounds_.get();
}

FootprintPndf& MixturePndf::at(const Footprint& footprint, PndfWorkspace& workspace) const {
  const Footprint reduced{reduced_center(surface_.map(), footprint.center), footprint.covariance};
  const MixtureFrame frame(surface_, settings_, reduced, glm::dvec2(intrinsic_roughness_), k_query_cut);
  if (!frame.sums_elements()) return exact().at(footprint, workspace);
  return workspace.emplace<MixtureFootprint>(frame, bounds());
}

std::optional<PndfImage> MixturePndf::image(const Footprint& footprint, const PndfGrid& grid,
                                            JobControl& control) const {
  if (atlas_ && atlas_->is_of(surface_, intrinsic_roughness_, settings_, grid)) {
    if (std::optional<PndfImage> looked_up = atlas_->image(footprint)) return looked_up;
  }
  PndfImage image;
  image.grid = grid;
  image.widening = widening_for(grid, intrinsic_roughness_);
  const double variance = intrinsic_roughness_ * intrinsic_roughness_;
  const glm::dvec2 roughness{std::sqrt(variance + image.widening.x), std::sqrt(variance + image.widening.y)};
  const Footprint reduced{reduced_center(surface_.map(), footprint.center), footprint.covariance};
  const MixtureFrame frame(surface_, settings_, reduced, roughness, k_image_cut);
  const MixtureFrame single(surface_, settings_, reduced, glm::dvec2(intrinsic_roughness_), k_query_cut);
  if (!single.sums_elements()) return exact().image(footprint, grid, control);  // as for single normals
  const auto [first, last] = frame.rows();
  image.density.resize(grid.cells());
  if (last < first) return image;  // between seeds that do not reach it
  const auto count = static_cast<std::size_t>((last - first) / ElementMerger::k_rows + 1);
  const std::size_t room = std::max<std::size_t>(k_group_cells / grid.cells(), 1);
  const std::size_t groups = std::clamp<std::size_t>(
      static_cast<std::size_t>(frame.elements_within() / k_group_elements), 1, std::min({count, k_most_groups, room}));
  // Every group takes each so-manieth band of rows: those near the centre have more elements.
  std::vector<std::vector<double>> parts(groups);
  std::vector<double> merging_errors(groups);
  const auto splat_group = [&](std::size_t group) {
    const FlushToZero quick;
    std::vector<double>& part = group == 0 ? image.density : parts[group];
    part.resize(grid.cells());
    MixtureCanvas canvas(grid);
    MixtureRows rows(frame);
    ElementMerger merger(frame);
    ElementList list;
    std::size_t summed = 0;
    for (std::size_t band = group; band < count && !control.cancelled(); band += groups) {
      list.count = 0;
      const std::int64_t begin = first + static_cast<std::int64_t>(band) * ElementMerger::k_rows;
      for (std::int64_t row = begin; row <= std::min(begin + ElementMerger::k_rows - 1, last); ++row) {
        rows.append(row, list);
      }
      merging_errors[group] += merger.merge(list);
      splat_elements(list, canvas);
      summed += list.count;
      if (summed < k_most_summed) continue;
      canvas.move_to(part);
      summed = 0;
    }
    canvas.move_to(part);
  };
  if (!parallel_blocks(groups, control, splat_group)) return std::nullopt;
  for (std::size_t group = 1; group < groups; ++group) {
    for (std::size_t k = 0; k < image.density.size(); ++k) image.density[k] += parts[group][k];
  }
  const double factor = 1 / frame.kept();
  for (double& density : image.density) density *= factor;
  image.error.bounded = std::accumulate(merging_errors.begin(), merging_errors.end(), 0.0);
  return image;
}

}  // namespace glint
