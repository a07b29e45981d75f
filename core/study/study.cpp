#include "core/study/study.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <utility>

#include "core/study/error_metrics.h"
#include "core/study/reference.h"

namespace glint {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

struct QueryTime {
  double mean_us = 0;
  std::size_t count = 0;
};

// Queries one by one, as a renderer asks them.
QueryTime time_queries(const FootprintPndf& pndf, const std::vector<glm::dvec2>& normals, double seconds,
                       const JobControl& control) {
  std::size_t done = 0;
  const Clock::time_point begin = Clock::now();
  while (done < normals.size() && !control.cancelled() && milliseconds_since(begin) < 1000 * seconds) {
    double density = 0;
    pndf.evaluate({&normals[done], 1}, {&density, 1});
    ++done;
  }
  return {1000 * milliseconds_since(begin) / static_cast<double>(std::max<std::size_t>(done, 1)), done};
}

std::vector<glm::dvec2> lobe_normals(const FootprintPndf& pndf, std::uint64_t seed) {
  RandomStream random(seed, 0x517e);
  std::vector<glm::dvec2> normals(k_study_queries);
  for (glm::dvec2& s : normals) s = pndf.sample(random);
  return normals;
}

std::vector<glm::dvec2> window_normals(const PndfGrid& grid, std::uint64_t seed) {
  RandomStream random(seed, 0x517f);
  std::vector<glm::dvec2> normals(k_study_queries);
  for (glm::dvec2& s : normals) {
    const double x = random.next_uniform();
    const double y = random.next_uniform();
    s = {grid.s_min + x * (grid.s_max - grid.s_min), grid.t_min + y * (grid.t_max - grid.t_min)};
  }
  return normals;
}

// Builds, times and asks one method; its image is left in `image` for the errors.
std::optional<StudyResult> time_method(const Document& document, PndfMethod method, const Surface& surface,
                                       const PndfGrid& grid, const StudySettings& settings, JobControl& control,
                                       PndfImage& image) {
  std::optional<ThreadLimit> limit;
  if (settings.threads) limit.emplace(std::min(*settings.threads, thread_count()));
  StudyResult result{};
  result.method = method;
  const Clock::time_point build = Clock::now();
  const std::unique_ptr<PndfModel> model = make_document_model(document, method, surface);
  result.build_ms = milliseconds_since(build);
  result.surface = model->info().surface;

  std::vector<double> times;
  for (int run = 0; run <= settings.repeats; ++run) {
    const Clock::time_point begin = Clock::now();
    std::optional<PndfImage> made = model->image(document.footprint, grid, control);
    if (!made) return std::nullopt;
    if (run > 0) times.push_back(milliseconds_since(begin));
    image = std::move(*made);
  }
  result.image_ms = median(times);

  PndfWorkspace workspace;
  const Clock::time_point prepare = Clock::now();
  const FootprintPndf& pndf = model->at(document.footprint, workspace);
  result.prepare_ms = milliseconds_since(prepare);
  const QueryTime lobe = time_queries(pndf, lobe_normals(pndf, document.seed), settings.query_seconds, control);
  const QueryTime window = time_queries(pndf, window_normals(grid, document.seed), settings.query_seconds, control);
  if (control.cancelled()) return std::nullopt;
  result.query_us = lobe.mean_us;
  result.query_count = lobe.count;
  result.query_uniform_us = window.mean_us;
  result.query_uniform_count = window.count;
  result.bytes = surface.map().bytes() + model->info().bytes;  // with what was built when it was first asked for
  result.answered_by = image.answer.text;
  result.own_noise = image.standard_error.empty() ? 0 : image.error.estimated.value_or(0);
  return result;
}

}  // namespace

Result<std::vector<StudyResult>> run_study(const Document& document, const Surface& surface,
                                           const StudySettings& settings, JobControl& control) {
  const Error cancelled = content_error("study", "cancelled");
  const PndfGrid grid = document_grid(document, surface);
  if (const auto fault = grid_fault(grid)) return request_error("grid.window", *fault);
  std::map<std::pair<Interpolation, CellContent>, ReferenceImage> references;
  std::vector<StudyResult> results;
  for (const PndfMethod method : document.methods) {
    PndfImage image;
    std::optional<StudyResult> result = time_method(document, method, surface, grid, settings, control, image);
    if (!result) return cancelled;
    // A method of counts holds means over its cells and is held against such.
    const CellContent content = image.standard_error.empty() ? CellContent::point : CellContent::mean;
    const std::pair wanted{settings.reference_surface.value_or(result->surface), content};
    if (!references.contains(wanted)) {
      const CellContent other = content == CellContent::point ? CellContent::mean : CellContent::point;
      const auto made_before = references.find({wanted.first, other});
      const auto known = made_before == references.end() ? std::nullopt : std::optional(made_before->second.refinement);
      std::optional<ReferenceImage> made =
          reference_image(Surface(surface.shared_map(), wanted.first), document.intrinsic_roughness, document.footprint,
                          grid, content, control, known);
      if (!made) return cancelled;
      references.emplace(wanted, std::move(*made));
    }
    const ReferenceImage& reference = references.at(wanted);
    if (!(integral(reference.image) > 0)) {
      return content_error("study", "the window holds none of the P-NDF: there is nothing to compare with");
    }
    const PndfErrors errors = compare(image, reference.image);
    result->reference = {reference.surface, reference.own_error};
    result->relative_l1 = errors.relative_l1;
    result->peak_error = errors.peak_error;
    result->energy_error = errors.energy_error;
    results.push_back(*result);
  }
  return results;
}

}  // namespace glint
