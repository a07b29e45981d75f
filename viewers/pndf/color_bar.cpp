#include "viewers/pndf/color_bar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/image/color_map.h"
#include "viewers/pndf/axis_ticks.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/number_text.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::view {
namespace {

constexpr std::string_view k_bar_name = "pndf.bar";
constexpr std::string_view k_highest_name = "view.density_range.highest";
constexpr std::string_view k_lowest_name = "view.density_range.lowest";
constexpr std::string_view k_difference_name = "view.difference_range";
constexpr int k_gradient_parts = 51;  // of the 255 steps of a table

ImU32 packed(DisplayColor c) {
  return IM_COL32(c.r, c.g, c.b, 255);
}

void draw_gradient(ImDrawList& list, const Rectangle& area, const std::array<DisplayColor, 256>& table, bool upright) {
  for (int k = 0; k < k_gradient_parts; ++k) {
    const auto color_of = [&](int part) { return packed(table[5 * static_cast<std::size_t>(part)]); };
    const float from = static_cast<float>(k) / k_gradient_parts;
    const float to = static_cast<float>(k + 1) / k_gradient_parts;
    const ImU32 a = color_of(k);
    const ImU32 b = color_of(k + 1);
    if (upright) {
      list.AddRectFilledMultiColor({area.min.x, area.max.y - to * area.height()},
                                   {area.max.x, area.max.y - from * area.height()}, b, b, a, a);
    } else {
      list.AddRectFilledMultiColor({area.min.x + from * area.width(), area.min.y},
                                   {area.min.x + to * area.width(), area.max.y}, a, b, b, a);
    }
  }
}

void frame_bar(ImDrawList& list, const Rectangle& area) {
  list.AddRect({area.min.x - 1, area.min.y - 1}, {area.max.x + 1, area.max.y + 1}, color::k_border_strong);
}

void draw_overflow(const Ui& ui, ImDrawList& list, const Rectangle& bar) {
  const float gap = ui.px(2);
  const float tip = ui.px(7);
  const float middle = 0.5F * (bar.min.x + bar.max.x);
  list.AddTriangleFilled({bar.min.x, bar.min.y - gap}, {bar.max.x, bar.min.y - gap}, {middle, bar.min.y - gap - tip},
                         color::k_overflow);
  const ImVec2 a{bar.min.x, bar.max.y + gap};
  const ImVec2 b{bar.max.x, bar.max.y + gap};
  const ImVec2 c{middle, bar.max.y + gap + tip};
  list.AddTriangleFilled(a, b, c, color::k_picture);
  list.AddTriangle(a, b, c, color::k_axis);
}

// Ticks inside the bar, numbers beside it where the entries do not say the same.
void draw_ticks(const Ui& ui, ImDrawList& list, const Rectangle& bar, const DensityRange& range) {
  const ImFont* font = ui.fonts.small_numbers;
  const float line = font->FontSize;
  const int most = std::max(2, static_cast<int>(bar.height() / (1.3F * line)));
  const std::vector<double> ticks = range.logarithmic ? log_ticks(range.lowest, range.highest, most)
                                                      : linear_ticks(range.lowest, range.highest, most);
  std::vector<std::string> texts;
  if (range.logarithmic) {
    for (const double tick : ticks) texts.push_back(short_number_text(tick, 3));
  } else {
    texts = tick_texts(ticks);
  }
  float free_below = bar.max.y;  // the last number's upper edge
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    const auto position = static_cast<float>(range.position(ticks[k]));
    if (position < 0.02F || position > 0.98F) continue;
    const float y = std::floor(bar.max.y - position * bar.height());
    list.AddRectFilled({bar.max.x - ui.px(4), y}, {bar.max.x, y + 1}, color::k_text);
    const float text_top = y - 0.5F * line;
    if (text_top < bar.min.y - ui.px(4) || text_top + line > free_below + ui.px(4)) continue;
    draw_text(list, font, {bar.max.x + ui.px(6), text_top}, color::k_text_2, texts[k]);
    free_below = text_top;
  }
}

void draw_cursor(const Ui& ui, ImDrawList& list, const Rectangle& bar, const DensityRange& range, double density) {
  const auto position = static_cast<float>(std::clamp(range.position(density), -0.02, 1.02));
  if (std::isnan(position)) return;
  const float y = bar.max.y - position * bar.height();
  const float x = bar.min.x - ui.px(2);
  list.AddTriangleFilled({x, y}, {x - ui.px(6), y - ui.px(4)}, {x - ui.px(6), y + ui.px(4)}, color::k_accent);
}

Explained end_help(bool highest) {
  return {highest ? "Upper end of the colour bar" : "Lower end of the colour bar",
          highest
              ? "The density, per unit of disk area, that has the last colour; what is denser has a colour of its own."
              : "The density, per unit of disk area, that has the first colour; what is thinner has the ground's.",
          {}};
}

std::optional<std::string> not_a_number(std::string_view typed) {
  return fmt::format("“{}” is not a number; write 0.01 or 1e-2.", typed);
}

std::optional<RangeChange> draw_end(Ui& ui, const Rectangle& area, const DensityRange& range, bool highest) {
  const std::string_view name = highest ? k_highest_name : k_lowest_name;
  const double value = highest ? range.highest : range.lowest;
  const std::optional<std::string> typed =
      entry(ui, name, area, short_number_text(value, 3), {}, end_help(highest), copy_text(value));
  if (!typed) return std::nullopt;
  const std::optional<double> number = parsed_number(*typed);
  if (!number) {
    refuse_entry(ui, name, *typed, *not_a_number(*typed));
    return std::nullopt;
  }
  if (*number == value) return std::nullopt;
  // The other end of a fitted linear range is 0; set, it is just above.
  const double other = highest ? std::max(range.lowest, 1e-9 * std::abs(*number)) : range.highest;
  const glm::dvec2 wanted = highest ? glm::dvec2(other, *number) : glm::dvec2(*number, other);
  if (const std::optional<std::string> fault = density_range_fault(wanted)) {
    refuse_entry(ui, name, *typed, *fault);
    return std::nullopt;
  }
  return RangeChange{
      wanted, fmt::format("{} end of the colour bar to {}", highest ? "Upper" : "Lower", short_number_text(*number)),
      true};
}

std::optional<DifferenceChange> draw_difference_end(Ui& ui, const Rectangle& area, const DifferenceRange& range,
                                                    bool fitted) {
  const Explained help{
      "Ends of the difference bar",
      fmt::format("The difference of two densities, above and below 0, that has the last colour. {} {}",
                  range.logarithmic ? "Logarithmic over two decades to either side." : "Linear.",
                  fitted ? "It follows the largest difference." : "Empty it to let it follow the largest difference."),
      {}};
  const std::optional<std::string> typed =
      entry(ui, k_difference_name, area, "+" + short_number_text(range.highest, 3), {}, help, copy_text(range.highest));
  if (!typed) return std::nullopt;
  if (typed->find_first_not_of(' ') == std::string::npos) {
    return fitted ? std::nullopt : std::optional(DifferenceChange{});
  }
  const std::optional<double> number = parsed_number(*typed);
  const std::optional<std::string> fault = number ? difference_range_fault(*number) : not_a_number(*typed);
  if (fault) {
    refuse_entry(ui, k_difference_name, *typed, *fault);
    return std::nullopt;
  }
  if (*number == range.highest) return std::nullopt;
  return DifferenceChange{number};
}

// Where a difference stands between the ends of its bar.
double share_of(const DifferenceRange& range, double difference) {
  double size = std::abs(difference) / range.highest;
  if (range.logarithmic) {
    size = std::log(std::max(std::abs(difference), range.lowest()) / range.lowest()) /
           std::log(range.highest / range.lowest());
  }
  return 0.5 + 0.5 * std::copysign(std::min(size, 1.0), difference);
}

}  // namespace

std::optional<RangeChange> DensityBar::drag(Ui& ui, const Rectangle& bar, const DensityBarInput& input) {
  const std::string label = input.range.logarithmic ? "Shift the colour bar" : "Scale the colour bar";
  const Press press =
      pressable(ui, k_bar_name, bar,
                {"Colour bar",
                 "Colours of the densities in all pictures. Drag to shift the range (log) or to scale it (lin).",
                 {}});
  if (press.focused)
    ImGui::GetWindowDrawList()->AddRect({bar.min.x - 2, bar.min.y - 2}, {bar.max.x + 2, bar.max.y + 2},
                                        color::k_accent);
  const float mouse = ImGui::GetIO().MousePos.y;
  if (press.held && !drag_) {
    drag_ = Drag{input.range, mouse, (bar.max.y - mouse) / static_cast<double>(bar.height()), false};
    ui.state.dragging = k_bar_name;
  }
  if (drag_) {
    const double share = (drag_->mouse - mouse) / static_cast<double>(bar.height());
    drag_->moved = drag_->moved || std::abs(mouse - drag_->mouse) > ui.px(2);
    const Drag current = *drag_;
    if (!press.held) {
      drag_.reset();
      ui.state.dragging.clear();
    }
    if (!current.moved) return std::nullopt;
    return RangeChange{dragged_density_range(current.start, current.grabbed, share), label, !press.held};
  }
  KeyboardFocus& focus = ui.state.focus;
  if (!press.focused || (focus.right == 0 && focus.down == 0)) return std::nullopt;
  const int steps = focus.right - focus.down;
  focus.right = focus.down = 0;
  return RangeChange{dragged_density_range(input.range, 0.5, 0.025 * steps), label, true};
}

std::optional<RangeChange> DensityBar::draw(Ui& ui, const DensityBarPlace& place, const DensityBarInput& input) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float left = place.column.min.x;
  const float width = place.column.width();
  const float top = place.column.min.y;
  const float bottom = place.column.max.y;
  const float title_top = place.title_top;
  const float row = ui.px(size::k_row);
  draw_text(list, ui.fonts.title, {left, title_top}, color::k_text, "D");
  const float hint = left + text_size(ui.fonts.title, "D").x + ui.px(5);
  if (hint + text_size(ui.fonts.small, "per area").x <= left + width + ui.px(4)) {
    draw_text(list, ui.fonts.small, {hint, title_top + ui.px(1.5F)}, color::k_hint, "per area");
  }
  std::optional<RangeChange> change = draw_end(ui, {{left, top}, {left + width, top + row}}, input.range, true);
  if (const auto lower = draw_end(ui, {{left, bottom - row}, {left + width, bottom}}, input.range, false))
    change = lower;

  const float bar_left = left + ui.px(2);
  const Rectangle bar{{bar_left, top + row + ui.px(13)}, {bar_left + ui.px(14), bottom - row - ui.px(13)}};
  if (bar.height() > ui.px(16)) {
    draw_gradient(list, bar, viridis_table(), true);
    frame_bar(list, bar);
    draw_overflow(ui, list, bar);
    draw_ticks(ui, list, bar, input.range);
    if (input.cursor) draw_cursor(ui, list, bar, input.range, *input.cursor);
    if (const auto dragged = drag(ui, bar, input)) change = dragged;
  }

  const Rectangle fit{{left, bottom + ui.px(5)}, {left + width, bottom + ui.px(5) + row}};
  const Explained help{
      "Fit the colour bar",
      "The range follows the pictures: up to their largest density, and four decades down (log) or to 0 (lin).",
      input.fitted ? "The range follows the pictures already." : ""};
  if (button(ui, "view.density_range.fit", fit, "Fit", help))
    change = RangeChange{std::nullopt, "Fit the colour bar", true};
  return change;
}

float difference_bar_height(const Ui& ui) {
  return ui.px(9) + ui.px(3) + ui.px(size::k_row);
}

std::optional<DifferenceChange> draw_difference_bar(Ui& ui, const Rectangle& area, const DifferenceRange& range,
                                                    bool fitted, std::optional<double> cursor) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Rectangle bar{area.min, {area.max.x, area.min.y + ui.px(9)}};
  draw_gradient(list, bar, difference_table(), false);
  frame_bar(list, bar);
  const float middle = std::floor(bar.center().x);
  list.AddRectFilled({middle, bar.min.y}, {middle + 1, bar.max.y}, color::k_axis);
  if (cursor && std::isfinite(*cursor)) {
    const auto share = static_cast<float>(share_of(range, *cursor));
    const float x = bar.min.x + share * bar.width();
    list.AddTriangleFilled({x, bar.max.y + 1}, {x - ui.px(4), bar.max.y + ui.px(7)},
                           {x + ui.px(4), bar.max.y + ui.px(7)}, color::k_accent);
  }
  const ImFont* font = ui.fonts.small_numbers;
  const float row_top = bar.max.y + ui.px(3);
  const float row = ui.px(size::k_row);
  const float text_top = row_top + 0.5F * (row - font->FontSize);
  draw_text(list, font, {area.min.x, text_top}, color::k_text_2, short_number_text(-range.highest, 3));
  draw_text_centered(list, font, {middle + 0.5F, text_top + 0.5F * font->FontSize}, color::k_text_2, "0");
  return draw_difference_end(ui, {{area.max.x - ui.px(58), row_top}, {area.max.x, row_top + row}}, range, fitted);
}

}  // namespace glint::view
