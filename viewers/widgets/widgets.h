#pragma once
// The controls of the window. Each takes the area it stands in, draws itself in the theme's states, records its place
// under its name, can be reached by Tab, and says why where it cannot be used. Values come in and go out; none is kept.

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "viewers/widgets/draw.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

/// What stands in a control's tooltip, and whether it can be used.
struct Explained {
  std::string title;   ///< "Roughness σ"
  std::string text;    ///< what it does, in sentences
  std::string reason;  ///< why it cannot be used now; empty: it can
};

/// The behaviour that everything clickable shares.
struct Press {
  bool pressed = false;  ///< clicked, or Enter/Space while it has the focus
  bool hovered = false;
  bool held = false;     ///< the mouse button is down on it
  bool focused = false;  ///< by the keyboard: draw the accent outline
  bool enabled = true;
};
Press pressable(Ui& ui, std::string_view name, const Rectangle& area, const Explained& explained);

/// The tooltip of whatever `name` is, once the mouse has rested on `area` for a moment.
void explain(Ui& ui, std::string_view name, const Rectangle& area, const Explained& explained);

enum class ButtonKind { normal, primary };
/// True when pressed. Width for a text: button_width().
bool button(Ui& ui, std::string_view name, const Rectangle& area, std::string_view text, const Explained& explained,
            ButtonKind kind = ButtonKind::normal);
float button_width(const Ui& ui, std::string_view text);

/// 20 x 20 round `center`.
bool icon_button(Ui& ui, std::string_view name, ImVec2 center, Icon icon, const Explained& explained);

/// Two to four choices side by side; the chosen one is filled. Each choice is recorded as name.choice ("surface.wrap"
/// gives "surface.wrap.clamp"). Returns the newly chosen index.
std::optional<int> switch_of(Ui& ui, std::string_view name, ImVec2 at, std::span<const std::string_view> keys,
                             std::span<const std::string_view> labels, int chosen, const Explained& explained);
float switch_width(const Ui& ui, std::span<const std::string_view> labels);

/// More than four choices, or where room is short. Returns the newly chosen index.
std::optional<int> combo(Ui& ui, std::string_view name, const Rectangle& area, std::span<const std::string_view> labels,
                         int chosen, const Explained& explained);

/// True when toggled. The box is 16 high; the label beside it is part of the area.
bool checkbox(Ui& ui, std::string_view name, const Rectangle& area, std::string_view label, bool checked,
              const Explained& explained);

/// A value that can be typed: shows `value` and `unit` right-aligned, is an entry when clicked or entered. Returns the
/// text when a person ends it with Enter, Tab or by clicking elsewhere; Escape takes it back. A refused text is given
/// back through refuse_entry(), which keeps the entry open with the reason. `edited` is the text one begins with, where
/// that has more digits than what is shown.
std::optional<std::string> entry(Ui& ui, std::string_view name, const Rectangle& area, std::string_view value,
                                 std::string_view unit, const Explained& explained, std::string_view edited = {},
                                 bool left_aligned = false);
void refuse_entry(Ui& ui, std::string_view name, std::string_view text, std::string_view why);

/// The drag of a slider's grab.
struct Slide {
  double value = 0;
  bool finished = false;  ///< the grab was let go, or it was a step of the keyboard
};
/// `value` is shown at its place between `lowest` and `highest` (or at the end it lies beyond).
std::optional<Slide> slider(Ui& ui, std::string_view name, const Rectangle& area, double value, double lowest,
                            double highest, bool logarithmic, const Explained& explained);

/// The small arrow that takes a field back to its saved value; drawn only where `differs`.
bool reset_arrow(Ui& ui, std::string_view name, ImVec2 center, bool differs, const Explained& explained);

/// Progress as a bar 4 high; NaN is a bar of unknown progress.
void progress_bar(const Ui& ui, const Rectangle& area, double progress);

/// A list that lies over everything until a row is chosen or it is left; for combos and menus.
struct PopupRow {
  std::string key;  ///< recorded as popup.key
  std::string label;
  std::string shortcut;  ///< right-aligned, in hint
  std::string reason;    ///< why it is disabled
  std::string tooltip;
  bool checked = false;
  bool separator_before = false;
};
void open_popup(Ui& ui, std::string_view name);
[[nodiscard]] bool popup_open(const Ui& ui, std::string_view name);
/// Draws the list of `name` under `anchor`, if it is the open one; returns the index of the row that was chosen.
std::optional<int> popup_list(Ui& ui, std::string_view name, const Rectangle& anchor, std::span<const PopupRow> rows);

}  // namespace glint::view
