#include "viewers/gl/draw_plan.h"

#include "viewers/gl/draw_triangles.h"

namespace glint::view {
namespace {

// Smaller ones are not worth a change of program.
constexpr int k_large = 4096;  // pixels of the frame around a triangle

PlannedDraw::Fill fill_of(const DrawTriangle& triangle, const FramePicture& picture, ImVec2 white, int pixels) {
  using Fill = PlannedDraw::Fill;
  if (picture.shading.kind != Shading::Kind::coverage || pixels < k_large) return Fill::picture;
  bool opaque = true;
  for (const ImDrawVert* vertex : {triangle.a, triangle.b, triangle.c}) {
    if (vertex->uv.x != white.x || vertex->uv.y != white.y) return Fill::picture;
    opaque = opaque && (vertex->col >> IM_COL32_A_SHIFT) == 255;
  }
  return opaque ? Fill::plain_opaque : Fill::plain;
}

class Planner {
 public:
  Planner(const ImDrawData& data, DrawPlan& plan)
      : data_(data), white_(ImGui::GetIO().Fonts->TexUvWhitePixel), plan_(plan) {}

  void add(int list, const ImDrawCmd& command, const PixelRectangle& rectangle) {
    const PixelRectangle scissor = common_part(clip_of(data_, command), rectangle);
    if (scissor.empty()) return;
    const ImDrawList& commands = *data_.CmdLists[list];
    const auto& picture = *static_cast<const FramePicture*>(command.GetTexID());
    PlannedDraw* draw = nullptr;
    for (unsigned k = 0; k < triangle_count(command); ++k) {
      const DrawTriangle triangle = triangle_of(commands, command, k);
      const PixelRectangle bounds = triangle.bounds(data_, scissor);
      if (bounds.empty()) continue;
      const PlannedDraw::Fill fill = fill_of(triangle, picture, white_, bounds.area());
      if (draw == nullptr || draw->fill != fill) {
        plan_.draws.push_back(
            {list, fill, &picture, scissor, static_cast<int>(command.VtxOffset), plan_.indices.size(), 0});
        draw = &plan_.draws.back();
      }
      const ImDrawIdx* indices = commands.IdxBuffer.Data + command.IdxOffset + 3 * static_cast<std::size_t>(k);
      plan_.indices.insert(plan_.indices.end(), indices, indices + 3);
      draw->index_count += 3;
    }
  }

 private:
  const ImDrawData& data_;
  ImVec2 white_;
  DrawPlan& plan_;
};

}  // namespace

DrawPlan plan_drawing(const ImDrawData& data, std::span<const PixelRectangle> rectangles) {
  DrawPlan plan;
  Planner planner(data, plan);
  for (int list = 0; list < data.CmdListsCount; ++list) {
    for (const PixelRectangle& rectangle : rectangles) {
      for (const ImDrawCmd& command : data.CmdLists[list]->CmdBuffer) planner.add(list, command, rectangle);
    }
  }
  return plan;
}

}  // namespace glint::view
