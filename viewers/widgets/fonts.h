#pragma once
// The letters of the window: Inter for text and JetBrains Mono for numbers, with DejaVu and the built-in font behind.

#include <imgui.h>

namespace glint::view {

/// Owned by the font atlas of the current ImGui context.
struct Fonts {
  ImFont* text = nullptr;           ///< labels, buttons, menus, sentences
  ImFont* small = nullptr;          ///< hints, units, captions, rulers inside pictures
  ImFont* title = nullptr;          ///< panel and picture titles, section names
  ImFont* numbers = nullptr;        ///< values and entries
  ImFont* small_numbers = nullptr;  ///< tick labels, compact read-outs
};

/// Rebuilds the atlas of the current context at `scale`. Not inside a frame; the texture must be uploaded again.
Fonts load_fonts(float scale);

}  // namespace glint::view
