#pragma once
// Draws what Dear ImGui recorded, through the pointer table. Texture ids are FramePicture pointers, so that pictures of
// densities become colours on the way to the screen: a new range costs nothing.

#include <imgui.h>
#include <memory>
#include <span>

#include "core/math/result.h"
#include "viewers/gl/draw_plan.h"
#include "viewers/gl/frame_pictures.h"
#include "viewers/gl/gl_functions.h"

namespace glint::view {

/// Belongs to the thread of its context, which must be current and must outlive it.
class DrawRenderer {
 public:
  static Result<std::unique_ptr<DrawRenderer>> create(const GlFunctions& gl);
  DrawRenderer(const DrawRenderer&) = delete;
  DrawRenderer& operator=(const DrawRenderer&) = delete;
  ~DrawRenderer();

  /// Uploads the font atlas of the current ImGui context; again after it was rebuilt.
  void upload_fonts();

  /// Within `rectangles`, which share no pixel: clears what is bound to `background` and draws the frame over it.
  void draw(const ImDrawData& data, std::span<const PixelRectangle> rectangles, ImVec4 background);

 private:
  struct Resources;
  explicit DrawRenderer(const GlFunctions& gl);
  [[nodiscard]] Status build();
  void set_state(const ImDrawData& data);
  void clear(const ImDrawData& data, std::span<const PixelRectangle> rectangles, ImVec4 background);
  void set_fill(const PlannedDraw& draw);
  void set_picture(const FramePicture& picture);

  const GlFunctions& gl_;
  std::unique_ptr<Resources> own_;
  Texture font_;
  FramePicture font_picture_;
};

}  // namespace glint::view
