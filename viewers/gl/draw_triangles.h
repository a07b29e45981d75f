#pragma once
// Walks the triangles of what Dear ImGui recorded, with the pixels each can touch.

#include <cmath>
#include <imgui.h>

#include "viewers/gl/pixel_rectangle.h"

namespace glint::view {

/// The pixels a command may change, on a frame of `data`.
inline PixelRectangle clip_of(const ImDrawData& data, const ImDrawCmd& command) {
  const PixelRectangle clip{static_cast<int>(command.ClipRect.x - data.DisplayPos.x),
                            static_cast<int>(command.ClipRect.y - data.DisplayPos.y),
                            static_cast<int>(command.ClipRect.z - data.DisplayPos.x),
                            static_cast<int>(command.ClipRect.w - data.DisplayPos.y)};
  return common_part(clip, {0, 0, static_cast<int>(data.DisplaySize.x), static_cast<int>(data.DisplaySize.y)});
}

struct DrawTriangle {
  const ImDrawVert* a = nullptr;
  const ImDrawVert* b = nullptr;
  const ImDrawVert* c = nullptr;

  /// Every pixel it can touch, within `clip`.
  [[nodiscard]] PixelRectangle bounds(const ImDrawData& data, const PixelRectangle& clip) const {
    // Clamped on both sides before they become integers: what is drawn may lie any distance away.
    const auto within = [](float value, int least, int most) {
      return static_cast<int>(std::clamp(value, static_cast<float>(least), static_cast<float>(most)));
    };
    const auto low = [&](float p, float q, float r, float origin, int least, int most) {
      return within(std::floor(std::min({p, q, r}) - origin), least, most);
    };
    const auto high = [&](float p, float q, float r, float origin, int least, int most) {
      return within(std::ceil(std::max({p, q, r}) - origin), least, most);
    };
    const auto known = [](const ImDrawVert& v) { return std::isfinite(v.pos.x) && std::isfinite(v.pos.y); };
    if (clip.empty() || !known(*a) || !known(*b) || !known(*c)) return {};
    const ImVec2 origin = data.DisplayPos;
    return {low(a->pos.x, b->pos.x, c->pos.x, origin.x, clip.x0, clip.x1),
            low(a->pos.y, b->pos.y, c->pos.y, origin.y, clip.y0, clip.y1),
            high(a->pos.x, b->pos.x, c->pos.x, origin.x, clip.x0, clip.x1),
            high(a->pos.y, b->pos.y, c->pos.y, origin.y, clip.y0, clip.y1)};
  }
};

/// Triangle number `k` of `command`.
inline DrawTriangle triangle_of(const ImDrawList& list, const ImDrawCmd& command, unsigned k) {
  const ImDrawIdx* indices = list.IdxBuffer.Data + command.IdxOffset + 3 * static_cast<std::size_t>(k);
  const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
  return {vertices + indices[0], vertices + indices[1], vertices + indices[2]};
}

inline unsigned triangle_count(const ImDrawCmd& command) {
  return command.ElemCount / 3;
}

}  // namespace glint::view
