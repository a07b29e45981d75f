#pragma once

#include <cstdint>
#include <span>

#include <glm/vec2.hpp>

#include "viewers/gl/gl_functions.h"

namespace glint::view {

/// A 2D texture, clamped at its edges. Move-only; used on the thread of its context only, which must outlive it.
class Texture {
 public:
  enum class Format {
    rgba8,     ///< 4 bytes a texel, display values
    coverage,  ///< 1 byte a texel
    value,     ///< 1 float a texel; has mip levels, so that it can be shown smaller than it is
  };

  Texture() = default;
  Texture(const GlFunctions& gl, Format format, glm::ivec2 size, const void* texels);
  Texture(Texture&& other) noexcept;
  Texture& operator=(Texture&& other) noexcept;
  ~Texture();

  [[nodiscard]] bool empty() const { return name_ == 0; }
  [[nodiscard]] GLuint name() const { return name_; }
  /// Of these texels, of all textures ever made.
  [[nodiscard]] std::uint64_t serial() const { return serial_; }
  [[nodiscard]] Format format() const { return format_; }
  [[nodiscard]] glm::ivec2 size() const { return size_; }

 private:
  void release() noexcept;

  const GlFunctions* gl_ = nullptr;
  GLuint name_ = 0;
  std::uint64_t serial_ = 0;
  Format format_ = Format::rgba8;
  glm::ivec2 size_{0, 0};
};

}  // namespace glint::view
