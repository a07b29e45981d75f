#include "core/pndf/lean_pndf.h"

#include <algorithm>
#include <optional>

#include "core/pndf/lean_footprint.h"

namespace glint {
namespace {

constexpr std::size_t k_cells_per_block = 1U << 17U;  // smaller images are quicker than handing them out

class LeanFootprint final : public FootprintPndf {
 public:
  explicit LeanFootprint(const SlopeGaussian& gaussian) : gaussian_(gaussian) {}

  void evaluate(std::span<const glm::dvec2> s, std::span<double> density) const override {
    std::transform(s.begin(), s.end(), density.begin(), [this](glm::dvec2 one) { return gaussian_.density(one); });
  }

  [[nodiscard]] glm::dvec2 sample(RandomStream& random) const override {
    double deviates[2];
    random.fill_normal(deviates);
    return gaussian_.normal({deviates[0], deviates[1]});
  }

  [[nodiscard]] PndfError error() const override { return {}; }

 private:
  SlopeGaussian gaussian_;
};

Surface modelled(const Surface& surface) {
  const bool constant = surface.interpolation() == Interpolation::constant;
  return {surface.shared_map(), constant ? Interpolation::constant : Interpolation::smooth};
}

}  // namespace

LeanPndf::LeanPndf(const Surface& surface, double intrinsic_roughness)
    : surface_(modelled(surface)), intrinsic_roughness_(intrinsic_roughness) {}

PndfModelInfo LeanPndf::info() const {
  return {"lean", surface_.interpolation(), "right in mean and covariance of the slopes; it draws no single glint",
          chain_bytes_.load()};
}

const LeanMoments& LeanPndf::chain() const {
  std::call_once(chain_built_, [this] {
    run_isolated([this] { chain_ = std::make_unique<const LeanMoments>(surface_.map()); });
    chain_bytes_ = chain_->bytes();
  });
  return *chain_;
}

SlopeMoments LeanPndf::moments(const Footprint& footprint) const {
  return footprint_moments(surface_, footprint, [this]() -> const LeanMoments& { return chain(); });
}

FootprintPndf& LeanPndf::at(const Footprint& footprint, PndfWorkspace& workspace) const {
  const double variance = intrinsic_roughness_ * intrinsic_roughness_;
  return workspace.emplace<LeanFootprint>(SlopeGaussian(moments(footprint), {variance, variance}));
}

std::optional<PndfImage> LeanPndf::image(const Footprint& footprint, const PndfGrid& grid, JobControl& control) const {
  if (control.cancelled()) return std::nullopt;
  PndfImage image;
  image.grid = grid;
  image.widening = widening_for(grid, intrinsic_roughness_);
  image.density.resize(grid.cells());
  const double variance = intrinsic_roughness_ * intrinsic_roughness_;
  const SlopeGaussian gaussian(moments(footprint), variance + image.widening);
  const auto rows_per_block = std::max<std::size_t>(k_cells_per_block / static_cast<std::size_t>(grid.columns), 1);
  const std::size_t rows = static_cast<std::size_t>(grid.rows);
  const bool drawn = parallel_blocks((rows + rows_per_block - 1) / rows_per_block, control, [&](std::size_t block) {
    const std::size_t first = block * rows_per_block;
    const std::size_t end = std::min(first + rows_per_block, rows);
    draw_slope_gaussian(gaussian, grid, static_cast<int>(first), static_cast<int>(end) - 1, image.density.data());
  });
  if (!drawn) return std::nullopt;
  return image;
}

}  // namespace glint
