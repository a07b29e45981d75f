#include "gui/dialogs/browser_path.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "gui/dialogs/dialog_frame.h"
#include "gui/input/chord.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::gui {
namespace {

namespace fs = std::filesystem;
using view::Rectangle;
using view::Ui;
namespace color = view::color;
namespace size = view::size;

constexpr std::string_view k_entry = "browser.path";

int pressed(Key key) {
  return ImGui::IsKeyPressed(static_cast<int>(key)) ? 1 : 0;
}

}  // namespace

Rectangle PathBar::suggestions_area(const Ui& ui) const {
  const float height = static_cast<float>(suggestions_.size()) * ui.px(size::k_row) + ui.px(8);
  return {{entry_.min.x, entry_.max.y + ui.px(2)}, {entry_.max.x, entry_.max.y + ui.px(2) + height}};
}

PathBar::Event PathBar::draw(Ui& ui, const Rectangle& area, const fs::path& folder, const FileFilter& filter,
                             bool may_be_new) {
  Event event;
  const bool at_root = !parent_of(folder);
  event.parent = view::icon_button(
      ui, "browser.parent", {area.min.x + ui.px(12), area.center().y}, view::Icon::up,
      {"The folder above", "Backspace does the same in the list.", at_root ? "This is the topmost folder." : ""});
  entry_ = {{area.min.x + ui.px(30), area.min.y}, area.max};
  std::string whole = shown_path(folder);
  if (!whole.ends_with('/')) whole += '/';
  const bool was_editing = ui.state.editing == k_entry;
  const std::optional<std::string> typed = view::entry(
      ui, k_entry, entry_, fitted_path(ui.fonts.numbers, shown_path(folder), entry_.width() - ui.px(16)), {},
      {"Where you are", "Type a folder or a file and press Enter to go there; ~ is your home folder.", {}}, whole,
      true);
  const bool editing = ui.state.editing == k_entry;
  if (editing && !was_editing) began_with_ = ui.state.text;
  if (typed) {
    event.go = destination(ui, *typed, folder, may_be_new);
  } else if (editing) {
    suggest(ui, folder, filter);
  }
  if (ui.state.editing != k_entry) {
    suggestions_.clear();
    suggested_for_.clear();
    highlighted_ = -1;
  }
  return event;
}

void PathBar::suggest(Ui& ui, const fs::path& folder, const FileFilter& filter) {
  const std::string& text = ui.state.text;
  if (text != suggested_for_) {
    if (!suggested_for_.empty()) ui.state.editing_error.clear();
    suggested_for_ = text;
    highlighted_ = -1;
    suggestions_ = text == began_with_ ? std::vector<std::string>() : completions(text, folder, filter);
  }
  const int count = static_cast<int>(suggestions_.size());
  highlighted_ = std::clamp(highlighted_ + pressed(Key::down) - pressed(Key::up), -1, count - 1);
  ui.state.focus.down = 0;
}

std::optional<fs::path> PathBar::destination(Ui& ui, const std::string& text, const fs::path& folder,
                                             bool may_be_new) const {
  const bool entered = enter_pressed();
  std::string wanted = text;
  const Rectangle area = suggestions_area(ui);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (entered && highlighted_ >= 0) {
    wanted = suggestions_[static_cast<std::size_t>(highlighted_)];
  } else if (!entered && !suggestions_.empty() && ImGui::IsMouseClicked(0) && area.contains(mouse)) {
    const auto row = static_cast<std::size_t>(std::max(0.0F, (mouse.y - area.min.y - ui.px(4)) / ui.px(size::k_row)));
    wanted = suggestions_[std::min(row, suggestions_.size() - 1)];
  } else if (text == began_with_) {
    return std::nullopt;
  }
  fs::path path = typed_path(wanted, folder);
  std::error_code error;
  if (fs::exists(path, error)) return path;
  if (entered && suggestions_.size() == 1) return typed_path(suggestions_[0], folder);
  if (may_be_new && fs::is_directory(path.parent_path(), error)) return path;
  if (entered) view::refuse_entry(ui, k_entry, text, fmt::format("There is nothing at “{}”.", shown_path(path)));
  return std::nullopt;
}

void PathBar::draw_suggestions(Ui& ui) {
  if (suggestions_.empty()) return;
  const Rectangle area = suggestions_area(ui);
  ImGui::SetCursorScreenPos(area.min);
  ImGui::BeginChild("##suggestions", area.size(), false,
                    ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(area.min, area.max, color::k_popup, ui.px(4));
  list.AddRect(area.min, area.max, color::k_border_strong, ui.px(4));
  float y = area.min.y + ui.px(4);
  for (std::size_t k = 0; k < suggestions_.size(); ++k) {
    const Rectangle row{{area.min.x + ui.px(4), y}, {area.max.x - ui.px(4), y + ui.px(size::k_row)}};
    const bool hovered = ImGui::IsWindowHovered() && row.contains(ImGui::GetIO().MousePos);
    if (hovered || highlighted_ == static_cast<int>(k)) {
      list.AddRectFilled(row.min, row.max, color::k_frame_hover, ui.px(3));
    }
    const bool is_folder = suggestions_[k].ends_with('/');
    const fs::path path(is_folder ? suggestions_[k].substr(0, suggestions_[k].size() - 1) : suggestions_[k]);
    const std::string name = shown_path(path.filename()) + (is_folder ? "/" : "");
    ui.widgets.record("browser.suggestion." + shown_path(path.filename()), {row, {}, false, false});
    view::draw_icon(ui, list, is_folder ? view::Icon::folder : view::Icon::file,
                    {row.min.x + ui.px(12), row.center().y}, color::k_text_2);
    view::draw_text(list, ui.fonts.text, {row.min.x + ui.px(26), row.center().y - 0.5F * ui.fonts.text->FontSize},
                    color::k_text, view::fitted_text(ui.fonts.text, name, row.width() - ui.px(34)));
    y += ui.px(size::k_row);
  }
  ImGui::EndChild();
}

}  // namespace glint::gui
