#include "gui/dialogs/preset_name_dialog.h"

#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/document/parameter.h"
#include "gui/dialogs/file_listing.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"

namespace glint::gui {
namespace {

namespace fs = std::filesystem;
using view::Rectangle;
using view::Ui;
namespace color = view::color;
namespace size = view::size;

constexpr std::string_view k_dialog = "preset_name";
constexpr std::string_view k_entry = "preset_name.entry";

}  // namespace

std::string preset_name_fault(const std::string& name) {
  if (name.find_first_not_of(' ') == std::string::npos) return "Type a name first.";
  const Result<ParameterValue> checked = find_parameter("name")->checked(name);
  return checked ? std::string() : "The name " + checked.error().sentence + ".";
}

void PresetNameDialog::open(std::string name) {
  name_ = std::move(name);
  begins_ = true;
  confirmed_.clear();
  frame_.open();
}

void PresetNameDialog::open_to_save(std::string name, std::optional<fs::path> folder) {
  folder_ = std::move(folder);
  own_file_.clear();
  open(std::move(name));
}

void PresetNameDialog::open_to_rename(std::string name, fs::path file) {
  folder_ = file.parent_path();
  own_file_ = std::move(file);
  open(std::move(name));
}

PresetNameDialog::Check PresetNameDialog::check(const std::string& name) const {
  Check check;
  check.reason = preset_name_fault(name);
  check.file = folder_.value_or(fs::path()) / (slug(name) + ".json");
  if (!check.reason.empty()) return check;
  if (!folder_) {
    check.reason = "There is no folder for your presets: choose another folder.";
    return check;
  }
  std::error_code error;
  check.exists = check.file != own_file_ && fs::exists(check.file, error);
  if (check.exists && fs::is_directory(check.file, error)) {
    check.reason = fmt::format("“{}” is a folder: take another name.", shown_path(check.file.filename()));
  } else if (check.exists && !own_file_.empty()) {
    check.reason =
        fmt::format("There is a preset in “{}” already: take another name.", shown_path(check.file.filename()));
  }
  return check;
}

void PresetNameDialog::draw_check(const Ui& ui, const Rectangle& area, const Check& check) const {
  ImVec2 at = area.min;
  if (!confirmed_.empty()) {
    const std::string text = fmt::format("“{}” exists: Save again to replace it.", shown_path(confirmed_.filename()));
    view::draw_icon(ui, *ImGui::GetWindowDrawList(), view::Icon::warning,
                    {at.x + ui.px(7), at.y + 0.5F * ui.fonts.small->FontSize}, color::k_text);
    draw_sentences(ui, {at.x + ui.px(20), at.y}, area.width() - ui.px(20), color::k_text, text);
    return;
  }
  if (!check.reason.empty()) {
    draw_sentences(ui, at, area.width(), color::k_text_2, check.reason);
    return;
  }
  const std::string_view caption = check.exists ? "Replaces the file" : own_file_.empty() ? "Saved as" : "Its file";
  at.y = draw_sentences(ui, at, area.width(), color::k_hint, caption);
  view::draw_text(*ImGui::GetWindowDrawList(), ui.fonts.small, at, color::k_text_2,
                  fitted_path(ui.fonts.small, shown_path(check.file), area.width()));
}

std::optional<PresetName> PresetNameDialog::draw(Ui& ui) {
  if (!is_open()) return std::nullopt;
  const bool saving = own_file_.empty();
  const Rectangle room =
      frame_.begin(ui, {k_dialog, saving ? "Save preset as" : "Rename the preset", {460, 156}, k_entry});
  if (frame_.escaped() && !confirmed_.empty()) {
    confirmed_.clear();
    frame_.keep_open();
  }
  const float pad = ui.px(size::k_padding);
  const float row = ui.px(size::k_row);
  const Rectangle in{{room.min.x + pad, room.min.y + pad}, {room.max.x - pad, room.max.y - pad}};
  if (begins_) view::refuse_entry(ui, k_entry, name_, {});
  begins_ = false;
  view::draw_text(*ImGui::GetWindowDrawList(), ui.fonts.text,
                  {in.min.x, in.min.y + 0.5F * (row - ui.fonts.text->FontSize)}, color::k_text_2, "Name");
  const std::optional<std::string> typed =
      view::entry(ui, k_entry, {{in.min.x + ui.px(52), in.min.y}, {in.max.x, in.min.y + row}}, name_, {},
                  {"Name of the preset", "Any letters; the file's name is made from it.", {}}, {}, true);
  if (typed) name_ = *typed;
  const Check now = check(ui.state.editing == k_entry ? ui.state.text : name_);
  if (now.file != confirmed_) confirmed_.clear();
  draw_check(ui, {{in.min.x + ui.px(52), in.min.y + row + ui.px(8)}, in.max}, now);

  const std::string verb = !confirmed_.empty() ? "Replace" : saving ? "Save" : "Rename";
  const std::vector<DialogButton> buttons{{"cancel", "Cancel", {"Cancel", "Leaves everything as it is.", {}}},
                                          {"accept", verb, {verb, {}, now.reason}, true}};
  const Rectangle bottom{{in.min.x, in.max.y - row}, in.max};
  std::optional<PresetName> result;
  const std::string other = "Other folder…";
  const std::string name_fault = preset_name_fault(name_);
  if (saving && view::button(ui, "preset_name.elsewhere",
                             {bottom.min, {bottom.min.x + view::button_width(ui, other), bottom.max.y}}, other,
                             {"Save in another folder", "Presets there are opened with File, Open.", name_fault})) {
    result = PresetName{PresetName::Wish::elsewhere, name_, now.file};
  }
  const std::optional<int> pressed = dialog_buttons(ui, k_dialog, bottom, buttons);
  if (typed && enter_pressed() && !now.reason.empty()) view::refuse_entry(ui, k_entry, name_, now.reason);
  const bool accepted = pressed == 1 || (typed && enter_pressed() && now.reason.empty());
  if (accepted && now.exists && confirmed_ != now.file) {
    confirmed_ = now.file;
    ui.state.focus.name = "preset_name.accept";
  } else if (accepted) {
    result = PresetName{saving ? PresetName::Wish::save : PresetName::Wish::rename, name_, now.file};
  }
  if (result || pressed == 0) frame_.close(ui);
  frame_.end(ui);
  return result;
}

}  // namespace glint::gui
