#include "viewers/inspector/read_report_rows.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "core/document/names.h"
#include "viewers/inspector/field_edits.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"

namespace glint::view {
namespace {

void read_as_row(FieldPage& page, const ReadReport& report, const NormalMap& map) {
  Ui& ui = page.ui;
  const Rectangle row = take_row(page, 20, 24);
  row_label(page, row, "Read as");
  const FormatText format = format_text(report, map);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float middle = row.center().y;
  draw_text(list, ui.fonts.numbers, {page.controls, middle - 0.5F * ui.fonts.numbers->FontSize}, color::k_text,
            format.size);
  const float x = page.controls + text_size(ui.fonts.numbers, format.size).x + ui.px(7);
  std::string rest = format.rest;  // as much of the list as there is room for; the tooltip has all
  while (!rest.empty() && text_size(ui.fonts.small, rest).x > page.right - x) {
    rest.erase(std::min(rest.rfind(", "), rest.size() - 1));
  }
  draw_text(list, ui.fonts.small, {x, middle - 0.5F * ui.fonts.small->FontSize}, color::k_hint, rest);
  ui.widgets.record("surface.read_as", {row, {}, false, false});
  explain(ui, "surface.read_as", row, {"Read as", report_text(report, map), {}});
}

void suggested_green_row(FieldPage& page, GreenDirection suggested) {
  const Rectangle row = take_row(page);
  const Parameter& parameter = *find_parameter("surface.green");
  const std::string name(choice_name(suggested));
  const std::string text = fmt::format("Use green {}", name);
  Rectangle area = control_area(page, row);
  area.max.x = std::min(area.max.x, area.min.x + button_width(page.ui, text));
  const Explained explained{text, "The slopes of the map fit together only with green pointing the other way.", {}};
  if (!button(page.ui, "surface.use_suggested_green", area, text, explained)) return;
  const Result<Edit> edit = proposed(page.document, parameter, name);
  if (edit) page.edit = *edit;
}

}  // namespace

FormatText format_text(const ReadReport& report, const NormalMap& map) {
  FormatText text{fmt::format("{} × {}", map.width(), map.height()), report.format};
  const std::size_t comma = text.rest.rfind(", ");
  const std::string size = fmt::format("{} x {}", map.width(), map.height());
  if (comma != std::string::npos && text.rest.substr(comma + 2) == size) text.rest.erase(comma);
  return text;
}

std::string report_text(const ReadReport& report, const NormalMap& map) {
  const FormatText format = format_text(report, map);
  std::string text = fmt::format("{}, {}.", format.size, format.rest);
  for (const ReadReport::Note& note : report.notes) text += "\n" + sentence_text(note.sentence);
  return text;
}

void sentence_row(FieldPage& page, std::string_view sentence, bool warning) {
  Ui& ui = page.ui;
  const ImFont* font = ui.fonts.small;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float indent = warning ? ui.px(20) : 0.0F;
  const float pitch = ui.px(17);
  if (warning) {
    draw_icon(ui, list, Icon::warning, {page.left + ui.px(7), page.y + 0.5F * pitch}, color::k_text_2);
  }
  for (const std::string& line : wrapped_text(font, sentence, page.right - page.left - indent)) {
    draw_text(list, font, {page.left + indent, page.y + 0.5F * (pitch - font->FontSize)},
              warning ? color::k_text : color::k_hint, line);
    page.y += pitch;
  }
  page.y += ui.px(4);
}

void read_report_rows(FieldPage& page, const ReadReport& report, const NormalMap& map) {
  using Severity = ReadReport::Severity;
  if (!page.compact) read_as_row(page, report, map);
  for (const ReadReport::Note& note : report.notes) {
    const bool warning = note.severity == Severity::warning;
    if (warning || !page.compact) sentence_row(page, sentence_text(note.sentence), warning);
  }
  if (report.suggested_green) suggested_green_row(page, *report.suggested_green);
  if (const auto note = quantisation_note(report, page.document.intrinsic_roughness)) {
    sentence_row(page, sentence_text(*note), true);
  }
}

}  // namespace glint::view
