#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "viewers/gl/gl_functions.h"

namespace glint::view {

/// Memory to draw a frame into and read it back from. Belongs to the thread of its context, which must outlive it.
class Framebuffer {
 public:
  Framebuffer(const GlFunctions& gl, glm::ivec2 size);
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;
  ~Framebuffer();

  [[nodiscard]] glm::ivec2 size() const { return size_; }
  /// Everything drawn from now on goes here.
  void bind() const;
  /// Copies all of it to the window, which is drawn to from then on.
  void copy_to_window() const;

 private:
  const GlFunctions& gl_;
  glm::ivec2 size_;
  GLuint framebuffer_ = 0;
  GLuint color_ = 0;
};

/// What was drawn to the framebuffer bound now: 3 bytes a pixel, rows from the top.
std::vector<std::uint8_t> read_pixels(const GlFunctions& gl, glm::ivec2 size);

}  // namespace glint::view
