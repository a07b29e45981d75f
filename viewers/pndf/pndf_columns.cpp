#include "viewers/pndf/pndf_columns.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/document/names.h"
#include "viewers/pndf/pndf_readouts.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::view {
namespace {

constexpr float k_dimmed = 0.6F;

// A chip whose lower right corner is at `corner`; returns its area.
Rectangle draw_chip_above(const Ui& ui, ImDrawList& list, ImVec2 corner, const std::string& text) {
  const float width = std::floor(text_size(ui.fonts.small, text).x + 0.5F) + ui.px(12);
  return draw_chip(ui, list, {corner.x - width, corner.y - ui.px(18)}, text);
}

void draw_progress(Ui& ui, ImDrawList& list, const Rectangle& square, double progress, std::string_view key) {
  const Rectangle bar{square.min, {square.max.x, square.min.y + ui.px(3)}};
  const auto share = static_cast<float>(std::clamp(progress, 0.0, 1.0));
  list.AddRectFilled(bar.min, bar.max, color::k_frame_active);
  list.AddRectFilled(bar.min, {bar.min.x + share * bar.width(), bar.max.y}, color::k_accent);
  ui.widgets.record(fmt::format("pndf.progress.{}", key), {bar, {}, false, true});
}

// Chips in the lower right corner, the first lowest; "refining 41 %" or "computing 41 %" stands above them.
void draw_chips(Ui& ui, ImDrawList& list, const Rectangle& square, const PictureState& state, std::string_view key) {
  const float inset = ui.px(6);
  const float room = square.width() - 2 * inset - ui.px(12);
  ImVec2 corner{square.max.x - inset, square.max.y - inset};
  for (const Chip& chip : state.chips) {
    const bool fits = chip.brief.empty() || text_size(ui.fonts.small, chip.full).x <= room;
    corner.y = draw_chip_above(ui, list, corner, fits ? chip.full : chip.brief).min.y - ui.px(2);
  }
  if (state.progress >= 1) return;
  const std::string text = fmt::format("{} {} %", state.awaited ? "computing" : "refining",
                                       static_cast<int>(100 * std::max(0.0, state.progress)));
  const Rectangle area = draw_chip_above(ui, list, corner, text);
  ui.widgets.record(fmt::format("pndf.refining.{}", key), {area, {}, false, true});
}

// "Compute again", centred under `top`; true when pressed.
bool draw_restart_button(Ui& ui, ImVec2 top) {
  const std::string_view text = "Compute again";
  const float width = button_width(ui, text);
  const float left = std::floor(top.x - 0.5F * width);
  return button(ui, "pndf.restart", {{left, top.y}, {left + width, top.y + ui.px(size::k_row)}}, text,
                {"Compute again", "What was cancelled is computed for the document as it is now.", {}});
}

// Why there is no picture; true when the button under that was pressed.
bool draw_nothing(Ui& ui, ImDrawList& list, const Rectangle& square, const PictureState& state) {
  const std::vector<std::string> lines =
      state.nothing.empty() ? std::vector<std::string>{"…"}
                            : wrapped_text(ui.fonts.small, state.nothing, square.width() - 2 * ui.px(12));
  const float line = ui.px(17);
  float y = square.center().y - 0.5F * line * static_cast<float>(lines.size() - 1);
  if (state.offers_restart) y -= ui.px(16);
  for (const std::string& text : lines) {
    draw_text_centered(list, ui.fonts.small, {square.center().x, y}, color::k_hint, text);
    y += line;
  }
  return state.offers_restart && draw_restart_button(ui, {square.center().x, y});
}

// What every picture has: ground, image, rings, axes, crosshair, state. True when asked to compute again.
bool draw_picture(Ui& ui, const Rectangle& square, const PndfScene& scene, const PndfGrid* grid, const Texture* texture,
                  const Shading& shading, const PictureState& state, std::string_view key) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const DiskPlace place = disk_place(square, scene.window);
  draw_disk_ground(list, place);
  bool restart = false;
  if (texture != nullptr) {
    draw_disk_image(ui, list, place, *grid, *texture, shading, state.dimmed ? k_dimmed : 1.0F);
    draw_disk_rings(ui, list, place, state.first);
  } else {
    draw_disk_rings(ui, list, place, false);
    restart = draw_nothing(ui, list, square, state);
  }
  draw_disk_axes(ui, list, place, state.first && texture != nullptr);
  draw_window_inset(ui, list, place);
  if (scene.cursor && texture != nullptr) draw_crosshair(ui, list, place, *scene.cursor);
  if (state.focused) {
    list.AddRect({square.min.x - 1, square.min.y - 1}, {square.max.x + 1, square.max.y + 1}, color::k_accent);
  }
  if (state.progress < 1) draw_progress(ui, list, square, state.progress, key);
  draw_chips(ui, list, square, state, key);
  return restart;
}

// Returns where the title's letters end.
float draw_title(Ui& ui, ImVec2 at, float right, const PndfMethod* method, std::string_view title,
                 std::string_view setting) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float x = at.x;
  if (method != nullptr) {
    draw_mark(list, *method, {at.x + ui.px(5), at.y + 0.55F * ui.fonts.title->FontSize}, 5 * ui.scale);
    x += ui.px(15);
  }
  draw_text(list, ui.fonts.title, {x, at.y}, color::k_text, title);
  x += text_size(ui.fonts.title, title).x;
  if (setting.empty()) return x;
  const float setting_x = x + ui.px(7);
  const float setting_end = setting_x + text_size(ui.fonts.small, setting).x;
  if (setting_end > right) return x;
  draw_text(list, ui.fonts.small, {setting_x, at.y + ui.px(1.5F)}, color::k_text_2, setting);
  return setting_end;
}

void draw_read_outs(Ui& ui, const PndfLayout& layout, const Rectangle& square, const std::array<Figure, 4>& figures) {
  const float left = square.min.x;
  const float top = square.max.y + layout.axis_height;
  if (layout.read_outs == ReadOuts::compact) {
    draw_figure_line(ui, {left, top}, square.max.x, figures[0], figures[1]);
    draw_figure_line(ui, {left, top + layout.row_height}, square.max.x, figures[2], figures[3]);
  } else if (layout.read_outs == ReadOuts::one_row) {
    const std::array<float, 4> offsets = one_row_offsets(ui);
    for (std::size_t k = 0; k < figures.size(); ++k) draw_figure(ui, {left + offsets[k], top}, figures[k]);
  } else {
    const float second = left + std::floor(0.5F * square.width());
    for (std::size_t k = 0; k < figures.size(); ++k) {
      draw_figure(ui, {k % 2 == 0 ? left : second, k < 2 ? top : top + layout.row_height}, figures[k]);
    }
  }
}

}  // namespace

bool draw_empty_body(Ui& ui, const Rectangle& area, const std::string& sentence, bool offers_restart) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(area.min, area.max, color::k_picture);
  list.AddRect(area.min, area.max, color::k_border);
  const ImVec2 middle = area.center();
  const float width = std::min(area.width() - ui.px(40), ui.px(520));
  const std::vector<std::string> lines = wrapped_text(ui.fonts.text, sentence, width);
  float y = middle.y - ui.px(10) * static_cast<float>(lines.size());
  for (const std::string& line : lines) {
    draw_text_centered(list, ui.fonts.text, {middle.x, y}, color::k_hint, line);
    y += ui.px(20);
  }
  return offers_restart && draw_restart_button(ui, {middle.x, y});
}

std::string method_name(PndfMethod method) {
  return std::string(choice_name(method));
}

bool draw_method_column(Ui& ui, const PndfLayout& layout, const Rectangle& square, const PndfScene& scene,
                        const MethodColumn& column) {
  const std::string key = method_name(column.method);
  const std::string title(method_title(column.method));
  draw_title(ui, {square.min.x, layout.title_top_of(square)}, square.max.x, &column.method, title, column.setting);
  const Rectangle title_area{{square.min.x, layout.title_top_of(square)},
                             {square.max.x, layout.title_top_of(square) + ui.fonts.title->FontSize}};
  explain(ui, "pndf.title." + key, title_area,
          {column.setting.empty() ? title : title + ", " + column.setting, column.help, {}});

  const PndfGrid* grid = column.shown != nullptr ? &column.shown->image->grid : nullptr;
  const Texture* texture = column.shown != nullptr ? &column.shown->texture : nullptr;
  const bool restart = draw_picture(ui, square, scene, grid, texture, scene.density.shading(false), column.state, key);
  const MethodPicture* valid = column.state.awaited ? nullptr : column.picture;
  const std::array figures = {time_figure(column.method, valid), error_figure(column.method, valid, column.surface),
                              density_figure(column.method, valid, scene.cursor), noise_figure(column.method, valid)};
  draw_read_outs(ui, layout, square, figures);
  return restart;
}

std::optional<DifferenceChange> draw_difference_column(Ui& ui, const PndfLayout& layout, const PndfScene& scene,
                                                       const DifferenceColumn& column) {
  const Rectangle& square = *layout.difference;
  const DifferenceImage* difference = column.shown != nullptr ? &column.shown->difference : nullptr;
  const Figure at_cursor = difference_figure(difference, scene.cursor);
  const Figure largest = largest_difference_figure(difference);
  // Where no line is left under the bar, the title's takes the figure; what is written there never depends on it.
  const bool beside_title = layout.read_outs != ReadOuts::two_rows;
  const float figure_gap = ui.px(10);
  const float kept = beside_title ? figure_gap + longest_figure_width(ui, at_cursor.brief) : 0;
  const float right = beside_title ? layout.body.max.x - kept : square.max.x;
  const float title_end = draw_title(ui, {square.min.x, layout.title_top_of(square)}, right, nullptr, "Difference",
                                     layout.compact() ? std::string_view() : std::string_view(column.setting));
  const Rectangle title_area{{square.min.x, layout.title_top_of(square)},
                             {title_end, layout.title_top_of(square) + ui.fonts.title->FontSize}};
  explain(ui, "pndf.title.difference", title_area,
          {"Difference, " + column.setting,
           fmt::format("Blue: the method is below, red: above.{} Shown where both pictures are of the same grid and "
                       "quality.",
                       difference != nullptr ? " Largest: " + number_text(difference->largest) + "." : ""),
           {}});

  const PndfGrid* grid = difference != nullptr ? &difference->grid : nullptr;
  const Texture* texture = column.shown != nullptr ? &column.shown->texture : nullptr;
  draw_picture(ui, square, scene, grid, texture, scene.difference.shading(false), column.state, "difference");

  const float bar_top = square.max.y + layout.axis_height;
  const float row_top = bar_top + difference_bar_height(ui) + ui.px(1);
  if (beside_title) {
    draw_figure_at(ui, {title_end + figure_gap, layout.title_top_of(square) + ui.px(1)}, layout.body.max.x, at_cursor);
  } else {
    draw_figure(ui, {square.min.x, row_top}, at_cursor);
    draw_figure(ui, {square.min.x + std::floor(0.5F * square.width()), row_top}, largest);
  }
  const std::optional<double> cursor =
      difference != nullptr && scene.cursor ? difference_at(*difference, *scene.cursor) : std::nullopt;
  return draw_difference_bar(ui, {{square.min.x, bar_top}, {square.max.x, bar_top + difference_bar_height(ui)}},
                             scene.difference, column.fitted, cursor);
}

}  // namespace glint::view
