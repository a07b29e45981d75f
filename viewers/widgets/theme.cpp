#include "viewers/widgets/theme.h"

#include <array>
#include <utility>

namespace glint::view {
namespace {

using Entry = std::pair<ImGuiCol_, ImU32>;

constexpr std::array k_colors = {
    Entry{ImGuiCol_Text, color::k_text},
    Entry{ImGuiCol_TextDisabled, color::k_disabled},
    Entry{ImGuiCol_WindowBg, color::k_window},
    Entry{ImGuiCol_ChildBg, color::k_panel},
    Entry{ImGuiCol_PopupBg, color::k_popup},
    Entry{ImGuiCol_Border, color::k_border},
    Entry{ImGuiCol_BorderShadow, rgb(0, 0)},
    Entry{ImGuiCol_MenuBarBg, color::k_bar},
    Entry{ImGuiCol_FrameBg, color::k_frame},
    Entry{ImGuiCol_FrameBgHovered, color::k_frame_hover},
    Entry{ImGuiCol_FrameBgActive, color::k_frame_active},
    Entry{ImGuiCol_TitleBg, color::k_header},
    Entry{ImGuiCol_TitleBgActive, color::k_header},
    Entry{ImGuiCol_TitleBgCollapsed, color::k_header},
    Entry{ImGuiCol_ScrollbarBg, color::k_bar},
    Entry{ImGuiCol_ScrollbarGrab, color::k_frame_active},
    Entry{ImGuiCol_ScrollbarGrabHovered, rgb(0x5A5A5A)},
    Entry{ImGuiCol_ScrollbarGrabActive, color::k_accent},
    Entry{ImGuiCol_CheckMark, color::k_accent_hover},
    Entry{ImGuiCol_SliderGrab, rgb(0xDADADA)},
    Entry{ImGuiCol_SliderGrabActive, rgb(0xFFFFFF)},
    Entry{ImGuiCol_Button, color::k_frame},
    Entry{ImGuiCol_ButtonHovered, color::k_frame_hover},
    Entry{ImGuiCol_ButtonActive, color::k_frame_active},
    Entry{ImGuiCol_Header, color::k_section},
    Entry{ImGuiCol_HeaderHovered, color::k_frame_hover},
    Entry{ImGuiCol_HeaderActive, color::k_accent_ground},
    Entry{ImGuiCol_Separator, color::k_border},
    Entry{ImGuiCol_SeparatorHovered, rgb(0xF2953C, 153)},
    Entry{ImGuiCol_SeparatorActive, color::k_accent},
    Entry{ImGuiCol_ResizeGrip, color::k_border},
    Entry{ImGuiCol_ResizeGripHovered, color::k_border_strong},
    Entry{ImGuiCol_ResizeGripActive, color::k_accent},
    Entry{ImGuiCol_PlotHistogram, color::k_accent},
    Entry{ImGuiCol_Tab, color::k_panel},
    Entry{ImGuiCol_TabHovered, color::k_frame_hover},
    Entry{ImGuiCol_TabActive, color::k_header},
    Entry{ImGuiCol_TabUnfocused, color::k_panel},
    Entry{ImGuiCol_TabUnfocusedActive, color::k_header},
    Entry{ImGuiCol_TableHeaderBg, color::k_header},
    Entry{ImGuiCol_TableBorderStrong, color::k_border_strong},
    Entry{ImGuiCol_TableBorderLight, color::k_border},
    Entry{ImGuiCol_TableRowBgAlt, rgb(0xFFFFFF, 5)},
    Entry{ImGuiCol_TextSelectedBg, color::k_accent_ground},
    Entry{ImGuiCol_DragDropTarget, color::k_accent},
    Entry{ImGuiCol_NavHighlight, color::k_accent},
    Entry{ImGuiCol_ModalWindowDimBg, rgb(0x000000, 140)},
};

}  // namespace

void apply_theme(float scale) {
  ImGuiStyle style;
  style.WindowPadding = {10, 8};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 5};
  style.ItemInnerSpacing = {6, 4};
  style.CellPadding = {6, 3};
  style.IndentSpacing = 14;
  style.ScrollbarSize = 10;
  style.GrabMinSize = 8;
  style.WindowRounding = style.ChildRounding = style.PopupRounding = 4;
  style.FrameRounding = style.TabRounding = 3;
  style.GrabRounding = style.ScrollbarRounding = 2;
  style.FrameBorderSize = 0;
  style.TabBorderSize = 0;
  style.WindowMenuButtonPosition = ImGuiDir_None;
  style.ScaleAllSizes(scale);
  const float border = scale >= 3 ? 2.0F : 1.0F;
  style.WindowBorderSize = style.ChildBorderSize = style.PopupBorderSize = border;
  for (const auto& [index, value] : k_colors) style.Colors[index] = as_vector(value);
  ImGui::GetStyle() = style;
}

ImU32 method_color(PndfMethod method) {
  switch (method) {
    case PndfMethod::exact:
      return rgb(0xF2F2F2);
    case PndfMethod::mixture:
      return rgb(0x4093FF);
    case PndfMethod::lean:
      return rgb(0xCC70B2);
    case PndfMethod::automatic:
      return rgb(0x66D9D0);
    case PndfMethod::binning:
      return rgb(0x269960);
  }
  return color::k_text;
}

ImVec4 as_vector(ImU32 packed) {
  return ImGui::ColorConvertU32ToFloat4(packed);
}

}  // namespace glint::view
