#include "core/pndf/auto_pndf.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/math/gaussian.h"
#include "core/pndf/fast_exact_pndf.h"
#include "core/pndf/mixture_rows.h"

namespace glint {
namespace {

constexpr std::size_t k_lean = AutoPndf::k_steps.size();
constexpr std::size_t k_exact = k_lean + 1;
constexpr std::size_t k_unknown = k_lean + 2;
constexpr std::size_t k_normals = 64;         // drawn from each of two methods that are compared
constexpr std::size_t k_footprints = 8;       // within one that is wider than k_probed_deviation
constexpr double k_deviations = 2;            // of the estimate, added to it
constexpr double k_image_cut_share = 1.5e-3;  // of the mass, which the cut of a mixture's images moves
constexpr double k_most_elements = 3e6;       // of a mixture that a whole footprint's LEAN is held against

constexpr std::array<std::string_view, AutoPndf::k_steps.size()> k_step_names{"2", "1", "0.5", "0.25"};

struct Estimate {
  double mean = 0;
  double variance = 0;  // of the mean
  [[nodiscard]] double upper() const { return mean + k_deviations * std::sqrt(variance); }
};

// What the chosen method prepared, under the error that the choice knows.
class AutoFootprint final : public FootprintPndf {
 public:
  AutoFootprint(const PndfModel& model, const Footprint& footprint, double estimated)
      : pndf_(model.at(footprint, workspace_)), error_{pndf_.error().bounded, estimated} {}

  void evaluate(std::span<const glm::dvec2> s, std::span<double> density) const override { pndf_.evaluate(s, density); }
  [[nodiscard]] glm::dvec2 sample(RandomStream& random) const override { return pndf_.sample(random); }
  [[nodiscard]] double pdf(glm::dvec2 s) const override { return pndf_.pdf(s); }
  [[nodiscard]] PndfError error() const override { return error_; }
  void expect_queries(std::size_t count) const override { pndf_.expect_queries(count); }

 private:
  PndfWorkspace workspace_;
  const FootprintPndf& pndf_;
  PndfError error_;
};

// A method on one footprint with normals drawn from it.
class Probe {
 public:
  Probe(const PndfModel& model, const Footprint& footprint, RandomStream& random, std::size_t normals)
      : pndf_(model.at(footprint, workspace_)), normals_(normals) {
    for (glm::dvec2& s : normals_) s = pndf_.sample(random);
  }

  [[nodiscard]] const std::vector<glm::dvec2>& normals() const { return normals_; }
  [[nodiscard]] std::vector<double> at(const std::vector<glm::dvec2>& s) const {
    std::vector<double> density(s.size());
    pndf_.evaluate(s, density);
    return density;
  }

 private:
  PndfWorkspace workspace_;
  const FootprintPndf& pndf_;
  std::vector<glm::dvec2> normals_;
};

// The L1 distance of two densities from equally many normals of each: of |a - b| over their mean, (a + b) / 2.
Estimate distance(const Probe& a, const Probe& b) {
  double sum = 0;
  double squares = 0;
  std::size_t count = 0;
  for (const std::vector<glm::dvec2>* normals : {&a.normals(), &b.normals()}) {
    const std::vector<double> of_a = a.at(*normals);
    const std::vector<double> of_b = b.at(*normals);
    for (std::size_t k = 0; k < normals->size(); ++k) {
      const double both = of_a[k] + of_b[k];
      const double share = both > 0 ? 2 * std::abs(of_a[k] - of_b[k]) / both : 0;
      sum += share;
      squares += share * share;
      ++count;
    }
  }
  const auto n = static_cast<double>(count);
  const double mean = sum / n;
  return {mean, std::max(0.0, squares / n - mean * mean) / n};
}

// The footprint, or narrower ones whose mixture it is.
std::vector<Footprint> probed_footprints(const Footprint& footprint, RandomStream& random) {
  constexpr double k_variance = AutoPndf::k_probed_deviation * AutoPndf::k_probed_deviation;
  const SymmetricMatrix2& whole = footprint.covariance;
  if (eigenvalues(whole).x <= k_variance) return {footprint};
  // Along the axes of the ellipse, at most k_probed_deviation each.
  const glm::dvec2 values = eigenvalues(whole);
  const double angle = 0.5 * std::atan2(2 * whole.xy, whole.xx - whole.yy);
  const glm::dvec2 axis{std::cos(angle), std::sin(angle)};
  const double wide = std::min(values.x, k_variance);
  const double narrow = std::min(values.y, k_variance);
  const SymmetricMatrix2 part{wide * axis.x * axis.x + narrow * axis.y * axis.y, (wide - narrow) * axis.x * axis.y,
                              wide * axis.y * axis.y + narrow * axis.x * axis.x};
  std::vector<Footprint> parts(k_footprints);
  for (Footprint& one : parts) {
    std::array<double, 2> xi{};
    random.fill_normal(xi);
    const double along = xi[0] * std::sqrt(values.x - wide);
    const double across = xi[1] * std::sqrt(values.y - narrow);
    one = {footprint.center + along * axis + across * glm::dvec2(-axis.y, axis.x), part};
  }
  return parts;
}

// Of two methods over the probed footprints, each of which has its share of the normals.
class Comparison {
 public:
  explicit Comparison(const Footprint& footprint)
      : random_(0x61757f, 0), parts_(probed_footprints(footprint, random_)) {}

  // Remembers what it drew from `finer`, which the next call mostly has as its coarser one.
  Estimate operator()(const PndfModel& coarser, const PndfModel& finer) {
    std::vector<std::unique_ptr<Probe>> coarse = last_model_ == &coarser ? std::move(last_) : probes_of(coarser);
    last_ = probes_of(finer);
    last_model_ = &finer;
    Estimate total;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      const Estimate one = distance(*coarse[k], *last_[k]);
      total.mean += one.mean / static_cast<double>(parts_.size());
      squares_ += one.mean * one.mean;
      total.variance += one.variance / static_cast<double>(parts_.size() * parts_.size());
    }
    // The parts differ besides.
    const double mean_square = std::exchange(squares_, 0) / static_cast<double>(parts_.size());
    total.variance = std::max(
        total.variance, std::max(0.0, mean_square - total.mean * total.mean) / static_cast<double>(parts_.size()));
    return total;
  }

 private:
  std::vector<std::unique_ptr<Probe>> probes_of(const PndfModel& model) {
    std::vector<std::unique_ptr<Probe>> probes;
    const std::size_t normals = std::max<std::size_t>(k_normals / parts_.size(), 16);
    probes.reserve(parts_.size());
    for (const Footprint& part : parts_) probes.push_back(std::make_unique<Probe>(model, part, random_, normals));
    return probes;
  }

  RandomStream random_;
  std::vector<Footprint> parts_;
  const PndfModel* last_model_ = nullptr;
  std::vector<std::unique_ptr<Probe>> last_;
  double squares_ = 0;
};

std::size_t index_of(double step) {
  return static_cast<std::size_t>(std::find(AutoPndf::k_steps.begin(), AutoPndf::k_steps.end(), step) -
                                  AutoPndf::k_steps.begin());
}

}  // namespace

std::string AutoChoice::text() const {
  switch (answer) {
    case Answer::lean:
      return "LEAN";
    case Answer::mixture:
      return std::string("mixture, h = ").append(k_step_names[index_of(step)]);
    case Answer::exact:
      break;
  }
  return "exact";
}

// Exact evaluation of 32 triangles a texel: with shifted vertices, which answers, and without, which that is held
// against. On other surfaces than the smooth one they are one.
struct AutoPndf::Exact {
  FastExactPndf shifted;
  FastExactPndf plain;
  bool is_one;

  Exact(const Surface& surface, double roughness)
      : shifted(surface, roughness, with_shift(surface)),
        plain(surface, roughness),
        is_one(surface.interpolation() != Interpolation::smooth) {}

 private:
  static ExactSettings with_shift(const Surface& surface) {
    ExactSettings settings;
    settings.vertex_shift = surface.interpolation() == Interpolation::smooth;
    return settings;
  }
};

AutoPndf::AutoPndf(const Surface& surface, double intrinsic_roughness, const AutoSettings& settings,
                   std::shared_ptr<const MixtureAtlas> atlas)
    : surface_(MixturePndf::modelled(surface)),
      intrinsic_roughness_(intrinsic_roughness),
      settings_(settings),
      lean_(surface_, intrinsic_roughness),
      atlas_(std::move(atlas)) {
  for (std::size_t k = 0; k < k_steps.size(); ++k) {
    MixtureSettings of_step = mixture_of_step(k_steps[k]);
    of_step.merge_bound = std::min(of_step.merge_bound, merging_share());
    mixtures_[k] = std::make_unique<const MixturePndf>(surface_, intrinsic_roughness_, of_step);
  }
}

AutoPndf::~AutoPndf() = default;

const AutoPndf::Exact& AutoPndf::exact() const {
  std::call_once(exact_built_, [this] {
    exact_ = std::make_unique<const Exact>(surface_, intrinsic_roughness_);
    exact_bytes_ = exact_->shifted.info().bytes + exact_->plain.info().bytes;
  });
  return *exact_;
}

PndfModelInfo AutoPndf::info() const {
  std::size_t bytes = lean_.info().bytes + exact_bytes_;
  for (const auto& mixture : mixtures_) bytes += mixture->info().bytes;
  return {"auto", surface_.interpolation(),
          "within its tolerance by its own estimate; where that is not met it says so", bytes};
}

AutoChoice AutoPndf::choose(const Footprint& footprint, const JobControl& control) const {
  using Answer = AutoChoice::Answer;
  const double tolerance = settings_.tolerance;
  // What is left for a mixture's elements: its images are cut and merge besides.
  const double of_elements = tolerance - k_image_cut_share - 2 * merging_share();
  // LEAN, against a mixture that is itself near enough: the whole footprint, of which it makes one Gaussian.
  std::optional<double> lean_step;
  Estimate of_lean;
  for (const std::size_t k : {index_of(0.5), index_of(1), index_of(2)}) {
    if (elements_within(footprint, k_steps[k]) > k_most_elements) continue;
    RandomStream random(0x6c65616e, 0);
    of_lean = distance(Probe(lean_, footprint, random, k_normals), Probe(*mixtures_[k], footprint, random, k_normals));
    if (of_lean.upper() <= tolerance) lean_step = k_steps[k];
    break;
  }
  // A first-order method of step h is off by d / (2^p - 1) more than one of 2 h, d their distance: of order p = 2 even
  // where corrected elements reach more, 1 where normals jump.
  const double order_gain = surface_.interpolation() == Interpolation::constant ? 2 : 4;
  Comparison compare(footprint);
  for (std::size_t k = 0; k + 1 < k_steps.size() && !control.cancelled(); ++k) {
    const double apart = compare(*mixtures_[k], *mixtures_[k + 1]).upper();
    const double of_coarser = apart * order_gain / (order_gain - 1);
    const double of_finer = 2 * apart / (order_gain - 1);  // not yet where the order is reached: twice
    const bool coarser_does = of_coarser <= of_elements;
    if (!coarser_does && of_finer > of_elements) continue;
    const double step = k_steps[coarser_does ? k : k + 1];
    const double off = coarser_does ? of_coarser : of_finer;
    const double of_both = of_lean.upper() + off;
    if (lean_step && *lean_step <= step && of_both <= tolerance) return {Answer::lean, 0, of_both, true};
    return {Answer::mixture, step, off + k_image_cut_share, true};
  }
  if (control.cancelled()) return {};
  // Shifting vertices leaves less than an eighth of what it moves: measured, some fiftieth on smooth maps.
  const double off = exact().is_one ? 0 : compare(exact().plain, exact().shifted).upper() / 8;
  if (control.cancelled()) return {};
  const double of_finest = compare(exact().shifted, *mixtures_.back()).upper() + off;
  if (of_finest <= of_elements) return {Answer::mixture, k_steps.back(), of_finest + k_image_cut_share, true};
  return {Answer::exact, 0, off, off <= tolerance};
}

double AutoPndf::merging_share() const {
  return settings_.tolerance / 40;
}

double AutoPndf::elements_within(const Footprint& footprint, double step) const {
  const MixtureFrame frame(surface_, mixture_of_step(step), footprint, glm::dvec2(intrinsic_roughness_),
                           MixturePndf::k_query_cut);
  return frame.elements_within();
}

const PndfModel& AutoPndf::model_of(const AutoChoice& choice) const {
  switch (choice.answer) {
    case AutoChoice::Answer::lean:
      return lean_;
    case AutoChoice::Answer::mixture:
      return *mixtures_[index_of(choice.step)];
    case AutoChoice::Answer::exact:
      break;
  }
  return exact().shifted;
}

FootprintPndf& AutoPndf::at(const Footprint& footprint, PndfWorkspace& workspace) const {
  const AutoChoice choice = choose(footprint);
  count(choice);
  return workspace.emplace<AutoFootprint>(model_of(choice), footprint, choice.estimated);
}

std::optional<PndfImage> AutoPndf::looked_up(const AutoChoice& choice, const Footprint& footprint,
                                             const PndfGrid& grid) const {
  if (!atlas_ || choice.answer != AutoChoice::Answer::mixture) return std::nullopt;
  if (!atlas_->is_of(surface_, intrinsic_roughness_, mixture_of_step(choice.step), grid)) return std::nullopt;
  std::optional<PndfImage> image = atlas_->image(footprint);
  if (image && image->error.bounded + choice.estimated > settings_.tolerance) return std::nullopt;
  return image;
}

std::optional<PndfImage> AutoPndf::image(const Footprint& footprint, const PndfGrid& grid, JobControl& control) const {
  const AutoChoice choice = choose(footprint, control);
  if (control.cancelled()) return std::nullopt;
  std::optional<PndfImage> image = looked_up(choice, footprint, grid);
  if (!image) image = model_of(choice).image(footprint, grid, control);
  if (!image) return image;
  count(choice);
  image->error.estimated = choice.estimated;
  const std::string where = image->answer.text.empty() ? "" : ", " + image->answer.text;
  image->answer = {choice.text() + where, choice.step, choice.known && *image->error.total() <= settings_.tolerance};
  return image;
}

void AutoPndf::count(const AutoChoice& choice) const {
  const auto add = [&](std::size_t to) { counts_[to].fetch_add(1, std::memory_order_relaxed); };
  switch (choice.answer) {
    case AutoChoice::Answer::lean:
      add(k_lean);
      return;
    case AutoChoice::Answer::mixture:
      add(index_of(choice.step));
      return;
    case AutoChoice::Answer::exact:
      add(k_exact);
      if (!choice.known) add(k_unknown);
  }
}

AutoPndf::Statistics AutoPndf::statistics() const {
  const auto of = [&](std::size_t from) { return counts_[from].load(std::memory_order_relaxed); };
  Statistics statistics{of(k_lean), {}, of(k_exact), of(k_unknown)};
  for (std::size_t k = 0; k < k_steps.size(); ++k) statistics.mixture[k] = of(k);
  return statistics;
}

}  // namespace glint
