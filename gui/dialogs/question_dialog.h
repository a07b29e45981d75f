#pragma once
// A question with a few answers, and the questions this program asks. Main thread.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gui/dialogs/dialog_frame.h"

namespace glint::gui {

struct Question {
  std::string name;                   ///< "unsaved": the answers are recorded as unsaved.KEY
  std::string title;                  ///< "Save the changes?"
  std::string text;                   ///< sentences
  std::vector<DialogButton> answers;  ///< from left to right; the last has the keyboard at first
};

struct Answer {
  std::string question;  ///< its name
  std::string key;       ///< of the answer
};

class QuestionDialog {
 public:
  /// Takes the place of a question that is open.
  void open(Question question);
  [[nodiscard]] bool is_open() const { return frame_.is_open(); }
  /// Once a frame; an answer closes the dialog. Escape and × answer nothing: all stays as it is.
  std::optional<Answer> draw(view::Ui& ui);

 private:
  DialogFrame frame_;
  Question question_;
};

/// "unsaved": save, discard, cancel; at closing, and before another document takes the place of this one.
/// `cannot_save` is why saving is not possible now; empty: it is.
Question unsaved_changes_question(const std::string& document, const std::string& before_what,
                                  const std::string& cannot_save = {});
/// "delete_preset": delete, cancel.
Question delete_preset_question(const std::string& preset, const std::filesystem::path& file);

}  // namespace glint::gui
