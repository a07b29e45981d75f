#include "core/pndf/binned_pndf.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "core/pndf/fitted_window.h"
#include "core/pndf/surface_sampling.h"

namespace glint {
namespace {

constexpr std::uint64_t k_block = 1U << 15U;  // draws of one random stream

struct Histogram {
  std::vector<std::atomic<std::uint64_t>> counts;
  std::atomic<std::size_t> invalid{0};
  std::atomic<std::size_t> outside{0};

  explicit Histogram(std::size_t cells) : counts(cells) {}
};

// Where s falls in the grid; negative outside.
std::int64_t cell_of(const PndfGrid& grid, glm::dvec2 s) {
  const glm::dvec2 pitch = grid.pitch();
  const double column = std::floor((s.x - grid.s_min) / pitch.x);
  const double row = std::floor((grid.t_max - s.y) / pitch.y);
  if (!(column >= 0 && row >= 0 && column < grid.columns && row < grid.rows)) return -1;
  return static_cast<std::int64_t>(grid.index(static_cast<int>(column), static_cast<int>(row)));
}

// Integer counts add up the same in any order, so the threads may share them. A draw outside the unit disk is an
// invalid normal; it is counted as such and, D_P being a density over the plane, in its cell too.
std::unique_ptr<Histogram> count(const BinnedPndf& model, const BinnedSettings& settings, const Footprint& footprint,
                                 const PndfGrid& grid, JobControl& control) {
  auto histogram = std::make_unique<Histogram>(grid.cells());
  const SurfaceSampler sampler(model.surface(), footprint, model.intrinsic_roughness());
  const std::size_t blocks = (settings.samples + k_block - 1) / k_block;
  const bool done = parallel_blocks(blocks, control, [&](std::size_t block) {
    RandomStream random(settings.seed, block);
    const std::uint64_t draws = std::min(k_block, settings.samples - block * k_block);
    std::size_t invalid = 0;
    std::size_t outside = 0;
    for (std::uint64_t draw = 0; draw < draws; ++draw) {
      const glm::dvec2 s = sampler.sample(random);
      if (s.x * s.x + s.y * s.y >= 1) ++invalid;
      const std::int64_t cell = cell_of(grid, s);
      if (cell >= 0) {
        histogram->counts[static_cast<std::size_t>(cell)].fetch_add(1, std::memory_order_relaxed);
      } else {
        ++outside;
      }
    }
    histogram->invalid.fetch_add(invalid, std::memory_order_relaxed);
    histogram->outside.fetch_add(outside, std::memory_order_relaxed);
  });
  return done ? std::move(histogram) : nullptr;
}

// The expected relative L1 of an image by its own noise: the mean absolute error of a cell is sqrt(2 / pi) of its
// standard error sqrt(D / (n a)), taken at the estimated D.
double own_noise(const PndfImage& image, std::uint64_t samples) {
  const double factor = 2 / (std::numbers::pi * static_cast<double>(samples) * image.grid.cell_area());
  double noise = 0;
  double mass = 0;
  for (const double density : image.density) {
    noise += std::sqrt(factor * density);
    mass += density;
  }
  return mass > 0 ? noise / mass : 0;
}

class BinnedFootprint final : public FootprintPndf {
 public:
  explicit BinnedFootprint(PndfImage bins) : bins_(std::move(bins)), cumulative_(bins_.density.size()) {
    std::partial_sum(bins_.density.begin(), bins_.density.end(), cumulative_.begin());
  }

  void evaluate(std::span<const glm::dvec2> s, std::span<double> density) const override {
    for (std::size_t k = 0; k < s.size(); ++k) {
      const std::int64_t cell = cell_of(bins_.grid, s[k]);
      density[k] = cell < 0 ? 0 : bins_.density[static_cast<std::size_t>(cell)];
    }
  }

  // Draws what evaluate() says: a bin by its count, a place in it uniformly. What fell outside the window is an invalid
  // normal outside every window.
  [[nodiscard]] glm::dvec2 sample(RandomStream& random) const override {
    const PndfGrid& grid = bins_.grid;
    const double target = random.next_uniform() / grid.cell_area();
    const auto bin = std::upper_bound(cumulative_.begin(), cumulative_.end(), target);
    const double x = random.next_uniform();
    const double y = random.next_uniform();
    if (bin == cumulative_.end()) return {2, 2};
    const auto index = static_cast<int>(bin - cumulative_.begin());
    const glm::dvec2 center = grid.center(index % grid.columns, index / grid.columns);
    return center + grid.pitch() * glm::dvec2(x - 0.5, y - 0.5);
  }

  [[nodiscard]] PndfError error() const override { return bins_.error; }

 private:
  PndfImage bins_;
  std::vector<double> cumulative_;
};

}  // namespace

BinnedPndf::BinnedPndf(Surface surface, double intrinsic_roughness, BinnedSettings settings)
    : surface_(std::move(surface)), intrinsic_roughness_(intrinsic_roughness), settings_(settings) {}

PndfModelInfo BinnedPndf::info() const {
  return {"binning", surface_.interpolation(), "statistical: its error falls as 1 / sqrt(samples)",
          2 * sizeof(double) * static_cast<std::size_t>(settings_.bins) * static_cast<std::size_t>(settings_.bins)};
}

FootprintPndf& BinnedPndf::at(const Footprint& footprint, PndfWorkspace& workspace) const {
  const PndfGrid grid = fitted_window(surface_, footprint, intrinsic_roughness_, settings_.bins);
  JobControl control;
  std::optional<PndfImage> bins = image(footprint, grid, control);
  return workspace.emplace<BinnedFootprint>(std::move(*bins));
}

std::optional<PndfImage> BinnedPndf::image(const Footprint& footprint, const PndfGrid& grid,
                                           JobControl& control) const {
  const std::unique_ptr<Histogram> histogram = count(*this, settings_, footprint, grid, control);
  if (!histogram) return std::nullopt;
  PndfImage image;
  image.grid = grid;
  image.density.reserve(grid.cells());
  image.standard_error.reserve(grid.cells());
  const double scale = 1 / (static_cast<double>(settings_.samples) * grid.cell_area());
  for (const std::atomic<std::uint64_t>& cell : histogram->counts) {
    const auto hits = static_cast<double>(cell.load(std::memory_order_relaxed));
    image.density.push_back(hits * scale);
    image.standard_error.push_back(std::sqrt(std::max(hits, 1.0)) * scale);  // an empty cell is known to one count
  }
  image.invalid_samples = histogram->invalid;
  image.outside_samples = histogram->outside;
  const double noise = own_noise(image, settings_.samples);
  if (noise > 0) image.error = {0, noise};  // an empty image tells nothing about itself
  return image;
}

}  // namespace glint
