#include "core/pndf/flake_pndf.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/math/flush_to_zero.h"
#include "core/pndf/exact_query.h"
#include "core/pndf/mixture_splat.h"

namespace glint {
namespace {

constexpr std::size_t k_chunk = 1024;     // flakes splatted at once
constexpr std::size_t k_most_groups = 8;  // of chunks, each with an image of its own
constexpr std::size_t k_group_flakes = 4096;
constexpr std::size_t k_group_cells = 1U << 24U;  // of all groups' images together
constexpr std::size_t k_most_summed = 1U << 15U;  // flakes added up in single precision

// What the joint cut moves: the mass of four dimensions beyond it, taken away and given back. A guess, for flakes that
// lie evenly.
PndfError error_of_cut(double cut) {
  const double half = 0.5 * cut * cut;
  PndfError error;
  error.estimated = 2 * (1 + half) * std::exp(-half);
  return error;
}

class FlakeFootprint final : public FootprintPndf {
 public:
  explicit FlakeFootprint(std::shared_ptr<const PreparedFlakes> flakes) : flakes_(std::move(flakes)) {}

  void evaluate(std::span<const glm::dvec2> s, std::span<double> density) const override {
    for (std::size_t k = 0; k < s.size(); ++k) density[k] = flakes_->density(s[k]);
  }
  [[nodiscard]] glm::dvec2 sample(RandomStream& random) const override { return flakes_->sample(random); }
  [[nodiscard]] double pdf(glm::dvec2 s) const override { return flakes_->density(s); }
  [[nodiscard]] PndfError error() const override { return error_of_cut(FlakePndf::k_query_cut); }

 private:
  std::shared_ptr<const PreparedFlakes> flakes_;
};

// Groups and the order within them depend on the count alone; images are added up in order of groups.
bool splat(const PreparedFlakes& flakes, PndfImage& image, JobControl& control) {
  const std::size_t chunks = (flakes.count() + k_chunk - 1) / k_chunk;
  const std::size_t room = std::max<std::size_t>(k_group_cells / image.grid.cells(), 1);
  const std::size_t groups =
      std::clamp<std::size_t>(flakes.count() / k_group_flakes, 1, std::min({chunks, k_most_groups, room}));
  std::vector<std::vector<double>> parts(groups);
  const bool finished = parallel_blocks(groups, control, [&](std::size_t group) {
    const FlushToZero quick;
    std::vector<double>& part = parts[group];
    part.resize(image.grid.cells());
    MixtureCanvas canvas(image.grid);
    ElementList list;
    std::size_t summed = 0;
    for (std::size_t chunk = group; chunk < chunks && !control.cancelled(); chunk += groups) {
      flakes.copy_to(list, chunk * k_chunk, std::min(k_chunk, flakes.count() - chunk * k_chunk));
      splat_elements(list, canvas);
      summed += list.count;
      if (summed < k_most_summed) continue;
      canvas.move_to(part);
      summed = 0;
    }
    canvas.move_to(part);
  });
  if (!finished) return false;
  for (const std::vector<double>& part : parts) {
    for (std::size_t k = 0; k < part.size(); ++k) image.density[k] += part[k];
  }
  return true;
}

// Where single precision does not tell normals apart.
bool evaluate_cells(const PreparedFlakes& flakes, PndfImage& image, JobControl& control) {
  return parallel_blocks(static_cast<std::size_t>(image.grid.rows), control, [&](std::size_t block) {
    const int row = static_cast<int>(block);
    for (int column = 0; column < image.grid.columns; ++column) {
      image.density[image.grid.index(column, row)] = flakes.density(image.grid.center(column, row));
    }
  });
}

}  // namespace

FlakePndf::FlakePndf(std::vector<Flake> flakes, glm::dvec2 domain, double intrinsic_roughness)
    : grid_(std::move(flakes), domain), intrinsic_roughness_(intrinsic_roughness) {}

PndfModelInfo FlakePndf::info() const {
  return {"flakes", Interpolation::constant,
          "of its own flakes but for what cuts leave out; renormalised: every footprint has energy 1", grid_.bytes()};
}

PreparedFlakes FlakePndf::prepare(const Footprint& footprint, glm::dvec2 roughness, double cut) const {
  return {grid_.flakes(), grid_.weights(footprint, cut), roughness, cut};
}

std::shared_ptr<const PreparedFlakes> FlakePndf::whole() const {
  std::call_once(whole_prepared_, [this] {
    whole_ = std::make_shared<const PreparedFlakes>(grid_.flakes(), grid_.equal_weights(),
                                                    glm::dvec2(intrinsic_roughness_), k_query_cut);
  });
  return whole_;
}

FootprintPndf& FlakePndf::at(const Footprint& footprint, PndfWorkspace& workspace) const {
  if (grid_.sees_all_alike(footprint)) return workspace.emplace<FlakeFootprint>(whole());
  return workspace.emplace<FlakeFootprint>(
      std::make_shared<const PreparedFlakes>(prepare(footprint, glm::dvec2(intrinsic_roughness_), k_query_cut)));
}

std::optional<PndfImage> FlakePndf::image(const Footprint& footprint, const PndfGrid& grid, JobControl& control) const {
  PndfImage image;
  image.grid = grid;
  image.widening = widening_for(grid, intrinsic_roughness_);
  image.density.resize(grid.cells());
  const double variance = intrinsic_roughness_ * intrinsic_roughness_;
  const glm::dvec2 roughness{std::sqrt(variance + image.widening.x), std::sqrt(variance + image.widening.y)};
  const bool single = std::min(roughness.x, roughness.y) >= k_least_single_roughness;
  const double cut = single ? k_image_cut : k_query_cut;
  image.error = error_of_cut(cut);
  if (control.cancelled()) return std::nullopt;
  const PreparedFlakes flakes = prepare(footprint, roughness, cut);
  if (control.cancelled()) return std::nullopt;
  const bool finished = single ? splat(flakes, image, control) : evaluate_cells(flakes, image, control);
  if (!finished) return std::nullopt;
  return image;
}

}  // namespace glint
