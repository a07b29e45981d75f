#include "gui/jobs/picture_board.h"

#include <algorithm>
#include <utility>

namespace glint::gui {

void PictureBoard::announce(Label label) {
  const std::lock_guard lock(mutex_);
  newest_ = std::move(label);
  if (newest_.request != current_.label.request || !has_published_) return;
  current_.label = newest_;
  publish();
}

void PictureBoard::begin(Request request) {
  const std::lock_guard lock(mutex_);
  if (request.label.request == newest_.request) request.label = newest_;
  std::vector<Slot> slots;
  for (std::size_t k = 0; k < request.identities.size(); ++k) {
    slots.push_back(slot_for(std::move(request.identities[k]), request.label.document.methods[k], request));
  }
  slots_ = std::move(slots);
  current_ = std::move(request);
  has_published_ = std::any_of(slots_.begin(), slots_.end(), [](const Slot& slot) { return slot.is_right(); });
  if (has_published_) publish();
}

PictureBoard::Slot PictureBoard::slot_for(PictureIdentity identity, PndfMethod method, const Request& request) const {
  const auto old = std::find_if(slots_.begin(), slots_.end(),
                                [&](const Slot& candidate) { return candidate.picture.method == method; });
  Slot slot;
  if (old != slots_.end() && old->held.map == identity.map &&
      current_.label.document.grid.window == request.label.document.grid.window) {
    slot = *old;
  }
  slot.identity = std::move(identity);
  slot.picture.method = method;
  slot.picture.progress = slot.is_right() && !slot.picture.coarse ? 1 : 0;
  return slot;
}

void PictureBoard::set_picture(std::size_t index, view::MethodPicture picture) {
  const std::lock_guard lock(mutex_);
  Slot& slot = slots_[index];
  slot.held = slot.identity;
  slot.picture = std::move(picture);
  slot.picture.progress = slot.picture.coarse ? 0 : 1;
  publish();
}

void PictureBoard::set_reference(std::shared_ptr<const PndfImage> reference) {
  const std::lock_guard lock(mutex_);
  current_.reference = std::move(reference);
  publish();
}

void PictureBoard::set_errors(std::size_t index, const std::optional<PndfErrors>& errors, double reference_error,
                              std::shared_ptr<const PndfImage> reference) {
  const std::lock_guard lock(mutex_);
  slots_[index].picture.errors = errors;
  slots_[index].picture.reference_error = reference_error;
  slots_[index].picture.reference = std::move(reference);
  publish();
}

void PictureBoard::set_progress(PndfMethod method, double progress) {
  constexpr double k_step = 0.01;
  const std::lock_guard lock(mutex_);
  for (Slot& slot : slots_) {
    const double shown = slot.picture.progress;
    if (slot.picture.method != method || shown >= 1 || progress < shown + k_step || progress >= 1) continue;
    slot.picture.progress = progress;
    if (has_published_) publish();
  }
}

void PictureBoard::end() {
  const std::lock_guard lock(mutex_);
  for (Slot& slot : slots_) slot.picture.progress = 1;
  if (has_published_) publish();
}

bool PictureBoard::has_picture(std::size_t index) const {
  const std::lock_guard lock(mutex_);
  return slots_[index].is_right();
}

bool PictureBoard::has_full_picture(std::size_t index) const {
  const std::lock_guard lock(mutex_);
  return slots_[index].is_right() && !slots_[index].picture.coarse;
}

view::MethodPicture PictureBoard::picture(std::size_t index) const {
  const std::lock_guard lock(mutex_);
  return slots_[index].picture;
}

std::shared_ptr<const view::PndfResults> PictureBoard::results() const {
  const std::lock_guard lock(mutex_);
  return published_;
}

void PictureBoard::publish() {
  if (current_.label.request == newest_.request) current_.label = newest_;
  has_published_ = true;
  auto results = std::make_shared<view::PndfResults>();
  results->revision = current_.label.revision;
  results->document = current_.label.document;
  results->surface = current_.surface;
  results->grid = current_.grid;
  results->reference = current_.reference;
  for (Slot& slot : slots_) {
    if (slot.is_right() || !slot.picture.image) slot.picture.revision = current_.label.revision;
    results->methods.push_back(slot.picture);
  }
  published_ = std::move(results);
}

}  // namespace glint::gui
