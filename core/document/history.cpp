#include "core/document/history.h"

#include <utility>

namespace glint {

History::History(Document initial) : saved_(initial) {
  steps_.push_back({std::move(initial), {}});
}

bool History::commit(Document document, std::string label) {
  if (document == current()) return false;
  steps_.resize(position_ + 1);
  steps_.push_back({std::move(document), std::move(label)});
  if (steps_.size() > k_most_steps + 1) steps_.pop_front();  // the step one starts from is not one to undo
  position_ = steps_.size() - 1;
  ++revision_;
  return true;
}

std::string History::undo_label() const {
  return can_undo() ? steps_[position_].label : std::string();
}

std::string History::redo_label() const {
  return can_redo() ? steps_[position_ + 1].label : std::string();
}

bool History::undo() {
  if (!can_undo()) return false;
  --position_;
  ++revision_;
  return true;
}

bool History::redo() {
  if (!can_redo()) return false;
  ++position_;
  ++revision_;
  return true;
}

}  // namespace glint
