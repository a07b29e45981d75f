#pragma once
// What a frame looks like when every pixel of it is drawn, to hold a Screen against that draws only what changed.

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "viewers/gl/draw_renderer.h"
#include "viewers/gl/framebuffer.h"
#include "viewers/widgets/theme.h"

namespace glint::test {

class FullRedraw {
 public:
  FullRedraw(const view::GlFunctions& gl, glm::ivec2 size) : gl_(gl), target_(gl, size) {
    auto renderer = view::DrawRenderer::create(gl);
    if (!renderer) throw std::runtime_error(renderer.error().message());
    renderer_ = std::move(*renderer);
  }

  /// Of the last ImGui frame: RGB bytes, rows from the top.
  std::vector<std::uint8_t> pixels() {
    const view::PixelRectangle all{0, 0, target_.size().x, target_.size().y};
    target_.bind();
    renderer_->draw(*ImGui::GetDrawData(), {&all, 1}, view::as_vector(view::color::k_window));
    return view::read_pixels(gl_, target_.size());
  }

 private:
  const view::GlFunctions& gl_;
  view::Framebuffer target_;
  std::unique_ptr<view::DrawRenderer> renderer_;
};

}  // namespace glint::test
