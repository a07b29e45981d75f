#pragma once
// The live document: a history of finished edits and the gesture (a drag, a held key) that goes on upon it.

#include <cstdint>
#include <optional>
#include <string>

#include "core/document/document.h"
#include "core/document/history.h"
#include "core/math/result.h"
#include "viewers/edit.h"

namespace glint::gui {

/// One thread at a time. Every step of the history, and every step of a gesture, is a document without faults.
class Editor {
 public:
  /// `initial` is free of faults and counts as saved.
  explicit Editor(Document initial = {});

  /// What is shown and computed: the gesture included.
  [[nodiscard]] const Document& document() const { return gesture_ ? gesture_->document : history_.current(); }
  /// Grows with every change of document(), whatever caused it.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

  /// An unfinished edit opens a gesture or continues the one of the same label; a finished one becomes a step of undo,
  /// and takes the gesture of its label with it: all of a gesture is one step. An edit of another label first makes a
  /// step of the open gesture. A document with a fault (document_fault) is refused and nothing changes.
  Status apply(view::Edit edit);
  /// Makes a step of the open gesture as it stands.
  void finish_gesture();
  /// Back to before the open gesture.
  void cancel_gesture();
  [[nodiscard]] bool in_gesture() const { return gesture_.has_value(); }

  /// An undoable step to a document that came from a file: it counts as saved. Refused like an edit.
  Status open(Document document, std::string label);

  [[nodiscard]] bool can_undo() const;
  [[nodiscard]] bool can_redo() const;
  /// What undo() would take back and redo() would do again; empty if they cannot.
  [[nodiscard]] std::string undo_label() const;
  [[nodiscard]] std::string redo_label() const;
  /// Both finish an open gesture first. False, and nothing more changes, where there is no such step.
  bool undo();
  bool redo();

  /// The document last saved or opened: what a field or everything can be reverted to.
  [[nodiscard]] const Document& saved() const { return history_.saved(); }
  [[nodiscard]] bool is_saved() const { return document() == saved(); }
  /// Finishes an open gesture: what is saved is a step.
  void mark_saved();

 private:
  struct Gesture {
    Document document;
    std::string label;
  };

  [[nodiscard]] bool gesture_changes() const { return gesture_ && !(gesture_->document == history_.current()); }

  History history_;
  std::optional<Gesture> gesture_;
  std::uint64_t revision_ = 0;
};

}  // namespace glint::gui
