#pragma once
// Strokes and letters that several panels share: whole pixels, dark under-strokes over pictures, and the marks of the
// methods. All positions are screen pixels.

#include <imgui.h>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/pndf/model_factory.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

ImVec2 text_size(const ImFont* font, std::string_view text);

/// Left end of the baseline box at `at` (top left).
void draw_text(ImDrawList& list, const ImFont* font, ImVec2 at, ImU32 ink, std::string_view text);
/// Right edge at `right`.
void draw_text_right(ImDrawList& list, const ImFont* font, ImVec2 right, ImU32 ink, std::string_view text);
void draw_text_centered(ImDrawList& list, const ImFont* font, ImVec2 center, ImU32 ink, std::string_view text);
/// With a dark halo of one pixel: for letters over a picture.
void draw_text_over(const Ui& ui, ImDrawList& list, const ImFont* font, ImVec2 at, ImU32 ink, std::string_view text);
/// Cut with an ellipsis where it is wider than `width`.
std::string fitted_text(const ImFont* font, std::string_view text, float width);
/// Sentences broken into lines of at most `width`.
std::vector<std::string> wrapped_text(const ImFont* font, std::string_view text, float width);

/// A line over a picture: dark under-stroke, two pixels wider.
void draw_line_over(ImDrawList& list, ImVec2 a, ImVec2 b, ImU32 ink, float thickness);
void draw_polyline_over(ImDrawList& list, std::span<const ImVec2> points, bool closed, ImU32 ink, float thickness);
/// `dash` and `gap` in pixels.
void draw_dashed_over(ImDrawList& list, std::span<const ImVec2> points, bool closed, ImU32 ink, float thickness,
                      float dash, float gap);

/// The square, circle, triangle … of a method; `radius` as the theme gives it, in pixels.
void draw_mark(ImDrawList& list, PndfMethod method, ImVec2 center, float radius);

/// Small dark label over a picture, its top left at `at`; returns its area.
Rectangle draw_chip(const Ui& ui, ImDrawList& list, ImVec2 at, std::string_view text);

/// Drawn with lines, about 12 pixels across at scale 1.
enum class Icon {
  help,
  maximise,
  restore,
  export_picture,
  close,
  warning,
  arrow_down,
  arrow_right,
  reset,
  folder,
  file,
  picture,
  up,
  check
};
void draw_icon(const Ui& ui, ImDrawList& list, Icon icon, ImVec2 center, ImU32 ink);

}  // namespace glint::view
