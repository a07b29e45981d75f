// What actions do to the application.

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/document/parameter.h"
#include "gui/input/keyboard.h"
#include "gui/window/application.h"

namespace glint::gui {
namespace {

constexpr double k_least_scale = 0.75;
constexpr double k_largest_scale = 3;

SymmetricMatrix2 scaled(const SymmetricMatrix2& m, double factor) {
  return {m.xx * factor, m.xy * factor, m.yy * factor};
}

// R m R^T for a turn from +u towards the top of the picture (-v).
SymmetricMatrix2 turned(const SymmetricMatrix2& m, double radians) {
  const double c = std::cos(radians);
  const double s = -std::sin(radians);
  return {c * c * m.xx - 2 * c * s * m.xy + s * s * m.yy, c * s * (m.xx - m.yy) + (c * c - s * s) * m.xy,
          s * s * m.xx + 2 * c * s * m.xy + c * c * m.yy};
}

}  // namespace

void Application::undo() {
  workbench_.editor().undo();
}

void Application::redo() {
  workbench_.editor().redo();
}

void Application::save() {
  if (!workbench_.can_save_in_place()) {
    overlays_.open_save_as();
    return;
  }
  workbench_.report(workbench_.save(), "Saved " + workbench_.preset_file().string() + ".");
}

void Application::copy_values() {
  const std::string text =
      panels_.focused() == Panel::map ? panels_.map().values_at_cursor() : panels_.pndf().reading_text();
  if (text.empty()) {
    workbench_.messages().post(
        {Messages::Kind::info, "There is nothing to copy: rest the mouse on the map, or click in a P-NDF.", {}});
    return;
  }
  setup_.set_clipboard(text);
}

// From the nearest to the farthest of what a person may want to leave.
void Application::escape() {
  view::UiState& state = screen_->state();
  if (!state.open_popup.empty()) {
    state.open_popup.clear();
  } else if (overlays_.is_open()) {
    return;  // they see to it themselves
  } else if (workbench_.editor().in_gesture()) {
    workbench_.editor().cancel_gesture();
    state.dragging.clear();
  } else if (!state.focus.name.empty()) {
    state.focus.name.clear();
  } else if (!workbench_.settings().maximised_panel.empty()) {
    workbench_.settings().maximised_panel.clear();
  } else if (!workbench_.jobs().idle()) {
    workbench_.jobs().cancel();
  }
}

void Application::move_focus(bool backwards) {
  view::UiState& state = screen_->state();
  const std::size_t first = overlays_.is_open() ? first_overlay_widget_ : 0;
  state.focus.name = next_stop(widgets(), first, state.focus.name, backwards);
  state.focus.moved = true;
  const auto& order = widgets().order();
  const auto at = std::find(order.begin(), order.end(), state.focus.name);
  if (const auto panel = panels_.panel_of(static_cast<std::size_t>(at - order.begin()))) panels_.focus(*panel);
}

void Application::focus_panel(int step) {
  int panel = static_cast<int>(panels_.focused());
  for (int tries = 0; tries < k_panel_count; ++tries) {
    panel = (panel + step + k_panel_count) % k_panel_count;
    if (layout_.panels[static_cast<std::size_t>(panel)].width() > 0) break;
  }
  panels_.focus(static_cast<Panel>(panel));
  view::UiState& state = screen_->state();
  state.focus.name = next_stop(widgets(), panels_.first_widget(static_cast<Panel>(panel)), {}, false);
  state.focus.moved = true;
}

void Application::move_footprint(glm::dvec2 texels) {
  arrows_move_footprint_ = true;
  workbench_.change(
      "Move the footprint", [&](Document& document) { document.footprint.center += texels; }, false);
}

void Application::scale_footprint(double factor) {
  workbench_.change(factor > 1 ? "Widen the footprint" : "Narrow the footprint", [&](Document& document) {
    document.footprint.covariance = scaled(document.footprint.covariance, factor * factor);
  });
}

void Application::turn_footprint(double radians) {
  workbench_.change("Turn the footprint", [&](Document& document) {
    document.footprint.covariance = turned(document.footprint.covariance, radians);
  });
}

void Application::set_ui_scale(double scale) {
  const double wanted = scale > 0 ? std::clamp(scale, k_least_scale, k_largest_scale) : 0;
  workbench_.settings().ui_scale = wanted;
  wanted_scale_ = wanted > 0 ? static_cast<float>(wanted) : setup_.scale;
}

void Application::toggle_maximised(Panel panel) {
  std::string& maximised = workbench_.settings().maximised_panel;
  maximised = maximised == panel_name(panel) ? std::string() : std::string(panel_name(panel));
  panels_.focus(panel);
}

void Application::go_to_field(const std::string& path) {
  panels_.focus(Panel::inspector);
  workbench_.settings().maximised_panel.clear();
  if (!panels_.inspector().bring_to_view(path)) return;
  screen_->state().focus.name = path;
  screen_->state().focus.moved = true;
}

void Application::export_panel(Panel panel) {
  switch (panel) {
    case Panel::map:
      overlays_.open_export(ExportWhat::map_panel);
      break;
    case Panel::pndf:
      overlays_.open_export(ExportWhat::pndf_images);
      break;
    case Panel::inspector:
      overlays_.open_export(ExportWhat::inspector);
      break;
  }
}

}  // namespace glint::gui
