#include "viewers/pndf/window_gesture.h"

namespace glint::view {
namespace {

constexpr double k_wheel_rests = 0.3;  // seconds after the last notch
constexpr const char* k_zoom_label = "Zoom the P-NDF";
constexpr const char* k_pan_label = "Move the P-NDF's window";

Edit window_edit(const Document& document, glm::dvec4 window, const char* label, bool finished) {
  Edit edit{document, label, finished};
  edit.document.grid.window = window;
  return edit;
}

}  // namespace

Edit WindowGesture::zoomed(const Document& document, glm::dvec4 window, glm::dvec2 s, double notches, bool finished) {
  return window_edit(document, zoomed_window(window, s, notches), k_zoom_label, finished);
}

std::optional<Edit> WindowGesture::over_picture(Ui& ui, std::string_view name, const DiskPlace& place, bool hovered,
                                                const Document& document) {
  const ImGuiIO& io = ImGui::GetIO();
  if (pan_ && pan_->picture == name && io.MouseDown[pan_->button]) {
    const glm::dvec2 moved{(io.MousePos.x - pan_->grabbed.x) / pan_->pixels_per_unit,
                           (pan_->grabbed.y - io.MousePos.y) / pan_->pixels_per_unit};
    if (!pan_->moved && moved == glm::dvec2(0, 0)) return std::nullopt;
    pan_->moved = true;
    return window_edit(document, panned_window(pan_->window, moved), k_pan_label, false);
  }
  if (!hovered || pan_ || !place.shown.contains(io.MousePos)) return std::nullopt;
  for (const int button : {1, 2}) {
    if (!io.MouseClicked[button]) continue;
    pan_ = Pan{std::string(name), button, place.window, {io.MousePos.x, io.MousePos.y}, place.pixels_per_unit(), false};
    ui.state.dragging = name;
    return std::nullopt;
  }
  if (io.MouseWheel == 0) return std::nullopt;
  last_notch_ = ui.seconds;
  return zoomed(document, place.window, place.normal_at(io.MousePos), io.MouseWheel, false);
}

std::optional<Edit> WindowGesture::rest(Ui& ui, const Document& document) {
  if (pan_ && !ImGui::GetIO().MouseDown[pan_->button]) {
    const bool moved = pan_->moved;
    pan_.reset();
    ui.state.dragging.clear();
    if (moved) return Edit{document, k_pan_label, true};
  }
  if (!last_notch_ || ui.seconds - *last_notch_ < k_wheel_rests) return std::nullopt;
  last_notch_.reset();
  return Edit{document, k_zoom_label, true};
}

}  // namespace glint::view
