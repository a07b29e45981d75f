#pragma once
// The bar at the top of the window: menus made from the registry of actions, the document's name, and the way to the
// palette. Main thread.

#include <string>

#include "gui/input/actions.h"
#include "viewers/widgets/ui.h"

namespace glint::gui {

struct MenuBarInput {
  const Actions& actions;
  std::string title;  ///< "scratched-steel, modified"
};

/// Draws the bar into `area` and the open menu under it; returns the name of the action that was chosen, or nothing.
/// Menus stand in the order in which the actions name them and are recorded as "menu.File" …, rows as
/// "popup.file.open". The one that is open is ui.state.open_popup. A menu opens when the mouse button goes down on its
/// title, or with Down, Enter or Space on the focused title; while one is open, resting on another title or Left and
/// Right change it.
std::string draw_menu_bar(view::Ui& ui, const view::Rectangle& area, const MenuBarInput& input);

}  // namespace glint::gui
