#include "gui/jobs/editor.h"

#include <utility>

#include "core/document/parameter.h"

namespace glint::gui {

Editor::Editor(Document initial) : history_(std::move(initial)) {}

Status Editor::apply(view::Edit edit) {
  if (std::optional<Error> fault = document_fault(edit.document)) return *std::move(fault);
  if (gesture_ && gesture_->label != edit.label) finish_gesture();
  if (!(edit.document == document())) ++revision_;
  if (edit.finished) {
    gesture_.reset();
    history_.commit(std::move(edit.document), std::move(edit.label));
  } else {
    gesture_ = Gesture{std::move(edit.document), std::move(edit.label)};
  }
  return success();
}

void Editor::finish_gesture() {
  if (!gesture_) return;
  history_.commit(std::move(gesture_->document), std::move(gesture_->label));
  gesture_.reset();
}

void Editor::cancel_gesture() {
  if (gesture_changes()) ++revision_;
  gesture_.reset();
}

Status Editor::open(Document document, std::string label) {
  if (std::optional<Error> fault = document_fault(document)) return *std::move(fault);
  finish_gesture();
  if (history_.commit(std::move(document), std::move(label))) ++revision_;
  history_.mark_saved();
  return success();
}

bool Editor::can_undo() const {
  return gesture_changes() || history_.can_undo();
}

bool Editor::can_redo() const {
  return !gesture_changes() && history_.can_redo();
}

std::string Editor::undo_label() const {
  return gesture_changes() ? gesture_->label : history_.undo_label();
}

std::string Editor::redo_label() const {
  return gesture_changes() ? std::string() : history_.redo_label();
}

bool Editor::undo() {
  finish_gesture();
  if (!history_.undo()) return false;
  ++revision_;
  return true;
}

bool Editor::redo() {
  finish_gesture();
  if (!history_.redo()) return false;
  ++revision_;
  return true;
}

void Editor::mark_saved() {
  finish_gesture();
  history_.mark_saved();
}

}  // namespace glint::gui
