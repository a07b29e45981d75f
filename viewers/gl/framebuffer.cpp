#include "viewers/gl/framebuffer.h"

#include <algorithm>

namespace glint::view {

Framebuffer::Framebuffer(const GlFunctions& gl, glm::ivec2 size) : gl_(gl), size_(size) {
  gl_.GenRenderbuffers(1, &color_);
  gl_.BindRenderbuffer(GL_RENDERBUFFER, color_);
  gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size.x, size.y);
  gl_.GenFramebuffers(1, &framebuffer_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_);
}

Framebuffer::~Framebuffer() {
  gl_.DeleteFramebuffers(1, &framebuffer_);
  gl_.DeleteRenderbuffers(1, &color_);
}

void Framebuffer::bind() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
}

void Framebuffer::copy_to_window() const {
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl_.BlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

std::vector<std::uint8_t> read_pixels(const GlFunctions& gl, glm::ivec2 size) {
  const auto row = 3 * static_cast<std::size_t>(size.x);
  std::vector<std::uint8_t> upwards(row * static_cast<std::size_t>(size.y));
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, upwards.data());
  std::vector<std::uint8_t> pixels(upwards.size());
  for (std::size_t y = 0; y < static_cast<std::size_t>(size.y); ++y) {
    const auto from = upwards.begin() + static_cast<std::ptrdiff_t>((static_cast<std::size_t>(size.y) - 1 - y) * row);
    std::copy_n(from, row, pixels.begin() + static_cast<std::ptrdiff_t>(y * row));
  }
  return pixels;
}

}  // namespace glint::view
