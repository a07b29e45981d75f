#include "viewers/inspector/reading_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/document/names.h"
#include "viewers/inspector/read_report_rows.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/number_text.h"
#include "viewers/widgets/theme.h"

namespace glint::view {
namespace {

constexpr double k_degrees = 180 / std::numbers::pi;

// One line: label in hint, values in columns from the right.
struct ReadingRow {
  std::string name;
  std::string label;
  std::string values;  // empty: not known yet
  std::optional<PndfMethod> mark = {};
  std::string more = {};  // in the tooltip
};

void draw_row(FieldPage& page, const ReadingRow& row) {
  Ui& ui = page.ui;
  const Rectangle area = take_row(page, k_reading_pitch, k_reading_pitch);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float x = area.min.x;
  if (row.mark) {
    draw_mark(list, *row.mark, {x + ui.px(5), area.center().y}, ui.px(4));
    x += ui.px(16);
  }
  draw_text(list, ui.fonts.small, {x, area.center().y - 0.5F * ui.fonts.small->FontSize},
            row.mark ? color::k_text_2 : color::k_hint, row.label);
  const bool known = !row.values.empty();
  draw_text_right(list, ui.fonts.small_numbers, {area.max.x, area.center().y - 0.5F * ui.fonts.small_numbers->FontSize},
                  known ? color::k_text : color::k_hint, known ? std::string_view(row.values) : "…");
  ui.widgets.record(row.name, {area, {}, false, false});
  explain(ui, row.name, area, {row.label, row.more, {}});
}

std::string pair_text(double first, double second, int decimals, std::string_view unit) {
  return fmt::format("{}{}  {}{}", decimal_text(first, decimals), unit, decimal_text(second, decimals), unit);
}

std::string density_text(const std::optional<double>& density) {
  return density ? number_text(*density) : std::string();
}

}  // namespace

double tilt_of(glm::dvec2 s) {
  return std::asin(std::min(1.0, std::hypot(s.x, s.y))) * k_degrees;
}

double azimuth_of(glm::dvec2 s) {
  const double degrees = std::atan2(s.y, s.x) * k_degrees;
  return degrees < 0 ? degrees + 360 : degrees + 0.0;
}

void reading_rows(FieldPage& page, const PndfReading* reading) {
  if (!reading) {
    sentence_row(page, "Move the mouse over a picture of the P-NDF, or click in it to keep a normal.", false);
    return;
  }
  const glm::dvec2 s = reading->s;
  const std::string angles = pair_text(tilt_of(s), azimuth_of(s), 1, "°");
  draw_row(page, {"cursor.normal", "normal s, t", pair_text(s.x, s.y, 3, {}), {}, "tilt, azimuth: " + angles});
  if (!page.compact) {
    draw_row(page, {"cursor.angles",
                    "tilt, azimuth",
                    angles,
                    {},
                    "From the flat normal, and from the s axis towards the t axis."});
  }
  for (const PndfReading::Value& value : reading->values) {
    const std::string method(choice_name(value.method));
    std::string more = "The density of normals per unit of disk area.";
    if (value.standard_error) more += fmt::format(" Its own noise: ± {}.", number_text(*value.standard_error));
    std::string label = "D " + method;
    draw_row(page, {"cursor." + method, std::move(label), density_text(value.density), value.method, more});
  }
  if (reading->reference && !page.compact) {
    draw_row(page, {"cursor.reference",
                    "D reference",
                    density_text(reading->reference),
                    {},
                    "Exact in double precision on the same surface."});
  }
}

}  // namespace glint::view
