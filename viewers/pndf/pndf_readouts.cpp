#include "viewers/pndf/pndf_readouts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/document/names.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"

namespace glint::view {
namespace {

constexpr std::string_view k_unknown = "…";
constexpr float k_unit_gap = 5;

std::string recorded(std::string_view figure, PndfMethod method) {
  return fmt::format("pndf.{}.{}", figure, choice_name(method));
}

std::string text_of(const Quantity& quantity) {
  return quantity.unit.empty() ? quantity.value : quantity.value + " " + quantity.unit;
}

// A value with its unit, or "…"; `at` is its left upper corner.
float value_width(const Ui& ui, const ImFont* font, const std::optional<Quantity>& value) {
  if (!value) return text_size(font, k_unknown).x;
  const float unit = value->unit.empty() ? 0 : ui.px(k_unit_gap) + text_size(ui.fonts.small, value->unit).x;
  return text_size(font, value->value).x + unit;
}

void draw_value(const Ui& ui, ImDrawList& list, const ImFont* font, ImVec2 at, const std::optional<Quantity>& value) {
  if (!value) {
    draw_text(list, font, at, color::k_hint, k_unknown);
    return;
  }
  draw_text(list, font, at, color::k_text, value->value);
  const float x = at.x + text_size(font, value->value).x + ui.px(k_unit_gap);
  draw_text(list, ui.fonts.small, {x, at.y + 0.5F * (font->FontSize - ui.fonts.small->FontSize)}, color::k_text_2,
            value->unit);
}

void record_and_explain(Ui& ui, const Figure& figure, const Rectangle& area) {
  ui.widgets.record(figure.name, {area, {}, false, figure.varies});
  explain(ui, figure.name, area, figure.help);
}

float brief_width(const Ui& ui, const Figure& figure) {
  return figure.brief.empty() ? 0 : text_size(ui.fonts.small, figure.brief).x + ui.px(k_unit_gap);
}

float figure_width(const Ui& ui, const Figure& figure) {
  if (!figure.brief_value.empty()) return text_size(ui.fonts.small, figure.brief_value).x;
  return brief_width(ui, figure) + value_width(ui, ui.fonts.small_numbers, figure.value);
}

void draw_in_line(Ui& ui, ImVec2 at, const Figure& figure, bool with_brief) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImFont* font = ui.fonts.small_numbers;
  float x = at.x;
  if (!figure.brief_value.empty()) {
    draw_text(list, ui.fonts.small, {x, at.y + 0.5F * (font->FontSize - ui.fonts.small->FontSize)}, color::k_text_2,
              figure.brief_value);
    record_and_explain(ui, figure, {at, {x + figure_width(ui, figure), at.y + font->FontSize}});
    return;
  }
  if (with_brief && !figure.brief.empty()) {
    draw_text(list, ui.fonts.small, {x, at.y + 0.5F * (font->FontSize - ui.fonts.small->FontSize)}, color::k_hint,
              figure.brief);
    x += brief_width(ui, figure);
  }
  draw_value(ui, list, font, {x, at.y}, figure.value);
  const Rectangle area{at, {x + value_width(ui, font, figure.value), at.y + font->FontSize}};
  record_and_explain(ui, figure, area);
}

const char* k_time_help =
    "The time of this picture alone: the evaluation of all its cells on all threads, without building or waiting.";

}  // namespace

Figure time_figure(PndfMethod method, const MethodPicture* picture) {
  Figure figure{recorded("time", method), "Time", {}, std::nullopt, {}, {"Time", k_time_help, {}}, true};
  if (picture == nullptr || !picture->image) return figure;
  figure.value = time_text(picture->milliseconds);
  figure.help.title = fmt::format("Time {}", text_of(*figure.value));
  return figure;
}

Figure error_figure(PndfMethod method, const MethodPicture* picture, std::string_view surface) {
  Figure figure{recorded("error", method), "Relative L1", "L1", std::nullopt, {}, {"Relative L1", {}, {}}, false};
  if (picture == nullptr || !picture->errors) {
    figure.help.text = "The integral of |D − D_ref| over that of D_ref; known once the reference has been computed.";
    return figure;
  }
  const PndfErrors& errors = *picture->errors;
  figure.value = percent_text(errors.relative_l1);
  figure.help.title = fmt::format("Relative L1 {}", text_of(*figure.value));
  figure.help.text = fmt::format(
      "The integral of |D − D_ref| over that of D_ref, against the double-precision reference on the {} surface, whose "
      "own error is {}.\nPeak error {}, energy error {}.",
      surface, text_of(percent_text(picture->reference_error)), text_of(percent_text(errors.peak_error)),
      text_of(percent_text(errors.energy_error)));
  return figure;
}

Figure density_figure(PndfMethod method, const MethodPicture* picture, std::optional<glm::dvec2> cursor) {
  Figure figure{recorded("density", method), "D at cursor", "D", std::nullopt, {}, {}, false};
  figure.help = {
      "Density at the crosshair",
      "D(s), per unit of disk area, of the cell under the crosshair: where the mouse is, else where the last "
      "click pinned it.",
      {}};
  if (picture == nullptr || !picture->image) return figure;
  figure.value = Quantity{"–", {}};
  if (!cursor) return figure;
  const std::optional<CellReading> cell = read_cell(*picture->image, *cursor);
  if (!cell) return figure;
  figure.value = Quantity{number_text(cell->density), {}};
  figure.help.title = fmt::format("D = {}", number_text(cell->density, 6));
  if (cell->standard_error) {
    figure.help.title += fmt::format(" ± {} (standard error)", number_text(*cell->standard_error));
  }
  return figure;
}

Figure noise_figure(PndfMethod method, const MethodPicture* picture) {
  Figure figure{recorded("noise", method), "Own noise", "noise", std::nullopt, {}, {"Own noise", {}, {}}, false};
  if (picture == nullptr || !picture->image) return figure;
  const PndfError& error = picture->image->error;
  if (!picture->image->standard_error.empty()) {
    if (!error.estimated) return figure;
    figure.value = percent_text(*error.estimated);
    figure.value->value.insert(0, "± ");
    figure.help.text =
        "The relative L1 error that this picture's own randomness makes: an error below it says nothing.";
    return figure;
  }
  if (!picture->image->answer.text.empty() && error.estimated) {
    figure.caption = "Own error";
    figure.brief = "own";
    figure.value = percent_text(*error.total());
    figure.value->value.insert(0, "≈ ");
    figure.help = {"Own error",
                   fmt::format("What the method itself knows of its relative L1 error: an estimate of {}, made by "
                               "comparing with the next finer method, and at most {} of parts that are bounded.{}",
                               text_of(percent_text(*error.estimated)), text_of(percent_text(error.bounded)),
                               picture->image->answer.known ? "" : " The tolerance is not met by any method it has."),
                   {}};
    return figure;
  }
  figure.value = Quantity{"none", {}};
  figure.brief_value = "no noise";
  figure.help.text = "Nothing in this method is random.";
  if (error.bounded > 0) {
    figure.help.text += fmt::format(" What it {} is at most {} (relative L1).",
                                    error.estimated ? "cuts" : "merges or looks up in place of its elements",
                                    text_of(percent_text(error.bounded)));
  }
  if (!error.estimated) figure.help.text += " How far it is off the surface, it does not know.";
  return figure;
}

Figure difference_figure(const DifferenceImage* difference, std::optional<glm::dvec2> cursor) {
  Figure figure{"pndf.density.difference", "ΔD at cursor", "ΔD", std::nullopt, {}, {}, false};
  figure.help = {"Difference at the crosshair", "Of the cell under the crosshair, per unit of disk area.", {}};
  if (difference == nullptr) return figure;
  const std::optional<double> value = cursor ? difference_at(*difference, *cursor) : std::nullopt;
  figure.value = Quantity{value ? number_text(*value) : "–", {}};
  return figure;
}

Figure largest_difference_figure(const DifferenceImage* difference) {
  Figure figure{"pndf.largest.difference", "Largest", {}, std::nullopt, {}, {}, false};
  figure.help = {"Largest difference", "The largest magnitude over all cells of the picture.", {}};
  if (difference != nullptr) figure.value = Quantity{number_text(difference->largest), {}};
  return figure;
}

void draw_figure(Ui& ui, ImVec2 at, const Figure& figure) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_text(list, ui.fonts.small, at, color::k_hint, figure.caption);
  const ImVec2 value_at{at.x, at.y + ui.px(15)};
  draw_value(ui, list, ui.fonts.numbers, value_at, figure.value);
  const float width =
      std::max(text_size(ui.fonts.small, figure.caption).x, value_width(ui, ui.fonts.numbers, figure.value));
  record_and_explain(ui, figure, {at, {std::ceil(at.x + width), value_at.y + ui.fonts.numbers->FontSize}});
}

void draw_figure_line(Ui& ui, ImVec2 left, float right, const Figure& first, const Figure& second) {
  draw_in_line(ui, left, first, true);
  const bool brief =
      !second.brief_value.empty() || left.x + figure_width(ui, first) + figure_width(ui, second) + ui.px(8) <= right;
  const float width = figure_width(ui, second) - (brief ? 0 : brief_width(ui, second));
  draw_in_line(ui, {right - width, left.y}, second, brief);
}

float longest_figure_width(const Ui& ui, std::string_view brief) {
  const float number = text_size(ui.fonts.small_numbers, "−1.23×10⁻⁴").x;
  return number + (brief.empty() ? 0 : text_size(ui.fonts.small, brief).x + ui.px(k_unit_gap));
}

void draw_figure_at(Ui& ui, ImVec2 at, float right, const Figure& figure) {
  draw_in_line(ui, at, figure, at.x + longest_figure_width(ui, figure.brief) <= right);
}

}  // namespace glint::view
