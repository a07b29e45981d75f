#include "core/pndf/mixture_atlas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "core/math/flush_to_zero.h"
#include "core/math/gaussian.h"
#include "core/pndf/cell_visit.h"
#include "core/pndf/exact_query.h"
#include "core/pndf/mixture_pndf.h"

namespace glint {
namespace {

constexpr double k_most_nodes = 1200;
constexpr double k_most_visited_nodes = 1e5;
constexpr double k_most_elements = 2e7;  // under all windows: some seconds of work

std::int64_t wrapped(std::int64_t k, int count) {
  const std::int64_t rest = k % count;
  return rest < 0 ? rest + count : rest;
}

// Images of windows under way: those of nodes that are wanted.
class WindowImages {
 public:
  WindowImages(const SplineLattice& lattice, const PndfGrid& grid, const std::vector<SplineFootprint::Node>& nodes)
      : lattice_(lattice) {
    for (const SplineFootprint::Node& node : nodes) images_.emplace(std::pair{node.j, node.i}, WindowImage(grid));
  }

  // That of the node (i, j), if it is wanted.
  WindowImage* at(std::int64_t i, std::int64_t j) {
    const auto found = images_.find({inside(j, lattice_.count.y), inside(i, lattice_.count.x)});
    return found == images_.end() ? nullptr : &found->second;
  }

  // The cells that the wanted windows overlap, in classes of cells that share no window: those of one class may be
  // added at once, and the order of additions does not depend on threads.
  [[nodiscard]] std::vector<std::vector<glm::i64vec2>> cells() const {
    std::set<std::array<std::int64_t, 4>> all;  // class, cell
    for (const auto& [node, image] : images_) {
      for (std::int64_t b = -2; b < 2; ++b) {
        for (std::int64_t a = -2; a < 2; ++a) {
          const std::int64_t i = inside(node.second + a, lattice_.count.x);
          const std::int64_t j = inside(node.first + b, lattice_.count.y);
          all.insert({class_of(j, lattice_.count.y), class_of(i, lattice_.count.x), j, i});
        }
      }
    }
    std::vector<std::vector<glm::i64vec2>> classes;
    std::pair<std::int64_t, std::int64_t> current{-1, -1};
    for (const auto& [of_j, of_i, j, i] : all) {
      if (classes.empty() || current != std::pair{of_j, of_i}) classes.emplace_back();
      current = {of_j, of_i};
      classes.back().push_back({i, j});
    }
    return classes;
  }

 private:
  [[nodiscard]] std::int64_t inside(std::int64_t k, int count) const {
    return lattice_.periodic ? wrapped(k, count) : k;
  }
  // Cells of one class are four apart; what is left over at a period's end has classes of its own.
  [[nodiscard]] std::int64_t class_of(std::int64_t k, int count) const {
    if (!lattice_.periodic) return wrapped(k, 4);
    const std::int64_t whole = count - count % 4;
    return k < whole ? k % 4 : 4 + (k - whole);
  }

  SplineLattice lattice_;
  std::map<std::pair<std::int64_t, std::int64_t>, WindowImage> images_;
};

// Canvases are large: each thread that comes takes one that is free.
class CanvasPool {
 public:
  explicit CanvasPool(const PndfGrid& grid) : grid_(grid) {}

  std::unique_ptr<WindowCanvas> take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) return std::make_unique<WindowCanvas>(grid_);
    std::unique_ptr<WindowCanvas> canvas = std::move(free_.back());
    free_.pop_back();
    return canvas;
  }
  void give(std::unique_ptr<WindowCanvas> canvas) {
    canvas->clear();
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(canvas));
  }

 private:
  PndfGrid grid_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<WindowCanvas>> free_;
};

// An atlas never merges.
MixtureSettings unmerged(MixtureSettings settings) {
  settings.merge_bound = 0;
  return settings;
}

// Seeds whose positions lie in [lo, hi).
MixtureFrame::Seeds seeds_between(double lo, double hi, double step) {
  return {static_cast<std::int64_t>(std::ceil(lo / step - 0.5)),
          static_cast<std::int64_t>(std::ceil(hi / step - 0.5)) - 1};
}

}  // namespace

MixtureAtlas::MixtureAtlas(const Surface& surface, double intrinsic_roughness, const MixtureSettings& settings,
                           const PndfGrid& grid, std::size_t most_bytes)
    : surface_(MixturePndf::modelled(surface)),
      intrinsic_roughness_(intrinsic_roughness),
      settings_(settings),
      grid_(grid),
      most_bytes_(most_bytes) {}

bool MixtureAtlas::is_of(const Surface& surface, double intrinsic_roughness, const MixtureSettings& settings,
                         const PndfGrid& grid) const {
  const bool same_surface = surface.shared_map() == surface_.shared_map() &&
                            MixturePndf::modelled(surface).interpolation() == surface_.interpolation();
  return same_surface && intrinsic_roughness == intrinsic_roughness_ && unmerged(settings) == unmerged(settings_) &&
         grid == grid_;
}

bool MixtureAtlas::suits(const SymmetricMatrix2& covariance) const {
  if (intrinsic_roughness_ < k_least_single_roughness) return false;
  if (!(std::sqrt(eigenvalues(covariance).y) >= SplineLattice::k_least_deviation)) return false;
  const SplineLattice lattice = SplineLattice::for_footprint(surface_.map(), covariance);
  // Of a turned needle the rectangle about its nodes is walked as well.
  const double area = lattice.pitch.x * lattice.pitch.y;
  if (64 * std::sqrt(covariance.xx * covariance.yy) / area > k_most_visited_nodes) return false;
  double nodes = SplineFootprint::node_count(lattice, covariance);
  if (lattice.periodic) nodes = std::min(nodes, static_cast<double>(lattice.count.x) * lattice.count.y);
  if (nodes > k_most_nodes) return false;
  if (nodes * area / MixtureLattice(surface_.map(), settings_).area() > k_most_elements) return false;
  const auto image_bytes =
      static_cast<double>(sizeof(float)) * static_cast<double>(WindowImage::stride_of(grid_)) * grid_.rows;
  const double canvases = static_cast<double>(WindowCanvas::k_windows) * thread_count();
  return std::max(nodes, canvases) * image_bytes <= static_cast<double>(most_bytes_);
}

Footprint MixtureAtlas::reduced(const Footprint& footprint) const {
  return {reduced_center(surface_.map(), footprint.center), footprint.covariance};
}

std::vector<SplineFootprint::Node> MixtureAtlas::missing(const SplineLattice& lattice,
                                                         const SplineFootprint& spline) const {
  const std::lock_guard lock(mutex_);
  std::vector<SplineFootprint::Node> lacking;
  for (const SplineFootprint::Node& node : spline.nodes()) {
    const auto found = kept_.find({lattice.level, node.j, node.i});
    if (found == kept_.end()) {
      lacking.push_back(node);
    } else {
      found->second.last_use = uses_;
    }
  }
  return lacking;
}

double MixtureAtlas::missing_share(const Footprint& footprint) const {
  const SplineLattice lattice = SplineLattice::for_footprint(surface_.map(), footprint.covariance);
  const SplineFootprint spline(lattice, surface_.map(), reduced(footprint));
  return static_cast<double>(missing(lattice, spline).size()) / static_cast<double>(spline.nodes().size());
}

void MixtureAtlas::forget_until_it_fits(std::size_t more) {
  while (bytes_ + more > most_bytes_) {
    const auto oldest = std::min_element(
        kept_.begin(), kept_.end(), [](const auto& a, const auto& b) { return a.second.last_use < b.second.last_use; });
    if (oldest == kept_.end() || oldest->second.last_use == uses_) return;
    bytes_ -= oldest->second.block->bytes();
    kept_.erase(oldest);
  }
}

bool MixtureAtlas::build(const Footprint& footprint, JobControl& control) {
  if (!suits(footprint.covariance)) return false;
  const SplineLattice lattice = SplineLattice::for_footprint(surface_.map(), footprint.covariance);
  {
    const std::lock_guard lock(mutex_);
    ++uses_;
  }
  const std::vector<SplineFootprint::Node> nodes =
      missing(lattice, SplineFootprint(lattice, surface_.map(), reduced(footprint)));
  if (nodes.empty()) return true;

  const glm::dvec2 widening = widening_for(grid_, intrinsic_roughness_);
  const double variance = intrinsic_roughness_ * intrinsic_roughness_;
  const glm::dvec2 roughness{std::sqrt(variance + widening.x), std::sqrt(variance + widening.y)};
  WindowImages images(lattice, grid_, nodes);
  const MixtureLattice seeds(surface_.map(), settings_);
  CanvasPool canvases(grid_);
  const auto add_cell = [&](glm::i64vec2 cell) {
    const FlushToZero quick;
    const glm::dvec2 origin = glm::dvec2(cell) * lattice.pitch;
    const glm::dvec2 end = glm::dvec2(cell + glm::i64vec2(1)) * lattice.pitch;
    const MixtureFrame frame(
        surface_, settings_,
        {seeds_between(origin.x, end.x, seeds.step.x), seeds_between(origin.y, end.y, seeds.step.y)}, origin, roughness,
        MixturePndf::k_image_cut);
    MixtureRows rows(frame);
    ElementList row;
    std::unique_ptr<WindowCanvas> canvas = canvases.take();
    for (std::int64_t l = frame.rows().first; l <= frame.rows().last && !control.cancelled(); ++l) {
      row.count = 0;
      rows.append(l, row);
      const double v = (static_cast<double>(l) + 0.5) * seeds.step.y;
      canvas->splat(row, lattice.pitch.x, cubic_b_splines((v - origin.y) / lattice.pitch.y));
    }
    for (std::size_t b = 0; b < 4; ++b) {
      for (std::size_t a = 0; a < 4; ++a) {
        WindowImage* image =
            images.at(cell.x - 1 + static_cast<std::int64_t>(a), cell.y - 1 + static_cast<std::int64_t>(b));
        if (image != nullptr) canvas->add_to(a, b, *image);
      }
    }
    canvases.give(std::move(canvas));
  };
  for (const std::vector<glm::i64vec2>& cells : images.cells()) {
    if (!parallel_blocks(cells.size(), control, [&](std::size_t k) { add_cell(cells[k]); })) return false;
  }

  // What the joint cut leaves out of every element alike.
  const double half = 0.5 * MixturePndf::k_image_cut * MixturePndf::k_image_cut;
  const auto factor = static_cast<float>(1 / ((1 - std::exp(-half)) * lattice.pitch.x * lattice.pitch.y));
  std::vector<std::shared_ptr<const AtlasBlock>> blocks(nodes.size());
  const auto pack = [&](std::size_t k) {
    blocks[k] = std::make_shared<const AtlasBlock>(*images.at(nodes[k].i, nodes[k].j), grid_.rows, factor);
  };
  if (!parallel_blocks(nodes.size(), control, pack)) return false;
  std::size_t more = 0;
  for (const auto& block : blocks) more += block->bytes();
  const std::lock_guard lock(mutex_);
  forget_until_it_fits(more);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    kept_.insert_or_assign({lattice.level, nodes[k].j, nodes[k].i}, Kept{blocks[k], uses_});
  }
  bytes_ += more;
  return true;
}

std::vector<MixtureAtlas::Part> MixtureAtlas::parts(const SplineLattice& lattice, const SplineFootprint& spline) const {
  const std::lock_guard lock(mutex_);
  std::vector<Part> found;
  for (const SplineFootprint::Node& node : spline.nodes()) {
    const auto block = kept_.find({lattice.level, node.j, node.i});
    if (block == kept_.end()) return {};
    found.push_back({block->second.block, node.weight});
  }
  return found;
}

std::optional<PndfImage> MixtureAtlas::image(const Footprint& footprint) const {
  if (!suits(footprint.covariance)) return std::nullopt;
  const SplineLattice lattice = SplineLattice::for_footprint(surface_.map(), footprint.covariance);
  const SplineFootprint spline(lattice, surface_.map(), reduced(footprint));
  const std::vector<Part> found = parts(lattice, spline);
  if (found.empty()) return std::nullopt;
  WindowImage sum(grid_);
  for (const Part& part : found) add_block(*part.block, static_cast<float>(part.weight), sum);
  PndfImage image;
  image.grid = grid_;
  image.widening = widening_for(grid_, intrinsic_roughness_);
  image.density.resize(grid_.cells());
  for (int r = 0; r < grid_.rows; ++r) {
    const float* from = sum.density.data() + r * sum.stride;
    std::copy(from, from + grid_.columns, image.density.begin() + static_cast<std::ptrdiff_t>(grid_.index(0, r)));
  }
  image.answer.text = "atlas";
  image.error = {spline.bound() + k_half_error + k_dropped_share, std::nullopt};
  return image;
}

std::size_t MixtureAtlas::bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

std::size_t MixtureAtlas::blocks() const {
  const std::lock_guard lock(mutex_);
  return kept_.size();
}

}  // namespace glint
