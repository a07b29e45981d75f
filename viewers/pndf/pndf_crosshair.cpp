#include "viewers/pndf/pndf_crosshair.h"

#include <cmath>
#include <utility>

#include "viewers/widgets/widgets.h"

namespace glint::view {
namespace {

constexpr float k_pin_reach = 7;  // pixels round the ring in which a click takes the pin away

Edit toggled_window(const Document& document) {
  const bool whole = document.grid.window && *document.grid.window == k_whole_disk;
  Edit edit{document, whole ? "Fit the window to the lobe" : "Show the whole disk", true};
  edit.document.grid.window = whole ? std::nullopt : std::optional(k_whole_disk);
  return edit;
}

}  // namespace

void PndfCrosshair::begin_frame(glm::dvec4 window, glm::dvec2 cell) {
  window_ = window;
  cell_ = cell;
  hovered_.reset();
  hovered_picture_.clear();
  focused_picture_.clear();
}

std::optional<Edit> PndfCrosshair::over_picture(Ui& ui, const std::string& key, const DiskPlace& place,
                                                const Document& document) {
  const std::string name = "pndf.picture." + key;
  if (ui.state.focus.name == name) {
    focused_picture_ = key;
    move_pin(ui.state.focus);
  }
  const bool over = pressable(ui, name, place.square, {}).hovered && !ui.blocked;
  std::optional<Edit> edit;
  if (over) {
    hovered_ = place.normal_under(ImGui::GetIO().MousePos);
    if (hovered_) hovered_picture_ = key;
    if (ImGui::IsMouseClicked(0)) edit = press(ui, place, document);
  }
  if (auto changed = gesture_.over_picture(ui, name, place, over, document)) edit = std::move(changed);
  return edit;
}

std::optional<Edit> PndfCrosshair::end_frame(Ui& ui, const Document& document) {
  return gesture_.rest(ui, document);
}

// A click pins the normal under it or, on the ring, takes the pin away; the second of two toggles the window instead.
std::optional<Edit> PndfCrosshair::press(const Ui& ui, const DiskPlace& place, const Document& document) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (ImGui::IsMouseDoubleClicked(0)) {
    pinned_ = pinned_before_;
    return toggled_window(document);
  }
  const std::optional<glm::dvec2> s = place.normal_under(mouse);
  if (!s) return std::nullopt;
  pinned_before_ = pinned_;
  if (pinned_) {
    const ImVec2 ring = place.screen_of(*pinned_);
    if (std::hypot(ring.x - mouse.x, ring.y - mouse.y) <= ui.px(k_pin_reach)) {
      pinned_.reset();
      return std::nullopt;
    }
  }
  pinned_ = s;
  return std::nullopt;
}

void PndfCrosshair::move_pin(KeyboardFocus& focus) {
  if (focus.activate) {
    pinned_ = pinned_ ? std::nullopt : std::optional(middle());
    focus.activate = false;
  }
  if (focus.right == 0 && focus.down == 0) return;
  const glm::dvec2 s = pinned_.value_or(middle()) + cell_ * glm::dvec2(focus.right, -focus.down);
  if (std::hypot(s.x, s.y) <= 1) pinned_ = s;
  focus.right = focus.down = 0;
}

glm::dvec2 PndfCrosshair::middle() const {
  return {0.5 * (window_.x + window_.y), 0.5 * (window_.z + window_.w)};
}

Edit PndfCrosshair::zoomed(const Document& document, double notches) const {
  return WindowGesture::zoomed(document, window_, pinned_.value_or(middle()), notches, true);
}

}  // namespace glint::view
