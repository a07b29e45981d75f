#include "gui/dialogs/export_dialog.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "gui/dialogs/file_listing.h"
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

constexpr std::string_view k_path = "export.path";
constexpr int k_first_of_data = 4;  // the kinds before it are pictures of the screen

float row_height(const Ui& ui) {
  return ui.px(38);
}
float heading_height(const Ui& ui) {
  return ui.px(26);
}
float row_top(const Ui& ui, int row) {
  return static_cast<float>(row) * row_height(ui) + heading_height(ui) * (row >= k_first_of_data ? 2.0F : 1.0F);
}

std::string reason_of(const ExportInput& input, ExportWhat what) {
  return input.reason_disabled ? input.reason_disabled(what) : std::string();
}

std::string list_of(std::span<const std::string_view> extensions) {
  std::string text;
  for (const std::string_view one : extensions) text += (text.empty() ? "" : " or ") + std::string(one);
  return text;
}

void draw_radio(const Ui& ui, ImVec2 center, bool chosen, bool enabled) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (enabled) list.AddCircleFilled(center, ui.px(7), chosen ? color::k_accent_ground : color::k_frame, 24);
  const ImU32 edge = !enabled ? color::k_border : chosen ? color::k_accent : color::k_border_strong;
  list.AddCircle(center, ui.px(7), edge, 24, std::max(1.0F, std::floor(ui.scale)));
  if (chosen && enabled) list.AddCircleFilled(center, ui.px(3), color::k_accent_hover, 16);
}

}  // namespace

std::span<const ExportKind> export_kinds() {
  static const std::array kinds{
      ExportKind{ExportWhat::window, "window", "Whole window", "A PNG of everything that is on screen.", {".png"}},
      ExportKind{ExportWhat::map_panel, "map", "Normal map panel", "A PNG of the panel as it is on screen.", {".png"}},
      ExportKind{ExportWhat::pndf_panel, "pndf", "P-NDF panel", "A PNG of the panel as it is on screen.", {".png"}},
      ExportKind{ExportWhat::inspector, "inspector", "Inspector", "A PNG of the panel as it is on screen.", {".png"}},
      ExportKind{ExportWhat::pndf_images,
                 "images",
                 "P-NDF images",
                 "An EXR with the densities of every method and all settings: opening it restores the document.",
                 {".exr"}},
      ExportKind{ExportWhat::pndf_picture,
                 "picture",
                 "P-NDF picture",
                 "A PNG of the pictures in false colour, with the colour scale beside them.",
                 {".png"}},
      ExportKind{ExportWhat::normal_map,
                 "normals",
                 "Normal map",
                 "The map as it was read or generated: floats in an EXR, or 16 bits in a PNG.",
                 {".exr", ".png"}},
      ExportKind{ExportWhat::values,
                 "values",
                 "Values at the crosshair",
                 "A CSV table with the density of every method at that normal.",
                 {".csv"}},
  };
  return kinds;
}

void ExportDialog::open(ExportWhat what) {
  const std::span<const ExportKind> kinds = export_kinds();
  chosen_ = static_cast<int>(std::ranges::find(kinds, what, &ExportKind::what) - kinds.begin());
  reveal_ = true;
  path_.clear();
  typed_ = false;
  confirmed_.clear();
  frame_.open();
}

void ExportDialog::set_file(const fs::path& file) {
  path_ = file.string();
  typed_ = true;
  confirmed_ = file;  // the file browser has asked
}

void ExportDialog::suggest(const ExportInput& input) {
  const std::string name = slug(input.document) + "-" + std::string(kind().key) + std::string(kind().extensions[0]);
  path_ = (input.folder / name).string();
}

void ExportDialog::choose(int row, const ExportInput& input) {
  if (row == chosen_) return;
  chosen_ = row;
  confirmed_.clear();
  if (!typed_) {
    suggest(input);
  } else if (std::ranges::find(kind().extensions, fs::path(path_).extension().string()) == kind().extensions.end()) {
    path_ = fs::path(path_).replace_extension(kind().extensions[0]).string();
  }
}

ExportDialog::Check ExportDialog::check(const std::string& text, const ExportInput& input) const {
  Check check;
  check.file = typed_path(text, input.folder);
  check.reason = reason_of(input, kind().what);
  if (!check.reason.empty()) return check;
  std::error_code error;
  const fs::path folder = check.file.parent_path();
  if (text.find_first_not_of(' ') == std::string::npos || text.ends_with('/') || fs::is_directory(check.file, error)) {
    check.reason = "Give the file a name.";
  } else if (std::ranges::find(kind().extensions, check.file.extension().string()) == kind().extensions.end()) {
    check.reason = fmt::format("The name of this file ends in {}.", list_of(kind().extensions));
  } else if (!fs::is_directory(folder, error)) {
    check.reason = fmt::format("There is no folder “{}”.", shown_path(folder));
  } else if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    check.reason = "You have no permission to write into this folder.";
  } else {
    check.exists = fs::exists(check.file, error);
  }
  return check;
}

void ExportDialog::draw_kind(Ui& ui, int row, const Rectangle& area, const ExportInput& input) {
  const ExportKind& one = export_kinds()[static_cast<std::size_t>(row)];
  const std::string reason = reason_of(input, one.what);
  const std::string name = "export.what." + std::string(one.key);
  const view::Press press = view::pressable(ui, name, area, {std::string(one.label), std::string(one.text), reason});
  ui.widgets.record(name, {area, reason, false, false});
  if (press.pressed) {
    ui.state.focus.name = "export.what";
    choose(row, input);
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool chosen = row == chosen_;
  if (press.hovered && press.enabled) list.AddRectFilled(area.min, area.max, color::k_frame, ui.px(3));
  if (chosen && ui.state.focus.name == "export.what") list.AddRect(area.min, area.max, color::k_accent, ui.px(3));
  draw_radio(ui, {area.min.x + ui.px(14), area.min.y + ui.px(12)}, chosen, press.enabled);
  const float x = area.min.x + ui.px(30);
  view::draw_text(list, ui.fonts.text, {x, area.min.y + ui.px(12) - 0.5F * ui.fonts.text->FontSize},
                  press.enabled ? color::k_text : color::k_disabled, one.label);
  const std::string text = view::fitted_text(ui.fonts.small, reason.empty() ? one.text : std::string_view(reason),
                                             area.max.x - x - ui.px(6));
  view::draw_text(list, ui.fonts.small, {x, area.min.y + ui.px(19)}, press.enabled ? color::k_hint : color::k_disabled,
                  text);
}

bool ExportDialog::draw_kinds(Ui& ui, const Rectangle& area, const ExportInput& input) {
  bool entered = false;
  const int count = static_cast<int>(export_kinds().size());
  ui.widgets.record("export.what", {area, {}, true, false});
  if (ui.state.focus.name == "export.what" && ui.state.editing.empty()) {
    if (const std::optional<int> moved = moved_row(ui, chosen_, count, 4)) {
      choose(*moved, input);
      reveal_ = true;
    }
    entered = std::exchange(ui.state.focus.activate, false);
  }
  ImGui::SetCursorScreenPos(area.min);
  ImGui::BeginChild("##kinds", area.size(), false, ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBackground);
  if (reveal_) {
    const float top = row_top(ui, chosen_);
    if (top < ImGui::GetScrollY()) ImGui::SetScrollY(top);
    if (top + row_height(ui) > ImGui::GetScrollY() + area.height()) {
      ImGui::SetScrollY(top + row_height(ui) - area.height());
    }
    reveal_ = false;
  }
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const auto heading = [&](int before, std::string_view text) {
    const float bottom = origin.y + row_top(ui, before) - ui.px(4);
    view::draw_text(*ImGui::GetWindowDrawList(), ui.fonts.small,
                    {origin.x + ui.px(8), bottom - ui.fonts.small->FontSize}, color::k_hint, text);
  };
  heading(0, "What is on screen");
  heading(k_first_of_data, "What was computed");
  for (int row = 0; row < count; ++row) {
    const float y = origin.y + row_top(ui, row);
    draw_kind(ui, row, {{area.min.x, y}, {area.max.x - ui.px(12), y + row_height(ui) - ui.px(1)}}, input);
  }
  ImGui::SetCursorScreenPos(origin);
  ImGui::Dummy({1, row_top(ui, count)});
  ImGui::EndChild();
  return entered;
}

bool ExportDialog::draw_path(Ui& ui, const Rectangle& area, bool& browse) {
  const std::string text = "Browse…";
  const float button = view::button_width(ui, text);
  const Rectangle place{{area.min.x + ui.px(34), area.min.y}, {area.max.x - button - ui.px(8), area.max.y}};
  view::draw_text(*ImGui::GetWindowDrawList(), ui.fonts.text,
                  {area.min.x, area.center().y - 0.5F * ui.fonts.text->FontSize}, color::k_text_2, "File");
  const std::string shown = fitted_path(ui.fonts.numbers, shown_path(path_), place.width() - ui.px(16));
  const std::optional<std::string> typed =
      view::entry(ui, k_path, place, shown, {},
                  {"Where to", "A path; ~ is your home folder. Its ending says how it is written.", {}}, path_, true);
  browse = view::button(ui, "export.browse", {{area.max.x - button, area.min.y}, area.max}, text,
                        {"Choose a folder and a name", {}, {}});
  if (!typed) return false;
  typed_ = typed_ || *typed != path_;
  path_ = *typed;
  return enter_pressed();
}

void ExportDialog::draw_status(const Ui& ui, const Rectangle& area, const Check& check) const {
  if (!confirmed_.empty() && check.exists) {
    view::draw_icon(ui, *ImGui::GetWindowDrawList(), view::Icon::warning,
                    {area.min.x + ui.px(7), area.min.y + 0.5F * ui.fonts.small->FontSize}, color::k_text);
    draw_sentences(ui, {area.min.x + ui.px(20), area.min.y}, area.width(), color::k_text,
                   fmt::format("“{}” exists: Replace writes over it.", shown_path(check.file.filename())));
  } else if (!check.reason.empty()) {
    draw_sentences(ui, area.min, area.width(), color::k_text_2, check.reason);
  } else if (check.exists) {
    draw_sentences(ui, area.min, area.width(), color::k_hint, "This file exists.");
  }
}

std::optional<ExportChoice> ExportDialog::draw(Ui& ui, const ExportInput& input) {
  if (!is_open()) return std::nullopt;
  if (path_.empty() && !typed_) suggest(input);
  const Rectangle room = frame_.begin(ui, {"export", "Export", {600, 488}, "export.what"});
  if (frame_.escaped() && !confirmed_.empty()) {
    confirmed_.clear();
    frame_.keep_open();
  }
  const float pad = ui.px(size::k_padding);
  const float row = ui.px(size::k_row);
  const Rectangle in{{room.min.x + pad, room.min.y + ui.px(4)}, {room.max.x - pad, room.max.y - pad}};
  const Rectangle bottom{{in.min.x, in.max.y - row}, in.max};
  const Rectangle status{{in.min.x + ui.px(34), bottom.min.y - ui.px(24)}, {in.max.x, bottom.min.y - ui.px(4)}};
  const Rectangle path{{in.min.x, status.min.y - ui.px(6) - row}, {in.max.x, status.min.y - ui.px(6)}};
  bool entered = draw_kinds(ui, {in.min, {in.max.x, path.min.y - ui.px(8)}}, input);
  bool browse = false;
  if (draw_path(ui, path, browse)) entered = true;
  const Check now = check(ui.state.editing == k_path ? ui.state.text : path_, input);
  if (now.file != confirmed_) confirmed_.clear();
  draw_status(ui, status, now);
  const std::string verb = now.exists && !confirmed_.empty() ? "Replace" : "Export";
  const std::array buttons{
      DialogButton{"cancel", "Cancel", {"Cancel", "Writes nothing.", {}}},
      DialogButton{"accept", verb, {verb, {}, now.reason}, true},
  };
  const std::optional<int> pressed = dialog_buttons(ui, "export", bottom, buttons);
  std::optional<ExportChoice> choice;
  if (browse) {
    choice = ExportChoice{kind().what, now.file, true};
  } else if ((pressed == 1 || entered) && now.reason.empty()) {
    if (now.exists && confirmed_ != now.file) {
      confirmed_ = now.file;
      ui.state.focus.name = "export.accept";
    } else {
      choice = ExportChoice{kind().what, now.file, false};
    }
  }
  if ((choice && !choice->browse) || pressed == 0) frame_.close(ui);
  frame_.end(ui);
  return choice;
}

}  // namespace glint::gui
