#include "gui/jobs/pndf_jobs.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/document/names.h"
#include "core/document/parameter.h"
#include "core/document/preset.h"
#include "core/study/error_metrics.h"

namespace glint::gui {
namespace {

// Of the reference: enough to tell errors of a percent, and quickly there; its own error stands beside them.
constexpr ReferenceEffort k_effort{2e-3, 5};

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t k_coarse_samples = 100'000;  // of make_coarse_model

// On `interpolation`; which map lies under it plays no part.
std::string recipe_on(Document document, Interpolation interpolation) {
  document.surface = {};
  document.surface.interpolation = interpolation;
  return recipe_of(document);
}

// Whether a coarse picture has fewer cells than the full one.
bool coarse_is_quicker(const PndfGrid& grid) {
  return !(coarse_grid(grid) == grid);
}

// What a coarse picture is made of, on `surface`; see make_coarse_model.
std::string coarse_note(const Document& document, PndfMethod method, Interpolation surface, const PndfGrid& coarse) {
  std::string note = fmt::format("{}² cells", coarse.columns);
  if (method == PndfMethod::exact && surface == Interpolation::linear) note += ", 2 triangles";
  if (method == PndfMethod::automatic) note += ", h = 1";
  if (method == PndfMethod::binning && document.binning_samples > k_coarse_samples) {
    note += fmt::format(", {} k samples", k_coarse_samples / 1000);
  }
  return note;
}

std::vector<PictureIdentity> identities_of(const Document& document, const Surface& surface, const PndfGrid& grid) {
  std::vector<PictureIdentity> identities;
  for (const PndfMethod method : document.methods) {
    Document alone = document;
    alone.methods = {method};
    identities.push_back({surface.shared_map(), recipe_on(std::move(alone), surface.interpolation()), grid});
  }
  return identities;
}

// The mixture that a picture of the document comes from; auto's is that which answered last.
std::optional<MixtureSettings> mixture_of(const Document& document, const view::MethodPicture& picture) {
  if (picture.method == PndfMethod::mixture) return document.mixture;
  if (picture.method == PndfMethod::automatic && picture.image && picture.image->answer.step > 0) {
    return mixture_of_step(picture.image->answer.step);
  }
  return std::nullopt;
}

// A method of counts holds means over its cells and is held against such.
CellContent content_of(const PndfImage& image) {
  return image.standard_error.empty() ? CellContent::point : CellContent::mean;
}

}  // namespace

PndfJobs::PndfJobs(const std::function<void()>& wake, ErrorInbox& errors)
    : errors_(errors), wake_(wake), job_(wake, errors) {}

void PndfJobs::request(const Document& document, const std::shared_ptr<const view::SurfaceInUse>& surface,
                       std::uint64_t revision) {
  RequestIdentity identity{surface->loaded.surface.shared_map(),
                           recipe_on(document, surface->loaded.surface.interpolation())};
  const bool same = requested_ == identity;
  if (!same) ++requests_;
  PictureBoard::Label label{requests_, revision, document};
  board_.announce(label);
  if (same) return;
  requested_ = std::move(identity);
  job_.start([this, label = std::move(label), surface](JobSteps& steps) {
    try {
      compute(label, surface, steps);
    } catch (...) {
      board_.end();
      throw;
    }
    if (!steps.superseded()) board_.end();
  });
}

void PndfJobs::poll() {
  job_.poll();
  const JobStatus status = job_.status();
  if (status.method) board_.set_progress(*status.method, status.progress);
}

void PndfJobs::compute(PictureBoard::Label label, const std::shared_ptr<const view::SurfaceInUse>& surface,
                       JobSteps& steps) {
  const Document document = label.document;
  steps.spare_until(Clock::now() + k_first_pictures_time);
  const PndfGrid grid = document_grid(document, surface->loaded.surface);
  if (report_fault(document, surface->loaded.surface, grid)) return;
  const ReferenceIdentity reference{surface->loaded.surface.shared_map(), surface->loaded.surface.interpolation(),
                                    document.intrinsic_roughness, document.footprint, grid};
  board_.begin({std::move(label), surface, grid, identities_of(document, surface->loaded.surface, grid),
                shown_reference(reference)});
  wake_();
  const Run run{document, surface, grid, steps};
  compute_first_pictures(run);
  steps.end_sparing();
  compute_full_pictures(run);
  prepare_atlas(run);
  compute_errors(run);
}

bool PndfJobs::report_fault(const Document& document, const Surface& surface, const PndfGrid& grid) {
  std::optional<Error> fault = document_fault(document);
  if (!fault) fault = footprint_position_fault(document.footprint, surface.map());
  if (!fault) {
    if (const std::optional<std::string> why = grid_fault(grid)) fault = request_error("grid.window", *why);
  }
  // A drag along what cannot be is one error and not a hundred.
  if (fault && (!last_fault_ || last_fault_->message() != fault->message())) errors_.post(*fault);
  last_fault_ = std::move(fault);
  return last_fault_.has_value();
}

void PndfJobs::compute_first_pictures(const Run& run) {
  const bool coarse = coarse_is_quicker(run.grid);
  for (std::size_t k = 0; k < run.document.methods.size() && !run.steps.cancelled(); ++k) {
    if (!board_.has_picture(k)) compute_picture(run, k, coarse);
  }
}

void PndfJobs::compute_full_pictures(const Run& run) {
  for (std::size_t k = 0; k < run.document.methods.size() && !run.steps.cancelled(); ++k) {
    if (!board_.has_full_picture(k)) compute_picture(run, k, false);
  }
}

// While the document is left alone: the next footprints are looked up.
void PndfJobs::prepare_atlas(const Run& run) {
  for (std::size_t k = 0; k < run.document.methods.size() && !run.steps.cancelled(); ++k) {
    const view::MethodPicture picture = board_.picture(k);
    const std::optional<MixtureSettings> settings = mixture_of(run.document, picture);
    if (!settings) continue;
    atlas_.prepare(run.document, *settings, run.surface->loaded.surface, run.grid, run.steps);
    return;
  }
}

void PndfJobs::compute_picture(const Run& run, std::size_t index, bool coarse) {
  const PndfMethod method = run.document.methods[index];
  const Surface& surface = run.surface->loaded.surface;
  JobControl& control = run.steps.begin(std::string(method_title(method)), method);
  std::shared_ptr<const MixtureAtlas> atlas;
  if (const auto settings = mixture_of(run.document, board_.picture(index)); settings) {
    atlas = atlas_.for_picture(run.document, *settings, surface, run.grid, control);
  }
  if (atlas) coarse = false;  // the full picture is there at once
  const std::unique_ptr<PndfModel> model = coarse ? make_coarse_model(run.document, method, surface)
                                                  : make_document_model(run.document, method, surface, atlas);
  const PndfGrid grid = coarse ? coarse_grid(run.grid) : run.grid;
  const Clock::time_point began = Clock::now();
  std::optional<PndfImage> image = model->image(run.document.footprint, grid, control);
  const std::chrono::duration<double, std::milli> elapsed = Clock::now() - began;
  if (!image || run.steps.cancelled()) return;
  view::MethodPicture picture;
  picture.method = method;
  picture.image = std::make_shared<const PndfImage>(std::move(*image));
  picture.coarse = coarse;
  picture.surface = model->info().surface;
  if (coarse) picture.coarse_note = coarse_note(run.document, method, picture.surface, grid);
  picture.findings = unreported_sentences(document_findings(run.document, method, surface), run.surface->loaded.report,
                                          run.document.intrinsic_roughness);
  picture.milliseconds = elapsed.count();
  board_.set_picture(index, std::move(picture));
  wake_();
}

void PndfJobs::compute_errors(const Run& run) {
  for (std::size_t k = 0; k < run.document.methods.size() && !run.steps.cancelled(); ++k) {
    const view::MethodPicture picture = board_.picture(k);
    const std::shared_ptr<const ReferenceImage> reference =
        reference_for(run, picture.surface, content_of(*picture.image), picture.method);
    if (!reference) return;
    if (picture.errors) continue;
    // Against a window that holds none of the P-NDF there is no relative error.
    const bool has_mass = integral(reference->image) > 0;
    board_.set_errors(k, has_mass ? std::optional(compare(*picture.image, reference->image)) : std::nullopt,
                      reference->own_error, {reference, &reference->image});
    wake_();
  }
}

std::shared_ptr<const ReferenceImage> PndfJobs::reference_for(const Run& run, Interpolation interpolation,
                                                              CellContent content, PndfMethod method) {
  const Surface surface(run.surface->loaded.surface.shared_map(), interpolation);
  const ReferenceIdentity identity{surface.shared_map(), interpolation, run.document.intrinsic_roughness,
                                   run.document.footprint, run.grid};
  std::erase_if(references_, [&](const KeptReference& kept) { return !(kept.identity.on(interpolation) == identity); });
  const auto same_surface = [&](const KeptReference& kept) { return kept.identity == identity; };
  const auto known = std::find_if(references_.begin(), references_.end(), [&](const KeptReference& kept) {
    return same_surface(kept) && kept.content == content;
  });
  if (known != references_.end()) return known->reference;
  // That of the other content's need not be sought again. Means are held against counts, whose noise is larger than
  // what half the subdivision leaves: the change of the last step.
  std::optional<ReferenceRefinement> refinement;
  const auto other = std::find_if(references_.begin(), references_.end(), same_surface);
  if (other != references_.end()) refinement = other->reference->refinement;
  if (refinement && content == CellContent::mean) refinement->subdivision = std::max(4, refinement->subdivision / 2);
  JobControl& control = run.steps.begin("measuring the error of " + std::string(choice_name(method)));
  std::optional<ReferenceImage> made =
      reference_image(surface, run.document.intrinsic_roughness, run.document.footprint, run.grid, content, control,
                      refinement, k_effort);
  if (!made || run.steps.cancelled()) return nullptr;
  auto reference = std::make_shared<const ReferenceImage>(std::move(*made));
  references_.push_back({identity, content, reference});
  board_.set_reference(shown_reference(identity.on(run.surface->loaded.surface.interpolation())));
  wake_();
  return reference;
}

// The one of values at points, where there is one: pictures are looked at point by point.
std::shared_ptr<const PndfImage> PndfJobs::shown_reference(const ReferenceIdentity& identity) const {
  std::shared_ptr<const PndfImage> shown;
  for (const KeptReference& kept : references_) {
    if (!(kept.identity == identity) || (shown && kept.content == CellContent::mean)) continue;
    shown = {kept.reference, &kept.reference->image};
  }
  return shown;
}

}  // namespace glint::gui
