#include "gui/jobs/document_jobs.h"

#include <utility>

#include "core/document/preset.h"

namespace glint::gui {

DocumentJobs::DocumentJobs(std::function<void()> wake)
    : wake_(std::move(wake)),
      open_(wake_, errors_),
      surface_(wake_, errors_),
      pndf_(wake_, errors_),
      check_(wake_, errors_) {}

DocumentJobs::~DocumentJobs() {
  // All of them, before the first is waited for.
  open_.cancel();
  surface_.cancel();
  pndf_.cancel();
  check_.cancel();
}

void DocumentJobs::update(const Document& document, std::uint64_t revision) {
  bool ask_surface = surface_.has_offer();
  if (!document_ || revision != revision_) {
    std::string recipe = recipe_of(document);
    const bool differs = !document_ || recipe != recipe_ || document.surface.path != document_->surface.path;
    document_ = document;
    revision_ = revision;
    recipe_ = std::move(recipe);
    pictures_wanted_ = true;
    ask_surface = ask_surface || differs;
    if (ask_surface) surface_.request(document.surface);
    if (differs && cancelled_) begin_again();
    if (differs) check_.cancel();
  } else if (ask_surface) {
    surface_.request(document.surface);
  }
  surface_.offer(nullptr);  // one of another document has come to nothing
  surface_.poll();
  ask_for_pictures();
  pndf_.poll();
}

void DocumentJobs::ask_for_pictures() {
  if (!surface_.settled()) {
    pndf_.cancel();
    pndf_.forget_request();
    pictures_wanted_ = true;
    return;
  }
  const std::shared_ptr<const view::SurfaceInUse>& surface = surface_.in_use();
  if (!surface || (!pictures_wanted_ && surface == asked_surface_)) return;
  Document document = *document_;
  if (surface_.error()) document.surface = surface->description;
  pndf_.request(document, surface, revision_);
  asked_surface_ = surface;
  pictures_wanted_ = false;
}

void DocumentJobs::open(std::filesystem::path file) {
  open_.open(std::move(file), document_.value_or(Document()));
}

std::optional<Opened> DocumentJobs::take_opened() {
  std::optional<OpenedFile> file = open_.take();
  if (!file) return std::nullopt;
  surface_.offer(std::move(file->surface));
  return std::move(file->opened);
}

JobStatus DocumentJobs::status() const {
  if (JobStatus status = open_.status(); status.busy) return status;
  if (cancelled_) return {};  // what has been cancelled may still be on its way out
  if (JobStatus status = surface_.status(); status.busy) return status;
  if (JobStatus status = pndf_.status(); status.busy) return status;
  return check_.status();
}

bool DocumentJobs::idle() const {
  return open_.idle() && surface_.idle() && pndf_.idle() && check_.idle();
}

void DocumentJobs::cancel() {
  if (!surface_.idle() || !pndf_.idle()) cancelled_ = true;
  open_.cancel();
  surface_.cancel();
  pndf_.cancel();
  check_.cancel();
}

void DocumentJobs::begin_again() {
  cancelled_ = false;
  surface_.restart();
  pndf_.forget_request();
  pictures_wanted_ = true;
}

void DocumentJobs::restart() {
  if (!cancelled_) return;
  begin_again();
  ask_for_pictures();
}

void DocumentJobs::reload_surface() {
  if (!document_) return;
  cancelled_ = false;
  surface_.reload();
  ask_for_pictures();
}

}  // namespace glint::gui
