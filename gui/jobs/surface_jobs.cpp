#include "gui/jobs/surface_jobs.h"

#include <exception>
#include <utility>

#include "core/document/names.h"
#include "core/document/preset.h"

namespace glint::gui {
namespace {

// The same map under another interpolation, if it differs.
std::shared_ptr<const view::SurfaceInUse> with_interpolation(std::shared_ptr<const view::SurfaceInUse> surface,
                                                             const SurfaceDescription& wanted) {
  if (surface->description == wanted) return surface;
  auto other = std::make_shared<view::SurfaceInUse>(*surface);
  const std::shared_ptr<const NormalMap>& map = surface->loaded.surface.shared_map();
  const Interpolation natural = map->piecewise_constant() ? Interpolation::constant : Interpolation::smooth;
  other->loaded.surface = Surface(map, wanted.interpolation.value_or(natural));
  other->description = wanted;
  return other;
}

}  // namespace

Result<std::shared_ptr<const view::SurfaceInUse>> load_surface_in_use(const SurfaceDescription& description,
                                                                      JobControl& control) {
  try {
    Result<LoadedSurface> loaded = load_surface(description, control, KeepStored::yes);
    if (!loaded) return loaded.error();
    std::optional<NormalPyramid> pyramid = NormalPyramid::build(loaded->surface.shared_map(), control);
    if (!pyramid) return content_error("", "cancelled");
    return std::shared_ptr<const view::SurfaceInUse>(std::make_shared<view::SurfaceInUse>(view::SurfaceInUse{
        std::move(*loaded), description, std::make_shared<const NormalPyramid>(std::move(*pyramid))}));
  } catch (const std::exception& failure) {
    return exception_error(loading_text(description), failure);
  }
}

std::string loading_text(const SurfaceDescription& description) {
  if (description.source == SurfaceSource::file) return "reading " + description.path.filename().string();
  return "generating " + std::string(choice_name(description.source));
}

MapIdentity map_identity(const SurfaceDescription& description) {
  Document document;
  document.surface = description;
  document.surface.interpolation.reset();
  MapIdentity identity{recipe_of(document), {}};
  if (description.source == SurfaceSource::file) identity.path = description.path;
  return identity;
}

SurfaceJobs::SurfaceJobs(const std::function<void()>& wake, ErrorInbox& errors) : errors_(errors), job_(wake, errors) {}

void SurfaceJobs::request(const SurfaceDescription& description) {
  MapIdentity identity = map_identity(description);
  const bool same_request = identity == wanted_identity_;
  wanted_ = description;
  wanted_identity_ = std::move(identity);
  if (in_use_ && in_use_identity_ == wanted_identity_) in_use_ = with_interpolation(in_use_, wanted_);
  if (offered_ && map_identity(offered_->description) == wanted_identity_) {
    cancel();
    use(std::exchange(offered_, nullptr), wanted_identity_);
  } else if (same_request && (pending_ || error_)) {
    return;  // under way, cancelled by a person, or refused
  } else if (in_use_ && in_use_identity_ == wanted_identity_) {
    cancel();
    use(in_use_, wanted_identity_);
  } else {
    load();
  }
}

void SurfaceJobs::use(std::shared_ptr<const view::SurfaceInUse> surface, MapIdentity identity) {
  in_use_ = with_interpolation(std::move(surface), wanted_);
  in_use_identity_ = std::move(identity);
  error_.reset();
  pending_ = false;
}

void SurfaceJobs::load() {
  pending_ = true;
  error_.reset();
  cancel();
  job_.start([this, description = wanted_, identity = wanted_identity_](JobSteps& steps) {
    JobControl& control = steps.begin(loading_text(description));
    Result<std::shared_ptr<const view::SurfaceInUse>> surface = load_surface_in_use(description, control);
    const std::lock_guard lock(mutex_);
    if (!steps.cancelled()) loaded_ = Loaded{identity, std::move(surface)};
  });
}

void SurfaceJobs::poll() {
  job_.poll();
  std::optional<Loaded> loaded;
  {
    const std::lock_guard lock(mutex_);
    loaded = std::exchange(loaded_, std::nullopt);
  }
  if (!loaded || !pending_ || !(loaded->identity == wanted_identity_)) return;
  if (loaded->surface) {
    use(std::move(*loaded->surface), std::move(loaded->identity));
    return;
  }
  pending_ = false;
  error_ = loaded->surface.error();
  errors_.post(*error_);
}

void SurfaceJobs::reload() {
  load();
}

void SurfaceJobs::cancel() {
  job_.cancel();
  const std::lock_guard lock(mutex_);
  loaded_.reset();
}

void SurfaceJobs::restart() {
  if (pending_ && idle()) load();
}

bool SurfaceJobs::idle() const {
  const std::lock_guard lock(mutex_);
  return !loaded_ && job_.idle();
}

}  // namespace glint::gui
