#include "gui/jobs/open_jobs.h"

#include <exception>
#include <utility>

#include "core/document/parameter.h"
#include "core/document/preset.h"
#include "core/image/pndf_exr.h"

namespace glint::gui {
namespace {

Document with_map(Document document, const std::filesystem::path& file) {
  document.name = file.stem().string();
  document.surface.source = SurfaceSource::file;
  document.surface.path = file;
  document.surface.reading = {};
  document.surface.interpolation.reset();
  return document;
}

bool holds_document(const std::filesystem::path& file) {
  return file.extension() == ".json" || (file.extension() == ".exr" && read_recipe(file));
}

void bring_inside(Footprint& footprint, const NormalMap& map) {
  const glm::dvec2 c = footprint.center;
  if (c.x >= 0 && c.y >= 0 && c.x <= map.width() && c.y <= map.height()) return;
  footprint.center = {0.5 * map.width(), 0.5 * map.height()};
}

}  // namespace

Result<OpenedFile> open_file(const std::filesystem::path& file, const Document& current, JobControl& control) {
  const bool is_document = holds_document(file);
  Result<Document> document = is_document ? load_document(file) : with_map(current, file);
  if (!document) return document.error();
  Result<std::shared_ptr<const view::SurfaceInUse>> surface = load_surface_in_use(document->surface, control);
  if (!surface) return surface.error();
  if (!is_document) bring_inside(document->footprint, (*surface)->loaded.surface.map());
  if (std::optional<Error> fault = document_fault(*document)) return *std::move(fault);
  return OpenedFile{{std::move(*document), "Open " + file.filename().string()}, std::move(*surface)};
}

OpenJobs::OpenJobs(const std::function<void()>& wake, ErrorInbox& errors) : errors_(errors), job_(wake, errors) {}

void OpenJobs::open(std::filesystem::path file, Document current) {
  cancel();
  job_.start([this, file = std::move(file), current = std::move(current)](JobSteps& steps) {
    JobControl& control = steps.begin("opening " + file.filename().string());
    Result<OpenedFile> opened = open_file(file, current, control);
    const std::lock_guard lock(mutex_);
    if (steps.cancelled()) return;
    if (opened) {
      opened_ = std::move(*opened);
    } else {
      errors_.post(opened.error());
    }
  });
}

std::optional<OpenedFile> OpenJobs::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(opened_, std::nullopt);
}

void OpenJobs::cancel() {
  job_.cancel();
  const std::lock_guard lock(mutex_);
  opened_.reset();
}

bool OpenJobs::idle() const {
  const std::lock_guard lock(mutex_);
  return !opened_ && job_.idle();
}

}  // namespace glint::gui
