#pragma once
// The palette: type a few letters, run any action or go to any field of the document. Main thread.

#include <string>
#include <string_view>
#include <vector>

#include "gui/input/actions.h"
#include "viewers/widgets/ui.h"

namespace glint::gui {

/// One line of the palette.
struct PaletteRow {
  std::string key;       ///< what is run: "file.open", or "field:intrinsic_roughness" to go to that control
  std::string title;     ///< "Open…", "Go to Roughness σ"
  std::string place;     ///< the menu, or the part of the document
  std::string shortcut;  ///< "Ctrl+O"
  std::string help;      ///< what it does, in a sentence
  std::string reason;    ///< why it cannot be used now
  bool checked = false;
};

/// What matches every word of `words`; all, if there are none. In this order: actions that have the words in title,
/// menu or name; fields; actions that match from afar; actions that cannot be used now.
std::vector<PaletteRow> palette_rows(const Actions& actions, std::string_view words);

class Palette {
 public:
  /// Takes effect with the next draw().
  void open();
  [[nodiscard]] bool is_open() const { return open_; }

  /// Draws it over everything, while it is open; returns the key of the row that was chosen, or nothing. Rows that are
  /// visible are recorded as "palette.file.open", the entry as "palette.text". Up and Down, with Page Up and Page Down,
  /// move the highlight, Enter runs it, Escape or a click elsewhere closes. The keyboard's focus stays on the entry and
  /// goes back to where it was.
  std::string draw(view::Ui& ui, const Actions& actions);

 private:
  bool type(view::Ui& ui, const view::Rectangle& area);  // true when the words changed
  void steer(view::Ui& ui, const std::vector<PaletteRow>& rows, int visible);
  std::string draw_rows(view::Ui& ui, const view::Rectangle& area, const std::vector<PaletteRow>& rows, int visible);
  void finish(view::Ui& ui);

  bool open_ = false;
  bool opening_ = false;      // between open() and the draw() after it
  bool focus_tells_ = false;  // the window gives the arrow keys in the focus also while a person types
  std::string words_;
  int highlighted_ = 0;
  int first_ = 0;  // row at the top
  std::string focus_before_;
};

}  // namespace glint::gui
