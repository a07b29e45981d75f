#include "viewers/pndf/pndf_layout.h"

#include <algorithm>
#include <cmath>

#include "viewers/widgets/theme.h"

namespace glint::view {
namespace {

// Lengths of the theme, before scaling.
struct Measures {
  ReadOuts read_outs;
  float toolbar_margin;
  float title;
  float axis;
  float row;  // of the read-outs
  int rows;
  float bottom;
  float bar;
  float least_column;      // that a method's read-outs need
  float least_difference;  // that the difference's title needs, with a figure beside it
};
constexpr Measures k_two_rows{ReadOuts::two_rows, 8, 25, 25, 34, 2, 8, 60, 0, 0};
constexpr Measures k_one_row{ReadOuts::one_row, 8, 25, 25, 34, 1, 10, 60, 272, 262};
constexpr Measures k_compact{ReadOuts::compact, 6, 23, 22, 18, 2, 7, 58, 0, 0};
constexpr float k_gap = 10;
constexpr float k_widest_gap = 28;
constexpr float k_smallest_side = 64;
constexpr float k_compact_below = 175;
constexpr float k_gain_of_one_row = 12;  // pixels a picture must grow by
constexpr float k_row_gap = 14;          // between two rows of pictures
constexpr float k_gain_of_stacking = 1.15F;

struct Count {
  float methods;
  float differences;

  [[nodiscard]] float pictures() const { return methods + differences; }
};

float room_for_columns(const Ui& ui, const Rectangle& content, const Measures& m, Count count) {
  return content.width() - 2 * ui.px(size::k_padding) - ui.px(m.bar) - count.pictures() * ui.px(k_gap);
}

// Of all columns together, for pictures of that side.
float needed_width(const Ui& ui, const Measures& m, Count count, float side) {
  return count.methods * std::max(side, ui.px(m.least_column)) +
         count.differences * std::max(side, ui.px(m.least_difference));
}

// The side of the pictures; 0 where the read-outs do not fit under them.
float largest_side(const Ui& ui, const Rectangle& content, const Measures& m, Count count) {
  const float fixed = 2 * ui.px(m.toolbar_margin) + ui.px(size::k_row) + ui.px(m.title) + ui.px(m.axis) +
                      static_cast<float>(m.rows) * ui.px(m.row) + ui.px(m.bottom);
  const float width = room_for_columns(ui, content, m, count);
  const float side = std::floor(std::min(width / count.pictures(), content.height() - fixed));
  if (m.least_column > 0 && needed_width(ui, m, count, side) > width) return 0;
  return std::max(ui.px(k_smallest_side), side);
}

const Measures& best_measures(const Ui& ui, const Rectangle& content, Count count) {
  const float two_rows = largest_side(ui, content, k_two_rows, count);
  if (two_rows < ui.px(k_compact_below)) return k_compact;
  const float one_row = largest_side(ui, content, k_one_row, count);
  return one_row >= two_rows + ui.px(k_gain_of_one_row) ? k_one_row : k_two_rows;
}

// What stands in one row of pictures above and below them.
float around_picture(const Ui& ui, const Measures& m) {
  return ui.px(m.title) + ui.px(m.axis) + static_cast<float>(m.rows) * ui.px(m.row);
}

// The side of the pictures in two rows of `columns`.
float stacked_side(const Ui& ui, const Rectangle& content, const Measures& m, float columns) {
  const float width = content.width() - 2 * ui.px(size::k_padding) - ui.px(m.bar) - columns * ui.px(k_gap);
  const float height = content.height() - 2 * ui.px(m.toolbar_margin) - ui.px(size::k_row) - ui.px(m.bottom) -
                       ui.px(k_row_gap) - 2 * around_picture(ui, m);
  return std::floor(std::min(width / columns, 0.5F * height));
}

// Two rows: the methods row by row, the difference after them, the bar at the right of the first.
PndfLayout stacked_layout(const Ui& ui, const Rectangle& content, std::size_t methods, std::size_t columns, float side,
                          const Measures& m) {
  PndfLayout layout;
  const float padding = ui.px(size::k_padding);
  const float left = content.min.x + padding;
  const float right = content.max.x - padding;
  const float toolbar_top = content.min.y + ui.px(m.toolbar_margin);
  layout.read_outs = m.read_outs;
  layout.toolbar = {{left, toolbar_top}, {right, toolbar_top + ui.px(size::k_row)}};
  layout.title_height = ui.px(m.title);
  layout.title_top = layout.toolbar.max.y + ui.px(m.toolbar_margin);
  layout.body = {{left, layout.title_top}, {right, content.max.y - ui.px(m.bottom)}};
  layout.axis_height = ui.px(m.axis);
  layout.row_height = ui.px(m.row);
  const float spare = right - left - ui.px(m.bar) - static_cast<float>(columns) * (side + ui.px(k_gap));
  const float gap =
      ui.px(k_gap) + std::clamp(std::floor(spare / static_cast<float>(columns)), 0.0F, ui.px(k_widest_gap - k_gap));
  const float row_step = side + around_picture(ui, m) + ui.px(k_row_gap);
  const auto square = [&](std::size_t k) {
    const std::size_t row = k / columns;
    const float x = left + static_cast<float>(k - row * columns) * (side + gap);
    const float y = layout.title_top + layout.title_height + static_cast<float>(row) * row_step;
    return Rectangle{{x, y}, {x + side, y + side}};
  };
  for (std::size_t k = 0; k < methods; ++k) layout.pictures.push_back(square(k));
  layout.difference = square(methods);
  const float bar = left + static_cast<float>(columns) * (side + gap);
  layout.bar = {{bar, layout.title_top + layout.title_height}, {bar + ui.px(m.bar), layout.pictures[0].max.y}};
  return layout;
}

}  // namespace

std::array<float, 4> one_row_offsets(const Ui& ui) {
  return {0, ui.px(64), ui.px(132), ui.px(204)};
}

PndfLayout pndf_layout(const Ui& ui, const Rectangle& content, std::size_t methods) {
  const Count count{static_cast<float>(std::max<std::size_t>(methods, 1)), methods >= 2 ? 1.0F : 0.0F};
  const Measures& m = best_measures(ui, content, count);
  const float side = largest_side(ui, content, m, count);
  if (methods >= 2) {
    const std::size_t columns = (methods + 2) / 2;  // methods and difference in two rows
    const float stacked = stacked_side(ui, content, k_two_rows, static_cast<float>(columns));
    if (stacked > k_gain_of_stacking * side && stacked >= ui.px(k_compact_below)) {
      return stacked_layout(ui, content, methods, columns, stacked, k_two_rows);
    }
    const float compact = stacked_side(ui, content, k_compact, static_cast<float>(columns));
    if (compact > k_gain_of_stacking * side) {
      return stacked_layout(ui, content, methods, columns, compact, k_compact);
    }
  }
  const float padding = ui.px(size::k_padding);
  const float left = content.min.x + padding;
  const float right = content.max.x - padding;
  const float toolbar_top = content.min.y + ui.px(m.toolbar_margin);
  PndfLayout layout;
  layout.read_outs = m.read_outs;
  layout.toolbar = {{left, toolbar_top}, {right, toolbar_top + ui.px(size::k_row)}};
  layout.title_top = layout.toolbar.max.y + ui.px(m.toolbar_margin);
  layout.body = {{left, layout.title_top}, {right, content.max.y - ui.px(m.bottom)}};
  layout.axis_height = ui.px(m.axis);
  layout.row_height = ui.px(m.row);
  layout.title_height = ui.px(m.title);

  // Spare width goes between the columns, as far as they still read as one row.
  const float column = std::max(side, ui.px(m.least_column));
  const float spare = room_for_columns(ui, content, m, count) - needed_width(ui, m, count, side);
  const float gap = ui.px(k_gap) + std::clamp(std::floor(spare / count.pictures()), 0.0F, ui.px(k_widest_gap - k_gap));
  const float top = layout.title_top + ui.px(m.title);
  float x = left;
  for (std::size_t k = 0; k < methods; ++k) {
    layout.pictures.push_back({{x, top}, {x + side, top + side}});
    x += column + gap;
  }
  if (methods == 0) x += column + gap;
  layout.bar = {{x, top}, {x + ui.px(m.bar), top + side}};
  x = layout.bar.max.x + gap;
  if (count.differences > 0) layout.difference = Rectangle{{x, top}, {x + side, top + side}};
  return layout;
}

}  // namespace glint::view
