#pragma once
// The sheet of all shortcuts (F1): made from the registry of actions, with what the mouse does in the panels. Main
// thread.

#include <string>
#include <vector>

#include "gui/input/actions.h"
#include "viewers/widgets/ui.h"

namespace glint::gui {

/// One line of the sheet.
struct SheetRow {
  std::string group;              ///< the menu, "Other keys", or the panel
  std::vector<std::string> keys;  ///< "Ctrl+S", "Right drag"; the first is the one that menus show
  std::string title;              ///< "Save", "Move the picture"
};

/// Every action that has a chord, with all its chords, then keys and mouse in the panels. The rows of one group stand
/// side by side, groups in the order in which they first appear.
std::vector<SheetRow> sheet_rows(const Actions& actions);

class ShortcutSheet {
 public:
  /// Takes effect with the next draw().
  void open();
  [[nodiscard]] bool is_open() const { return open_; }

  /// Draws it over everything, while it is open ("sheet", "sheet.close"). Escape, Enter, the cross or a click elsewhere
  /// closes; where it does not fit, the wheel, the arrows and Page Up and Page Down scroll.
  void draw(view::Ui& ui, const Actions& actions);

 private:
  void scroll(view::Ui& ui, float step, float page, float farthest);
  void finish(view::Ui& ui);

  bool open_ = false;
  bool opening_ = false;  // between open() and the draw() after it
  float scrolled_ = 0;    // pixels
  std::string focus_before_;
};

}  // namespace glint::gui
