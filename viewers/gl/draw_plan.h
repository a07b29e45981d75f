#pragma once
// What OpenGL is asked to draw of a recorded frame: only triangles that touch the rectangles to be drawn, and large
// plain ones apart, because software OpenGL fills them several times faster without a texture and without blending.

#include <imgui.h>
#include <span>
#include <vector>

#include "viewers/gl/frame_pictures.h"
#include "viewers/gl/pixel_rectangle.h"

namespace glint::view {

struct PlannedDraw {
  enum class Fill {
    picture,      ///< as `picture` says
    plain,        ///< the vertex colours
    plain_opaque  ///< the vertex colours, over whatever there was
  };
  int list = 0;  ///< of ImDrawData::CmdLists
  Fill fill = Fill::picture;
  const FramePicture* picture = nullptr;
  PixelRectangle scissor;
  int vertex_offset = 0;
  std::size_t first_index = 0;  ///< into DrawPlan::indices
  std::size_t index_count = 0;
};

/// In drawing order within each rectangle; draws of one list stand together.
struct DrawPlan {
  std::vector<ImDrawIdx> indices;
  std::vector<PlannedDraw> draws;
};

DrawPlan plan_drawing(const ImDrawData& data, std::span<const PixelRectangle> rectangles);

}  // namespace glint::view
