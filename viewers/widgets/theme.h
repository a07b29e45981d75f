#pragma once
// The look of the window in numbers: colours, and the style of Dear ImGui. Greys are neutral, for pictures are judged
// against them; there is one accent, and it means "this is what you selected, dragged or are waiting for".

#include <imgui.h>

#include "core/pndf/model_factory.h"

namespace glint::view {

/// Packed for draw calls, from 0xRRGGBB.
constexpr ImU32 rgb(unsigned hex, unsigned alpha = 255) {
  return IM_COL32((hex >> 16U) & 255U, (hex >> 8U) & 255U, hex & 255U, alpha);
}

namespace color {
inline constexpr ImU32 k_window = rgb(0x141414);
inline constexpr ImU32 k_bar = rgb(0x1A1A1A);
inline constexpr ImU32 k_panel = rgb(0x1E1E1E);
inline constexpr ImU32 k_section = rgb(0x232323);
inline constexpr ImU32 k_popup = rgb(0x242424);
inline constexpr ImU32 k_header = rgb(0x272727);
inline constexpr ImU32 k_frame = rgb(0x2E2E2E);
inline constexpr ImU32 k_frame_hover = rgb(0x393939);
inline constexpr ImU32 k_frame_active = rgb(0x454545);
inline constexpr ImU32 k_border = rgb(0x343434);
inline constexpr ImU32 k_border_strong = rgb(0x4A4A4A);
inline constexpr ImU32 k_picture = rgb(0x0B0B0B);  ///< behind every picture and plot
inline constexpr ImU32 k_grid_major = rgb(0x3C3C3C);
inline constexpr ImU32 k_grid_minor = rgb(0x303030);
inline constexpr ImU32 k_axis = rgb(0x7A7A7A);
inline constexpr ImU32 k_text = rgb(0xEAEAEA);
inline constexpr ImU32 k_text_2 = rgb(0xB4B4B4);
inline constexpr ImU32 k_hint = rgb(0x969696);
inline constexpr ImU32 k_disabled = rgb(0x8A8A8A);
inline constexpr ImU32 k_accent = rgb(0xF2953C);
inline constexpr ImU32 k_accent_hover = rgb(0xFFAE5E);
inline constexpr ImU32 k_accent_ground = rgb(0x5C3A18);
inline constexpr ImU32 k_on_accent = rgb(0x171717);
inline constexpr ImU32 k_error_ground = rgb(0x3A1B18);
inline constexpr ImU32 k_error_edge = rgb(0xB5433A);
inline constexpr ImU32 k_error_text = rgb(0xFFE3DE);
inline constexpr ImU32 k_error_icon = rgb(0xFF8577);
inline constexpr ImU32 k_overflow = rgb(0xFF4DF0);
inline constexpr ImU32 k_under_stroke = rgb(0x000000, 146);  ///< under every line drawn over a picture
inline constexpr ImU32 k_chip = rgb(0x141414, 209);
}  // namespace color

namespace size {
inline constexpr float k_row = 24;
inline constexpr float k_row_pitch = 29;
inline constexpr float k_bar = 26;  ///< menu bar and status bar
inline constexpr float k_panel_header = 28;
inline constexpr float k_section_header = 24;
inline constexpr float k_message = 30;
inline constexpr float k_gap = 6;  ///< between panels: also the splitter
inline constexpr float k_padding = 10;
}  // namespace size

/// The style of the current ImGui context at that scale.
void apply_theme(float scale);

/// The colour of a method, the same in every panel; its mark stands beside it (viewers/widgets/draw.h).
ImU32 method_color(PndfMethod method);

ImVec4 as_vector(ImU32 packed);

}  // namespace glint::view
