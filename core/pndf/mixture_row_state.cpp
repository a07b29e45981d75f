#include "core/pndf/mixture_row_state.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/pndf/exact_query.h"
#include "core/pndf/mixture_cells.h"

namespace glint {
namespace {

constexpr double k_uniform = 0.81;     // squared deviations over the squared side: exp(-2 pi^2 0.81) = 1e-7 is left
constexpr std::size_t k_padding = 32;  // vectors reach beyond the last seed and its texels

SymmetricMatrix2 plus_identity(const SymmetricMatrix2& m, double amount) {
  return {m.xx + amount, m.xy, m.yy + amount};
}

double squared_side(const NormalMap& map) {
  const double side = std::max(map.width(), map.height());
  return side * side;
}

// h for which seeds stand at the same places of every texel, or 0.
std::int64_t seeds_per_texel(double step) {
  const double seeds = 1 / step;
  const double whole = std::round(seeds);
  return whole >= 1 && std::abs(seeds - whole) < 1e-9 ? static_cast<std::int64_t>(whole) : 0;
}

void resize(SeedRun& run, std::size_t size) {
  run.texel.resize(size);
  run.offset.resize(size);
  for (auto* weights : {&run.value, &run.slope, &run.bend}) {
    for (std::vector<float>& of_tap : *weights) of_tap.resize(size);
  }
}

}  // namespace

MixtureFrame::MixtureFrame(const Surface& surface, const MixtureSettings& settings, const Footprint& of,
                           glm::dvec2 normal_roughness, double joint_cut)
    : map(&surface.map()),
      piecewise_constant(surface.interpolation() == Interpolation::constant),
      elements(settings.elements),
      lattice(surface.map(), settings),
      merge_bound(settings.merge_bound),
      center(of.center),
      roughness(normal_roughness),
      cut(joint_cut),
      footprint(of.covariance),
      widened(plus_identity(of.covariance, lattice.deviation * lattice.deviation)),
      uniform(surface.map().wrap() == Wrap::repeat &&
              eigenvalues(of.covariance).y >= k_uniform * squared_side(surface.map())),
      whitening(glint::whitening(widened)) {
  const double squared = lattice.deviation * lattice.deviation;
  if (uniform) {
    whitening = {0, 0, 0};
    drift = {0, 0, 0};
    spread = {lattice.deviation, 0, lattice.deviation};
    weight = lattice.area() / (2 * std::numbers::pi * map->width() * map->height());
    return;
  }
  // det V and Sigma_e in terms that do not cancel.
  const double own = determinant(footprint);
  const double whole = own + squared * (footprint.xx + footprint.yy + squared);
  const double share = squared / whole;
  drift = {share * widened.yy, -share * widened.xy, share * widened.xx};
  const double xx = share * (own + footprint.xx * squared);
  spread.l11 = std::sqrt(xx);
  spread.l21 = share * squared * footprint.xy / spread.l11;
  spread.l22 = squared * std::sqrt(own / whole) / spread.l11;
  weight = lattice.area() / (4 * std::numbers::pi * std::numbers::pi * std::sqrt(whole));
}

MixtureFrame::MixtureFrame(const Surface& surface, const MixtureSettings& settings, const SeedRectangle& seeds,
                           glm::dvec2 origin, glm::dvec2 normal_roughness, double joint_cut)
    : map(&surface.map()),
      piecewise_constant(surface.interpolation() == Interpolation::constant),
      elements(settings.elements),
      lattice(surface.map(), settings),
      merge_bound(settings.merge_bound),
      center(origin),
      roughness(normal_roughness),
      cut(joint_cut),
      footprint{1, 0, 1},
      widened{1, 0, 1},
      uniform(true),
      whitening{0, 0, 0},
      drift{0, 0, 0},
      spread{lattice.deviation, 0, lattice.deviation},
      weight(lattice.area() / (2 * std::numbers::pi)),
      rectangle(seeds) {}

namespace {

MixtureFrame::Seeds seeds_within(double center, double reach, double step) {
  return {static_cast<std::int64_t>(std::ceil((center - reach) / step - 0.5)),
          static_cast<std::int64_t>(std::floor((center + reach) / step - 0.5))};
}

// Those of one period.
MixtureFrame::Seeds all_seeds(int size, double step) {
  return {0, static_cast<std::int64_t>(std::round(size / step)) - 1};
}

}  // namespace

MixtureFrame::Seeds MixtureFrame::rows() const {
  if (rectangle) return rectangle->rows;
  if (uniform) return all_seeds(map->height(), lattice.step.y);
  return seeds_within(center.y, cut * std::sqrt(widened.yy), lattice.step.y);
}

MixtureFrame::Seeds MixtureFrame::columns() const {
  if (rectangle) return rectangle->columns;
  if (uniform) return all_seeds(map->width(), lattice.step.x);
  return seeds_within(center.x, cut * std::sqrt(widened.xx), lattice.step.x);
}

double MixtureFrame::elements_within() const {
  const double reached = uniform ? static_cast<double>(map->width()) * map->height()
                                 : std::numbers::pi * cut * cut * std::sqrt(determinant(widened));
  return reached / lattice.area();
}

bool MixtureFrame::sums_elements() const {
  if (std::min(roughness.x, roughness.y) < k_least_single_roughness) return false;
  if (uniform) return true;
  const double seeds = static_cast<double>(map->width()) * map->height() / lattice.area();
  return elements_within() <= 4 * seeds + 1e6 && suits_single_precision(FootprintWindow(widened), cut);
}

double MixtureFrame::kept() const {
  // Of the joint Gaussian in four dimensions, or of that in s alone.
  const double half = 0.5 * cut * cut;
  return 1 - std::exp(-half) * (uniform ? 1 : 1 + half);
}

MixtureRows::State::State(const MixtureFrame& of) : frame(of), window_(of.widened) {
  const auto [first, last] = frame.columns();
  add_seeds(first, last);
  for (CombinedRow& row : combined) {
    for (std::vector<float>* part : {&row.value, &row.slope, &row.bend}) part->resize(texel_count_);
  }
  for (KeptRow& row : kept_) {
    for (std::vector<float>& texels : row.texels) texels.resize(texel_count_);
  }
}

void MixtureRows::State::add_seeds(std::int64_t first, std::int64_t last) {
  if (first > last) return;
  const double step = frame.lattice.step.x;
  const auto weights_of = [&](std::int64_t seed) {
    return AxisStencil((static_cast<double>(seed) + 0.5) * step, frame.piecewise_constant);
  };
  first_texel_ = weights_of(first).first;
  texel_count_ = static_cast<std::size_t>(weights_of(last).first - first_texel_) + 4 + k_padding;
  const std::int64_t phases = std::max<std::int64_t>(seeds_per_texel(step), 1);
  for (std::int64_t phase = 0; phase < phases; ++phase) {
    SeedRun run{};
    run.contiguous = seeds_per_texel(step) > 0;
    resize(run, static_cast<std::size_t>((last - first) / phases + 1) + k_padding);
    for (std::int64_t seed = first + phase; seed <= last; seed += phases) {
      const AxisStencil weights = weights_of(seed);
      const std::size_t k = run.count++;
      run.texel[k] = static_cast<std::int32_t>(weights.first - first_texel_);
      run.offset[k] = static_cast<float>((static_cast<double>(seed) + 0.5) * step - frame.center.x);
      for (std::size_t tap = 0; tap < 4; ++tap) {
        run.value[tap][k] = static_cast<float>(weights.value[tap]);
        run.slope[tap][k] = static_cast<float>(weights.slope[tap]);
        run.bend[tap][k] = static_cast<float>(weights.bend[tap]);
      }
    }
    most_elements_ += run.count + k_padding;
    runs.push_back(std::move(run));
  }
}

std::optional<RowPlan> MixtureRows::State::plan(std::int64_t row) {
  const double v = (static_cast<double>(row) + 0.5) * frame.lattice.step.y;
  const double offset = frame.uniform ? 0 : v - frame.center.y;
  const std::optional<Interval> columns = window_.columns({offset, offset}, frame.cut);
  if (!columns) return std::nullopt;
  for (SeedRun& run : runs) {
    if (frame.uniform) {
      run.last = run.count;
      continue;
    }
    const auto begin = run.offset.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(run.count);
    run.first = static_cast<std::size_t>(std::lower_bound(begin, end, static_cast<float>(columns->lo)) - begin);
    run.last = static_cast<std::size_t>(std::upper_bound(begin, end, static_cast<float>(columns->hi)) - begin);
  }
  const AxisStencil weights(v, frame.piecewise_constant);
  const auto floats = [](const CubicWeights& w) {
    return std::array<float, 4>{static_cast<float>(w[0]), static_cast<float>(w[1]), static_cast<float>(w[2]),
                                static_cast<float>(w[3])};
  };
  return RowPlan{
      weights.first, {floats(weights.value), floats(weights.slope), floats(weights.bend)}, static_cast<float>(offset)};
}

const float* MixtureRows::State::texel_row(std::int64_t j, std::size_t axis) {
  KeptRow& kept = kept_[static_cast<std::size_t>(j & 3)];
  if (kept.row != j) {
    kept.row = j;
    for (std::size_t k = 0; k < texel_count_; ++k) {
      const glm::vec2 n = frame.map->texel(first_texel_ + static_cast<std::int64_t>(k), j);
      kept.texels[0][k] = n.x;
      kept.texels[1][k] = n.y;
    }
  }
  return kept.texels[axis].data();
}

}  // namespace glint
