#pragma once
// Menu bar, status bar, messages, palette and sheet of shortcuts on a stage, with the means of a person: mouse and
// keyboard.

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>

#include "gui/dialogs/palette.h"
#include "gui/dialogs/shortcut_sheet.h"
#include "gui/input/input.h"
#include "gui/window/menu_bar.h"
#include "gui/window/messages.h"
#include "gui/window/status_bar.h"
#include "tests/gui/example_actions.h"
#include "tests/viewers/stage.h"
#include "viewers/widgets/widgets.h"

namespace glint::gui {

class ShellStage : public testing::Test {
 protected:
  ShellStage() {
    setup_key_map(stage.io());
    stage.io().MousePos = {640, 400};
    frame();
    frame();
  }

  void draw(view::Ui& ui) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ui.blocked = palette.is_open() || sheet.is_open() || !ui.state.open_popup.empty();
    const view::Rectangle bar{{0, 0}, {size.x, ui.px(26)}};
    took(draw_menu_bar(ui, bar, {actions, "scratched-steel, modified"}));
    height = messages.height(ui, size.x);
    took(messages.draw(ui, {{0, bar.max.y}, {size.x, bar.max.y + height}}, actions));
    constexpr std::array<std::string_view, 2> k_labels{"one", "two"};
    const float top = bar.max.y + height + ui.px(60);
    view::combo(ui, "combo", {{20, top}, {120, top + 24}}, k_labels, 0, {});
    events = draw_status_bar(ui, {{0, size.y - ui.px(26)}, size}, status);
    if (chosen == "help.find_action") palette.open();
    took(palette.draw(ui, actions));
    sheet.draw(ui, actions);
  }
  void took(std::string name) {
    if (!name.empty()) chosen = std::move(name);
  }
  void frame() {
    stage.frame([this](view::Ui& ui) { draw(ui); });
  }
  void click(const std::string& widget) {
    stage.click(widget.c_str(), [this](view::Ui& ui) { draw(ui); });
  }
  void move_to(const std::string& widget) {
    const view::WidgetRecord::Entry* entry = stage.widgets().find(widget);
    ASSERT_NE(entry, nullptr) << widget;
    stage.io().MousePos = entry->area.center();
    frame();
  }
  void hold_mouse(bool down) {
    stage.io().MouseDown[0] = down;
    frame();
  }
  void press(Key key) {
    stage.io().KeysDown[static_cast<int>(key)] = true;
    frame();
    stage.io().KeysDown[static_cast<int>(key)] = false;
    frame();
  }
  void type(const char* text) {
    stage.io().AddInputCharactersUTF8(text);
    frame();
    frame();
  }
  void step(int right, int down, bool activate = false) {
    stage.state().focus.right = right;
    stage.state().focus.down = down;
    stage.state().focus.activate = activate;
    frame();
    frame();
  }
  [[nodiscard]] bool has(const std::string& widget) const { return stage.widgets().find(widget) != nullptr; }
  [[nodiscard]] view::Rectangle area(const std::string& widget) const {
    const view::WidgetRecord::Entry* entry = stage.widgets().find(widget);
    return entry == nullptr ? view::Rectangle() : entry->area;
  }

  test::Stage stage{{1280, 720}};
  Actions actions = test::example_actions();
  Messages messages;
  Palette palette;
  ShortcutSheet sheet;
  StatusInput status;
  std::string chosen;
  float height = 0;
  StatusEvents events;
};

}  // namespace glint::gui
