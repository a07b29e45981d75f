#include "viewers/inspector/inspector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/document/parameter.h"
#include "viewers/inspector/field_rows.h"
#include "viewers/inspector/inspector_sections.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/panel.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::view {
namespace {

constexpr float k_compact_below = 280;  // width of the panel
constexpr float k_labels = 92;
constexpr float k_gutter = 14;
constexpr float k_top_rows = 8 + 3 * size::k_row_pitch;
constexpr float k_before_section = 7;
constexpr float k_after_header = 6;
constexpr float k_section = k_before_section + size::k_section_header + k_after_header;

constexpr int k_frames_to_appear = 4;  // of a control: one to open its section, one to scroll, and room to spare

// Which sections get room first.
constexpr std::array<std::string_view, 6> k_by_importance{"section.surface", "section.footprint", "section.methods",
                                                          "section.cursor",  "section.map",       "section.picture"};

void preset_row(FieldPage& page, const InspectorInput& input, InspectorEvents& events) {
  const Rectangle row = take_row(page);
  row_label(page, row, "Preset");
  std::vector<std::string_view> names(input.presets.begin(), input.presets.end());
  const std::string& name = input.document.name;
  auto chosen = std::find(names.begin(), names.end(), name);
  if (chosen == names.end()) chosen = names.insert(names.begin(), name);
  const auto index = static_cast<int>(chosen - names.begin());
  const auto picked =
      combo(page.ui, "preset", control_area(page, row), names, index,
            {"Preset", "Surface, footprint, methods and pictures under one name. Choosing one opens it.", {}});
  if (picked) events.preset = std::string(names[static_cast<std::size_t>(*picked)]);
}

void modified_row(FieldPage& page, const InspectorInput& input, InspectorEvents& events) {
  Ui& ui = page.ui;
  const Rectangle row = take_row(page);
  if (!input.is_saved) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float middle = row.center().y;
    list.AddCircleFilled({row.min.x + ui.px(3), middle}, 3 * ui.scale, color::k_accent, 16);
    draw_text(list, ui.fonts.small, {row.min.x + ui.px(12), middle - 0.5F * ui.fonts.small->FontSize}, color::k_text_2,
              "modified");
  }
  const Rectangle area = control_area(page, row);
  events.save_as_pressed = button(ui, "preset.save_as", part_of(ui, area, 0, 2), "Save as…",
                                  {"Save under another name", "As a preset of your own.", {}});
  events.revert_pressed = button(ui, "preset.revert", part_of(ui, area, 1, 2), "Revert",
                                 {"Revert", "Back to the document as it was saved. It can be undone.",
                                  input.is_saved ? "Nothing differs from what was saved." : ""});
}

void name_row(FieldPage& page, const InspectorInput& input, InspectorEvents& events) {
  const float right = page.right;
  const float save = button_width(page.ui, "Save");
  const Rectangle area{{right - save, page.y}, {right, page.y + page.ui.px(size::k_row)}};
  events.save_pressed =
      button(page.ui, "preset.save", area, "Save",
             {"Save", "Writes the preset of this name.", input.is_saved ? "Nothing differs from what was saved." : ""});
  page.right = area.min.x - page.ui.px(6);
  field_row(page, *find_parameter("name"));
  page.right = right;
}

// Ground, arrow, name and summary; true when pressed.
bool section_header(FieldPage& page, const Rectangle& bar, const InspectorSection& section, const InspectorInput& input,
                    bool open) {
  Ui& ui = page.ui;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Press press = pressable(ui, section.name, {bar.min, {page.right, bar.max.y}}, {});
  list.AddRectFilled(bar.min, bar.max, press.hovered ? color::k_frame_hover : color::k_section);
  list.AddLine(bar.min, {bar.max.x, bar.min.y}, color::k_border);
  if (press.focused) {
    list.AddRect({bar.min.x + 1, bar.min.y + 1}, {bar.max.x - 1, bar.max.y}, color::k_accent, ui.px(3));
  }
  const float middle = bar.center().y;
  draw_icon(ui, list, open ? Icon::arrow_down : Icon::arrow_right, {page.left + ui.px(4), middle}, color::k_text_2);
  const std::string_view title = section.title(input.document);
  const float x = page.left + ui.px(14);
  draw_text(list, ui.fonts.title, {x, middle - 0.5F * ui.fonts.title->FontSize}, color::k_text, title);
  const float room = page.right - x - text_size(ui.fonts.title, title).x - ui.px(12);
  const std::string summary = fitted_text(ui.fonts.small, section.summary(input, open), room);
  draw_text_right(list, ui.fonts.small, {page.right, middle - 0.5F * ui.fonts.small->FontSize}, color::k_hint, summary);
  return press.pressed;
}

FieldPage page_in(Ui& ui, const Rectangle& panel, const Rectangle& content, const InspectorInput& input) {
  FieldPage page{ui, input.document, input.saved};
  page.left = panel.min.x + ui.px(size::k_padding);
  page.controls = page.left + ui.px(k_labels);
  page.right = panel.max.x - ui.px(size::k_padding + k_gutter);
  page.compact = panel.width() < ui.px(k_compact_below);
  page.y = content.min.y - ImGui::GetScrollY() + ui.px(8);
  return page;
}

// Scrolls until the widget of that name is seen; true when it is.
bool scroll_to(const Ui& ui, const std::string& name, const Rectangle& content) {
  const WidgetRecord::Entry* const entry = ui.widgets.find(name);
  if (!entry) return false;
  const float margin = ui.px(8);
  const float above = content.min.y + margin - entry->area.min.y;
  const float below = entry->area.max.y + margin - content.max.y;
  if (above <= 0 && below <= 0) return true;
  ImGui::SetScrollY(std::max(0.0F, ImGui::GetScrollY() + (above > 0 ? -above : below)));
  return false;
}

}  // namespace

bool Inspector::is_open(const std::string& section, const InspectorInput& input) const {
  if (input.open_sections) {
    const auto remembered = input.open_sections->find(section);
    if (remembered != input.open_sections->end()) return remembered->second;
  }
  const auto found = open_by_default_.find(section);
  return found != open_by_default_.end() && found->second;
}

void Inspector::decide_what_is_open(const Ui& ui, const Rectangle& content, bool compact, const InspectorInput& input) {
  if (decided_for_.x == content.width() && decided_for_.y == content.height()) return;
  decided_for_ = content.size();
  const std::span<const InspectorSection> sections = inspector_sections();
  float room = content.height() / ui.scale - k_top_rows - static_cast<float>(sections.size()) * k_section;
  for (const std::string_view name : k_by_importance) {
    const auto section = std::find_if(sections.begin(), sections.end(), [&](const auto& s) { return s.name == name; });
    const float height = section->height(input, compact);
    open_by_default_[std::string(name)] = height <= room;
    if (height <= room) room -= height;
  }
}

InspectorEvents Inspector::draw(Ui& ui, const Rectangle& area, const InspectorInput& input) {
  InspectorEvents events;
  PanelHeader header;
  header.name = "inspector";
  header.title = "Inspector";
  header.hint = "everything that can be set";
  header.help =
      "Every field of the document, with its unit, range and paper. An orange arrow takes a field back to what "
      "was saved. Values are typed, slid or stepped with the arrow keys.";
  header.focused = input.focused;
  header.maximised = input.maximised;
  Rectangle content;
  const PanelEvents panel = begin_panel(ui, header, area, content, true);
  events.clicked = panel.clicked;
  events.maximise_pressed = panel.maximise_pressed;
  events.export_pressed = panel.export_pressed;

  FieldPage page = page_in(ui, area, content, input);
  document_ = input.document;
  decide_what_is_open(ui, content, page.compact, input);
  const std::string wanted_section(wanted_.empty() ? "" : section_of(wanted_, input.document).value_or(""));
  preset_row(page, input, events);
  modified_row(page, input, events);
  name_row(page, input, events);
  for (const InspectorSection& section : inspector_sections()) {
    page.y += ui.px(k_before_section);
    const Rectangle bar{{content.min.x, page.y}, {content.max.x, page.y + ui.px(size::k_section_header)}};
    const std::string name(section.name);
    const bool was_open = is_open(name, input);
    const bool open = was_open || name == wanted_section;
    if (section_header(page, bar, section, input, open)) {
      events.section = {name, !open};
    } else if (open != was_open) {
      events.section = {name, open};
    }
    page.y = bar.max.y + (open ? ui.px(k_after_header) : 0.0F);
    if (open) section.draw({page, input, events, {bar.min, {page.right, bar.max.y}}});
  }
  ImGui::SetCursorScreenPos({content.min.x, page.y + ui.px(8)});
  ImGui::Dummy({1, 1});
  if (!wanted_.empty() && (scroll_to(ui, wanted_, content) || --frames_for_wanted_ <= 0)) wanted_.clear();
  end_panel();
  events.edit = std::move(page.edit);
  return events;
}

bool Inspector::bring_to_view(const std::string& name) {
  if (!document_ || !section_of(name, *document_)) return false;
  wanted_ = name;
  frames_for_wanted_ = k_frames_to_appear;
  return true;
}

}  // namespace glint::view
