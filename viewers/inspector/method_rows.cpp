#include "viewers/inspector/method_rows.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/document/names.h"
#include "viewers/inspector/field_edits.h"
#include "viewers/inspector/read_report_rows.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"

namespace glint::view {
namespace {

const Parameter& field(std::string_view path) {
  return *find_parameter(path);
}

bool is_on(const Document& document, PndfMethod method) {
  return std::find(document.methods.begin(), document.methods.end(), method) != document.methods.end();
}

// Box, mark and name; returns the room to their right.
Rectangle method_name(FieldPage& page, const Rectangle& row, PndfMethod method) {
  Ui& ui = page.ui;
  const float controls = page.left + ui.px(page.compact ? 92.0F : 104.0F);
  const Rectangle box{row.min, {controls - ui.px(6), row.max.y}};
  choice_box(page, field("methods"), choice_name(method), box, "");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_mark(list, method, {row.min.x + ui.px(27), row.center().y}, ui.px(4));
  draw_text(list, ui.fonts.text, {row.min.x + ui.px(38), row.center().y - 0.5F * ui.fonts.text->FontSize},
            is_on(page.document, method) ? color::k_text : color::k_disabled, method_title(method));
  return {{controls, row.min.y}, row.max};
}

void triangles_control(FieldPage& page, const Rectangle& area, Interpolation now) {
  Ui& ui = page.ui;
  const Parameter& parameter = field("surface.interpolation");
  const int chosen = now == Interpolation::linear ? 0 : now == Interpolation::smooth ? 1 : -1;
  constexpr std::array<std::string_view, 2> k_counts{"2", "32"};
  const Explained explained{"Triangles per texel",
                            "How finely the surface between the samples is cut: 2 is the linear surface, 32 the smooth "
                            "one. It is the surface "
                            "of every method.\nYan et al. 2014, 2 or 32 triangles per texel.",
                            {}};
  const auto picked = switch_of(ui, "exact.triangles", area.min, k_counts, k_counts, chosen, explained);
  const float x = area.min.x + switch_width(ui, k_counts) + ui.px(8);
  const std::string_view caption = now == Interpolation::constant ? "constant" : "triangles";
  draw_text(*ImGui::GetWindowDrawList(), ui.fonts.small, {x, area.center().y - 0.5F * ui.fonts.small->FontSize},
            color::k_text_2, fitted_text(ui.fonts.small, caption, area.max.x - x));
  if (!picked) return;
  const std::string surface(choice_name(*picked == 0 ? Interpolation::linear : Interpolation::smooth));
  if (Result<Edit> edit = proposed(page.document, parameter, surface)) page.edit = std::move(*edit);
}

std::string shift_reason(const Document& document, Interpolation now) {
  if (!is_on(document, PndfMethod::exact)) return "The exact method is off.";
  if (now == Interpolation::smooth) return {};
  return "Only the smooth surface has vertices to shift: choose 32 triangles.";
}

void exact_rows(FieldPage& page, Interpolation now) {
  triangles_control(page, method_name(page, take_row(page), PndfMethod::exact), now);
  const Parameter& shift = field("exact.vertex_shift");
  const Rectangle row = take_row(page);
  const float x = page.left + page.ui.px(page.compact ? 92.0F : 104.0F);
  const bool on = page.document.exact_vertex_shift;
  const Rectangle area{{x, row.min.y}, row.max};
  const Explained explained = explain_parameter(shift, shift_reason(page.document, now));
  if (checkbox(page.ui, shift.path, area, "vertex shift", on, explained)) {
    if (Result<Edit> edit = proposed(page.document, shift, !on)) page.edit = std::move(*edit);
  }
  reset_control(page, shift, row);
  field_row(page, field("exact.precision"),
            {.reason = is_on(page.document, PndfMethod::exact) ? "" : "The exact method is off."});
}

void finding_rows(FieldPage& page, PndfMethod method, const PndfResults* results) {
  if (results == nullptr || !is_on(page.document, method)) return;
  for (const MethodPicture& picture : results->methods) {
    if (picture.method != method) continue;
    for (std::size_t k = 0; k < picture.findings.size(); ++k) {
      const float top = page.y;
      sentence_row(page, sentence_text(picture.findings[k]), true);
      page.ui.widgets.record(fmt::format("{}.finding.{}", choice_name(method), k),
                             {{{page.left, top}, {page.right, page.y}}, {}, false, false});
    }
  }
}

void mixture_rows(FieldPage& page, const PndfResults* results) {
  const std::string reason = is_on(page.document, PndfMethod::mixture) ? "" : "The mixture method is off.";
  const Rectangle row = take_row(page);
  number_controls(page, field("mixture.step"), method_name(page, row, PndfMethod::mixture), {.reason = reason});
  reset_control(page, field("mixture.step"), row);
  field_row(page, field("mixture.elements"), {.reason = reason});
  field_row(page, field("mixture.kappa"), {.reason = reason});
  finding_rows(page, PndfMethod::mixture, results);
}

void lean_row(FieldPage& page) {  // which has no settings of its own
  method_name(page, take_row(page), PndfMethod::lean);
}

void auto_row(FieldPage& page) {
  const std::string reason = is_on(page.document, PndfMethod::automatic) ? "" : "The auto method is off.";
  const Rectangle row = take_row(page);
  number_controls(page, field("auto.tolerance"), method_name(page, row, PndfMethod::automatic), {.reason = reason});
  reset_control(page, field("auto.tolerance"), row);
}

void binning_rows(FieldPage& page) {
  const std::string reason = is_on(page.document, PndfMethod::binning) ? "" : "The binning method is off.";
  const Rectangle row = take_row(page);
  number_controls(page, field("binning.samples"), method_name(page, row, PndfMethod::binning), {.reason = reason});
  reset_control(page, field("binning.samples"), row);
  field_row(page, field("seed"), {.reason = reason});
}

}  // namespace

Interpolation interpolation_on(const Document& document, const NormalMap* map) {
  const bool flakes = map != nullptr && map->piecewise_constant();
  return document.surface.interpolation.value_or(flakes ? Interpolation::constant : Interpolation::smooth);
}

void method_rows(FieldPage& page, const Rectangle& header, const NormalMap* map, const PndfResults* results) {
  reset_control(page, field("methods"), header);
  exact_rows(page, interpolation_on(page.document, map));
  mixture_rows(page, results);
  lean_row(page);
  auto_row(page);
  binning_rows(page);
}

}  // namespace glint::view
