#pragma once
// An Inspector on a stage, with the document it edits: for tests that click, type and drag in it.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tests/viewers/stage.h"
#include "viewers/inspector/inspector.h"
#include "viewers/inspector/inspector_sections.h"

namespace glint::test {

struct InspectorScene {
  explicit InspectorScene(glm::ivec2 size, float scale = 1) : stage(size, scale) {
    stage.io().KeyMap[ImGuiKey_Enter] = k_enter;
    stage.io().MousePos = {-100, -100};
  }

  /// All sections stay open, whatever the room.
  void open_all() {
    for (const view::InspectorSection& section : view::inspector_sections()) open[std::string(section.name)] = true;
  }

  view::InspectorEvents last;     ///< of the last frame
  std::vector<view::Edit> edits;  ///< all, in order
  bool browsed = false;
  Document document;
  Document saved;
  std::shared_ptr<const view::SurfaceInUse> surface;
  std::optional<view::PndfReading> reading;
  std::shared_ptr<const view::PndfResults> results;
  view::FittedRanges fitted;
  std::map<std::string, bool> open;
  view::Inspector inspector;
  Stage stage;

  void frame(int count = 1) {
    for (int k = 0; k < count; ++k) stage.frame(body());
  }
  void click(const std::string& name) { stage.click(name.c_str(), body()); }
  /// Opens the entry, types over what stands in it, and ends with Enter.
  void type(const std::string& name, const std::string& text) {
    click(name);
    frame(2);
    stage.io().AddInputCharactersUTF8(text.c_str());
    frame();
    stage.io().KeysDown[k_enter] = true;
    frame();
    stage.io().KeysDown[k_enter] = false;
    frame();
  }
  /// Gives it the keyboard's focus and presses Right (or Left, below 0).
  void step(const std::string& name, int right) {
    stage.state().focus.name = name;
    stage.state().focus.right = right;
    frame();
    stage.state().focus.name.clear();
  }
  [[nodiscard]] const view::WidgetRecord::Entry* widget(const std::string& name) const {
    return stage.widgets().find(name);
  }

 private:
  static constexpr int k_enter = 257;

  std::function<void(view::Ui&)> body() {
    return [this](view::Ui& ui) {
      view::InspectorInput input{document, saved};
      input.is_saved = document == saved;
      input.surface = surface;
      input.presets = {"one", "two"};
      input.reading = &reading;
      input.results = results;
      input.fitted = fitted;
      input.open_sections = &open;
      const glm::ivec2 size = stage.size();
      last = inspector.draw(ui, {{0, 0}, {static_cast<float>(size.x), static_cast<float>(size.y)}}, input);
      if (last.section) open[last.section->first] = last.section->second;
      browsed = browsed || last.browse_pressed;
      if (!last.edit) return;
      document = last.edit->document;
      edits.push_back(*last.edit);
    };
  }
};

}  // namespace glint::test
