#include "gui/dialogs/dialog_frame.h"

#include <algorithm>
#include <cmath>

#include "gui/input/chord.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"

namespace glint::gui {
namespace {

using view::Rectangle;
using view::Ui;
namespace color = view::color;
namespace size = view::size;

constexpr float k_margin = 16;  // between a dialog and the edge of a small window

bool pressed(Key key, bool repeats = false) {
  return ImGui::IsKeyPressed(static_cast<int>(key), repeats);
}

Rectangle in_the_middle(const Ui& ui, ImVec2 wanted) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width = std::min(ui.px(wanted.x), screen.x - 2 * ui.px(k_margin));
  const float height = std::min(ui.px(wanted.y), screen.y - 2 * ui.px(k_margin));
  const ImVec2 min{std::floor(0.5F * (screen.x - width)), std::floor(0.5F * (screen.y - height))};
  return {min, {min.x + width, min.y + height}};
}

// What lies under the dialog is no stop of the Tab key.
void hold_tab_inside(Ui& ui) {
  for (const std::string& name : std::vector<std::string>(ui.widgets.order())) {
    view::WidgetRecord::Entry entry = *ui.widgets.find(name);
    if (!entry.focusable) continue;
    entry.focusable = false;
    ui.widgets.record(name, std::move(entry));
  }
}

}  // namespace

void DialogFrame::open() {
  open_ = true;
  appearing_ = true;
}

void DialogFrame::close(Ui& ui) {
  if (!open_) return;
  open_ = false;
  ui.state.focus = {};
  ui.state.focus.name = focus_before_;
  ui.state.editing.clear();
  ui.state.open_popup.clear();
}

void DialogFrame::take_focus(Ui& ui, const Look& look) const {
  view::UiState& state = ui.state;
  const std::string prefix = std::string(look.name) + ".";
  const bool top = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) || appearing_;
  if (!top || !state.editing.empty() || !state.open_popup.empty() || ImGui::IsAnyMouseDown()) return;
  if (!state.focus.name.starts_with(prefix)) state.focus.name = look.focus;
}

Rectangle DialogFrame::begin(Ui& ui, const Look& look) {
  view::UiState& state = ui.state;
  if (appearing_) {
    focus_before_ = state.focus.name;
    state.focus = {};
    if (!state.editing.starts_with(look.name)) state.editing.clear();
    state.open_popup.clear();
    ImGui::SetNextWindowFocus();
  }
  hold_tab_inside(ui);
  blocked_before_ = ui.blocked;
  ui.blocked = false;
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_ChildBorderSize, 0);
  ImGui::Begin(("##dialog " + std::string(look.name)).c_str(), nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoScrollWithMouse);
  take_focus(ui, look);
  const bool top = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
  escaped_ = top && !appearing_ && !inner_ && pressed(Key::escape);
  if (inner_ && pressed(Key::escape)) state.open_popup.clear();
  appearing_ = false;

  const Rectangle area = in_the_middle(ui, look.size);
  const Rectangle bar{area.min, {area.max.x, area.min.y + ui.px(size::k_panel_header)}};
  ui.widgets.record(look.name, {area, {}, false, false});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = ui.px(4);
  list.AddRectFilled({0, 0}, ImGui::GetIO().DisplaySize, ImGui::GetColorU32(ImGuiCol_ModalWindowDimBg));
  list.AddRectFilled(area.min, area.max, color::k_panel, rounding);
  list.AddRectFilled(bar.min, bar.max, color::k_header, rounding, ImDrawFlags_RoundCornersTop);
  list.AddLine({bar.min.x, bar.max.y}, bar.max, color::k_border);
  list.AddRect(area.min, area.max, color::k_border_strong, rounding);
  view::draw_text(list, ui.fonts.title,
                  {bar.min.x + ui.px(size::k_padding), bar.center().y - 0.5F * ui.fonts.title->FontSize}, color::k_text,
                  look.title);
  dismissed_ = view::icon_button(ui, std::string(look.name) + ".close", {bar.max.x - ui.px(15), bar.center().y},
                                 view::Icon::close, {"Close", "Leaves everything as it is. Esc does the same.", {}});
  return {{area.min.x + 1, bar.max.y + 1}, {area.max.x - 1, area.max.y - 1}};
}

bool DialogFrame::end(Ui& ui) {
  inner_ = !ui.state.open_popup.empty() || !ui.state.editing.empty();
  ImGui::End();
  ImGui::PopStyleVar(4);
  ui.blocked = blocked_before_;
  const bool left = open_ && (escaped_ || dismissed_);
  if (left) close(ui);
  return left;
}

std::optional<int> dialog_buttons(Ui& ui, std::string_view dialog, const Rectangle& area,
                                  std::span<const DialogButton> buttons) {
  float x = area.max.x;
  for (const DialogButton& one : buttons) x -= std::max(ui.px(84), view::button_width(ui, one.text)) + ui.px(8);
  x += ui.px(8);
  std::optional<int> chosen;
  for (std::size_t k = 0; k < buttons.size(); ++k) {
    const DialogButton& one = buttons[k];
    const float width = std::max(ui.px(84), view::button_width(ui, one.text));
    const Rectangle place{{x, area.min.y}, {x + width, area.min.y + ui.px(size::k_row)}};
    if (view::button(ui, std::string(dialog) + "." + one.key, place, one.text, one.explained,
                     one.is_primary ? view::ButtonKind::primary : view::ButtonKind::normal)) {
      chosen = static_cast<int>(k);
    }
    x += width + ui.px(8);
  }
  return chosen;
}

float draw_sentences(const Ui& ui, ImVec2 at, float width, ImU32 ink, std::string_view text) {
  for (const std::string& line : view::wrapped_text(ui.fonts.small, text, width)) {
    view::draw_text(*ImGui::GetWindowDrawList(), ui.fonts.small, at, ink, line);
    at.y += std::ceil(ui.fonts.small->FontSize) + ui.px(3);
  }
  return at.y;
}

std::string fitted_path(const ImFont* font, std::string_view path, float width) {
  if (view::text_size(font, path).x <= width) return std::string(path);
  std::string_view rest = path;
  const auto is_inside_letter = [&] { return !rest.empty() && (static_cast<unsigned char>(rest[0]) & 0xC0U) == 0x80U; };
  while (!rest.empty() && view::text_size(font, "…" + std::string(rest)).x > width) {
    rest.remove_prefix(1);
    while (is_inside_letter()) rest.remove_prefix(1);
  }
  return "…" + std::string(rest);
}

bool enter_pressed() {
  return pressed(Key::enter) || pressed(Key::keypad_enter);
}

std::optional<int> moved_row(Ui& ui, int selected, int count, int page) {
  if (count == 0) return std::nullopt;
  int row = selected;
  if (ui.state.focus.down != 0) {
    row = selected < 0 ? (ui.state.focus.down > 0 ? 0 : count - 1) : selected + ui.state.focus.down;
    ui.state.focus.down = 0;
  } else if (pressed(Key::page_down, true)) {
    row = std::max(0, selected) + page;
  } else if (pressed(Key::page_up, true)) {
    row = std::max(0, selected) - page;
  } else if (pressed(Key::home)) {
    row = 0;
  } else if (pressed(Key::end)) {
    row = count - 1;
  } else {
    return std::nullopt;
  }
  return std::clamp(row, 0, count - 1);
}

}  // namespace glint::gui
