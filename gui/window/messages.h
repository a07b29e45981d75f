#pragma once
// What went wrong, and what else a person has to know, as strips under the menu bar: each says what failed, why, and
// what stays as it was, and stays until it is dismissed. Main thread.

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "core/math/result.h"
#include "gui/input/actions.h"
#include "viewers/widgets/ui.h"

namespace glint::gui {

struct Message {
  enum class Kind { error, warning, info };
  Kind kind = Kind::error;
  std::string text;                       ///< whole sentences
  std::vector<std::string> action_names;  ///< offered as buttons: "file.open"; at most two find room at 1280
};

/// An error as whole sentences: "wood.json cannot be read: there is no such file." where the sentence goes on from its
/// subject, else "wood.dds: No such file." A field of a document is called by its label.
std::string error_text(const Error& error);

class Messages {
 public:
  using Kind = Message::Kind;

  struct Posted {
    Message message;
    int count = 1;  ///< how often it was posted since it was last dismissed
  };

  /// Comes to the top. The same words of the same kind are not stacked but counted.
  void post(Message message);
  void post_error(const Error& error, std::vector<std::string> action_names = {});
  void dismiss(std::size_t index);
  void dismiss_all() { posted_.clear(); }

  /// Newest first.
  [[nodiscard]] const std::deque<Posted>& all() const { return posted_; }
  /// The one posted last; null while there is none.
  [[nodiscard]] const Message* newest() const { return posted_.empty() ? nullptr : &posted_.front().message; }

  /// Of all strips in a window of that width, with a gap above each; 0 without messages.
  [[nodiscard]] float height(const view::Ui& ui, float width) const;
  /// Draws the newest three from the top of `area`, which has that height and the window's width; returns the action
  /// whose button was pressed, or nothing. Strips are "message.0" (the newest) … with ".text", ".copy", ".close" and
  /// the actions' names ("message.0.file.open") below them; "message.close_all" where there are more than are shown.
  std::string draw(view::Ui& ui, const view::Rectangle& area, const Actions& actions);

 private:
  std::deque<Posted> posted_;
};

}  // namespace glint::gui
