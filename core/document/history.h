#pragma once
// Undo and redo as a history of values: every step holds the whole document, so that no edit needs an inverse.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>

#include "core/document/document.h"

namespace glint {

/// One thread at a time. The memory is bounded: the oldest steps are forgotten beyond k_most_steps.
class History {
 public:
  static constexpr std::size_t k_most_steps = 1000;

  /// A document that counts as saved: closing it loses nothing.
  explicit History(Document initial = {});

  [[nodiscard]] const Document& current() const { return steps_[position_].document; }
  /// Grows with every change of current(); results of jobs are tagged with it.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

  /// Makes `document` the current one; what had been undone is forgotten. Nothing happens if it equals the current one.
  /// `label` names the edit in the menu ("sigma_r to 0.01"). Returns whether anything changed.
  bool commit(Document document, std::string label);

  [[nodiscard]] bool can_undo() const { return position_ > 0; }
  [[nodiscard]] bool can_redo() const { return position_ + 1 < steps_.size(); }
  /// What undo() would take back and redo() would do again; empty if they cannot.
  [[nodiscard]] std::string undo_label() const;
  [[nodiscard]] std::string redo_label() const;
  /// False, and nothing changes, where there is no such step.
  bool undo();
  bool redo();

  /// Whether the current document equals the one last saved, whichever way it was reached.
  [[nodiscard]] bool is_saved() const { return current() == saved_; }
  void mark_saved() { saved_ = current(); }
  /// The document that counts as saved, for going back to it.
  [[nodiscard]] const Document& saved() const { return saved_; }

 private:
  struct Step {
    Document document;
    std::string label;  // of the edit that led here
  };

  std::deque<Step> steps_;  // never empty
  std::size_t position_ = 0;
  std::uint64_t revision_ = 0;
  Document saved_;
};

}  // namespace glint
