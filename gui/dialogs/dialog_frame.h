#pragma once
// What every dialog has in common: a ground that dims and covers the window, a frame with a title in its middle, the
// keyboard held inside, Escape, and a row of buttons. Main thread.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "viewers/widgets/ui.h"
#include "viewers/widgets/widgets.h"

namespace glint::gui {

/// Of dialogs drawn after each other in one frame, the last one that is open has mouse and keyboard: draw them in the
/// order in which they can lie over each other, after everything else.
class DialogFrame {
 public:
  struct Look {
    std::string_view name;  ///< "browser": controls are recorded as browser.…, the ×  as browser.close
    std::string_view title;
    ImVec2 size{0, 0};       ///< at scale 1; made smaller where the window is
    std::string_view focus;  ///< the control that has the keyboard at first, and whenever none has it
  };

  void open();
  /// Gives the keyboard's focus back to what had it before.
  void close(view::Ui& ui);
  [[nodiscard]] bool is_open() const { return open_; }

  /// Only while open; every begin has its end. The room under the title, without margins.
  view::Rectangle begin(view::Ui& ui, const Look& look);
  /// True if a person left the dialog by Escape or ×, which closes it.
  bool end(view::Ui& ui);

  /// Escape means something else in this frame: the dialog stays.
  void keep_open() { escaped_ = false; }
  /// Escape was pressed in this frame, not for a list or an entry.
  [[nodiscard]] bool escaped() const { return escaped_; }

 private:
  void take_focus(view::Ui& ui, const Look& look) const;

  bool open_ = false;
  bool appearing_ = false;
  bool inner_ = false;  // in the last frame a list was open or a person typed: Escape was for that
  bool escaped_ = false;
  bool dismissed_ = false;
  bool blocked_before_ = false;
  std::string focus_before_;
};

/// One of the buttons at the lower right of a dialog.
struct DialogButton {
  std::string key;  ///< recorded as dialog.key
  std::string text;
  view::Explained explained;
  bool is_primary = false;
};
/// In a row that ends at the right of `area`; returns the index of the one that was pressed.
std::optional<int> dialog_buttons(view::Ui& ui, std::string_view dialog, const view::Rectangle& area,
                                  std::span<const DialogButton> buttons);

/// Lines of small letters from `at` down; returns the y below them.
float draw_sentences(const view::Ui& ui, ImVec2 at, float width, ImU32 ink, std::string_view text);

/// Cut at its front with an ellipsis where it is wider than `width`: for paths, whose end says most.
std::string fitted_path(const ImFont* font, std::string_view path, float width);

/// Whether Enter ended what was typed in this frame, rather than a click elsewhere.
bool enter_pressed();

/// The row that is selected after the keys of this frame, for the list that has the focus: Up, Down, Page Up, Page
/// Down, Home and End. `page` is how many rows are seen at once. None: no such key.
std::optional<int> moved_row(view::Ui& ui, int selected, int count, int page);

}  // namespace glint::gui
