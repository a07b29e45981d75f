#include "viewers/pndf/pndf_toolbar.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "viewers/pndf/disk_picture.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::view {
namespace {

constexpr std::array<std::string_view, 2> k_window_keys{"whole", "fit"};
constexpr std::array<std::string_view, 2> k_window_labels{"Whole disk", "Fit to lobe"};
constexpr std::array<std::string_view, 2> k_scale_keys{"log", "linear"};
constexpr std::array<std::string_view, 2> k_scale_labels{"Log", "Lin"};
constexpr std::array k_grid_sizes{64, 128, 256, 512, 1024};

Edit edit_of(const Document& document, std::string label) {
  return {document, std::move(label), true};
}

int chosen_window(const Document& document) {
  if (!document.grid.window) return 1;
  return *document.grid.window == k_whole_disk ? 0 : -1;
}

std::optional<Edit> window_switch(Ui& ui, ImVec2 at, const Document& document) {
  const Explained help{"Window of the pictures",
                       "The whole projected hemisphere, or the square that holds the lobe. The wheel zooms about the "
                       "cursor, the right button drags, a double click changes between both.",
                       {}};
  const std::optional<int> picked =
      switch_of(ui, "grid.window", at, k_window_keys, k_window_labels, chosen_window(document), help);
  if (!picked) return std::nullopt;
  Edit edit = edit_of(document, *picked == 0 ? "Show the whole disk" : "Fit the window to the lobe");
  edit.document.grid.window = *picked == 0 ? std::optional(k_whole_disk) : std::nullopt;
  return edit;
}

std::optional<Edit> scale_switch(Ui& ui, ImVec2 at, const Document& document) {
  const bool logarithmic = document.view.density_scale == ColorScale::logarithmic;
  const std::optional<int> picked =
      switch_of(ui, "view.density_scale", at, k_scale_keys, k_scale_labels, logarithmic ? 0 : 1,
                {"Colour scale", "Whether colours follow the logarithm of the density or the density itself.", {}});
  if (!picked) return std::nullopt;
  Edit edit = edit_of(document, *picked == 0 ? "Logarithmic colours" : "Linear colours");
  edit.document.view.density_scale = *picked == 0 ? ColorScale::logarithmic : ColorScale::linear;
  return edit;
}

std::optional<Edit> grid_combo(Ui& ui, const Rectangle& area, const Document& document) {
  std::vector<int> sizes(k_grid_sizes.begin(), k_grid_sizes.end());
  const auto place = std::lower_bound(sizes.begin(), sizes.end(), document.grid.size);
  const int chosen = static_cast<int>(place - sizes.begin());
  if (place == sizes.end() || *place != document.grid.size) sizes.insert(place, document.grid.size);
  std::vector<std::string> texts;
  texts.reserve(sizes.size());
  for (const int size : sizes) texts.push_back(fmt::format("{}²", size));
  const std::vector<std::string_view> labels(texts.begin(), texts.end());
  const std::optional<int> picked =
      combo(ui, "grid.size", area, labels, chosen,
            {"Grid", "Cells of each picture. More cells show finer glints and take longer.", {}});
  if (!picked) return std::nullopt;
  const int size = sizes[static_cast<std::size_t>(*picked)];
  Edit edit = edit_of(document, fmt::format("Grid of {}² cells", size));
  edit.document.grid.size = size;
  return edit;
}

// What fits best at the right of the row: all notes, all in brief, the first alone, or the hint.
std::string fitting_note(const Ui& ui, std::span<const PndfNote> notes, const std::string& hint, float room) {
  const auto fits = [&](const std::string& text) { return text_size(ui.fonts.small, text).x <= room; };
  if (notes.empty()) return fits(hint) ? hint : std::string();
  std::string full;
  std::string brief;
  for (const PndfNote& note : notes) {
    const std::string_view between = full.empty() ? "" : " · ";
    full.append(between).append(note.full);
    brief.append(between).append(note.brief);
  }
  for (const std::string& text :
       {fmt::format("{}   {}", full, hint), full, brief, notes.front().full, notes.front().brief}) {
    if (fits(text)) return text;
  }
  return {};
}

}  // namespace

std::optional<Edit> draw_pndf_toolbar(Ui& ui, const Rectangle& row, const Document& document,
                                      std::span<const PndfNote> notes, const std::string& flip_chord) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float between = ui.px(10);
  const float small_top = row.center().y - 0.5F * ui.fonts.small->FontSize;
  ImVec2 at = row.min;
  std::optional<Edit> edit = window_switch(ui, at, document);
  at.x += switch_width(ui, k_window_labels) + between;
  if (auto changed = scale_switch(ui, at, document)) edit = std::move(changed);
  at.x += switch_width(ui, k_scale_labels) + between;
  draw_text(list, ui.fonts.small, {at.x, small_top}, color::k_text_2, "Grid");
  at.x += text_size(ui.fonts.small, "Grid").x + ui.px(7);
  const Rectangle combo_area{at, {at.x + ui.px(76), row.max.y}};
  if (auto changed = grid_combo(ui, combo_area, document)) edit = std::move(changed);
  at.x = combo_area.max.x + between;
  if (chosen_window(document) < 0) {
    draw_text(list, ui.fonts.small, {at.x, small_top}, color::k_hint, "custom window");
    at.x += text_size(ui.fonts.small, "custom window").x + between;
  }
  const std::string hint = flip_chord.empty() ? std::string() : fmt::format("hold {}: reference", flip_chord);
  const std::string note = fitting_note(ui, notes, hint, row.max.x - at.x - between);
  draw_text_right(list, ui.fonts.small, {row.max.x, small_top}, notes.empty() ? color::k_hint : color::k_text_2, note);
  return edit;
}

}  // namespace glint::view
