#pragma once
// A small registry for tests of what is made from one: menus, palette, list of shortcuts.

#include <string>
#include <utility>

#include "gui/input/actions.h"

namespace glint::test {

inline gui::Action example_action(std::string name, std::string menu, std::string title, std::string_view chord) {
  gui::Action action;
  action.name = std::move(name);
  action.menu = std::move(menu);
  action.title = std::move(title);
  action.chord = gui::chord_named(chord);
  action.tooltip = "Does something.";
  action.run = [] {};
  return action;
}

inline gui::Actions example_actions() {
  gui::Actions actions;
  actions.add(example_action("file.open", "File", "Open…", "Ctrl+O"));
  gui::Action reload = example_action("file.reload", "File", "Read the map again", "F5");
  reload.reason_disabled = [] { return "The map is generated, not read from a file."; };
  actions.add(std::move(reload));
  actions.add(example_action("file.quit", "File", "Quit", "Ctrl+Q"));
  actions.add(example_action("edit.undo", "Edit", "Undo", "Ctrl+Z"));
  gui::Action redo = example_action("edit.redo", "Edit", "Redo", "Ctrl+Shift+Z");
  redo.more_chords = {*gui::chord_named("Ctrl+Y")};
  actions.add(std::move(redo));
  gui::Action normal = example_action("view.normal", "View", "Normal colours", "1");
  actions.add(std::move(normal));
  gui::Action slope = example_action("view.slope", "View", "Slope colours", "2");
  slope.checked = [] { return true; };
  actions.add(std::move(slope));
  actions.add(example_action("preset.revert", "Preset", "Revert", ""));
  actions.add(example_action("help.find_action", "Help", "Find an action…", "Ctrl+P"));
  gui::Action left = example_action("footprint.left", "", "Move the footprint a texel left", "");
  left.more_chords = {*gui::chord_named("Left")};
  actions.add(std::move(left));
  return actions;
}

}  // namespace glint::test
