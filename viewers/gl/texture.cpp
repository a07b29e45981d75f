#include "viewers/gl/texture.h"

#include <atomic>
#include <utility>

namespace glint::view {
namespace {

struct Layout {
  GLint internal;
  GLenum format;
  GLenum type;
};

Layout layout_of(Texture::Format format) {
  switch (format) {
    case Texture::Format::coverage:
      return {GL_R8, GL_RED, GL_UNSIGNED_BYTE};
    case Texture::Format::value:
      return {GL_R32F, GL_RED, GL_FLOAT};
    case Texture::Format::rgba8:
      break;
  }
  return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
}

std::uint64_t next_serial() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace

Texture::Texture(const GlFunctions& gl, Format format, glm::ivec2 size, const void* texels)
    : gl_(&gl), serial_(next_serial()), format_(format), size_(size) {
  const Layout layout = layout_of(format);
  gl.GenTextures(1, &name_);
  gl.BindTexture(GL_TEXTURE_2D, name_);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, layout.internal, size.x, size.y, 0, layout.format, layout.type, texels);
  if (format == Format::value) gl.GenerateMipmap(GL_TEXTURE_2D);
}

Texture::Texture(Texture&& other) noexcept
    : gl_(other.gl_),
      name_(std::exchange(other.name_, 0)),
      serial_(other.serial_),
      format_(other.format_),
      size_(other.size_) {}

Texture& Texture::operator=(Texture&& other) noexcept {
  if (this == &other) return *this;
  release();
  gl_ = other.gl_;
  name_ = std::exchange(other.name_, 0);
  serial_ = other.serial_;
  format_ = other.format_;
  size_ = other.size_;
  return *this;
}

Texture::~Texture() {
  release();
}

void Texture::release() noexcept {
  if (name_ != 0) gl_->DeleteTextures(1, &name_);
  name_ = 0;
}

}  // namespace glint::view
