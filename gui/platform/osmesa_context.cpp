#include "gui/platform/osmesa_context.h"

#include <GL/osmesa.h>
#include <array>
#include <dlfcn.h>
#include <utility>
#include <vector>

namespace glint::gui {
namespace {

// The library is looked up when it is first needed: who only ever opens windows need not have it.
struct Library {
  decltype(&OSMesaCreateContextAttribs) create = nullptr;
  decltype(&OSMesaDestroyContext) destroy = nullptr;
  decltype(&OSMesaMakeCurrent) make_current = nullptr;
  decltype(&OSMesaGetProcAddress) look_up = nullptr;
};

Result<Library> open_library() {
  void* handle = ::dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);  // kept: its threads outlive every context
  if (handle == nullptr) {
    return content_error("OSMesa",
                         "is not installed (libOSMesa.so.8, Debian's package libosmesa6): nothing can be "
                         "drawn without a display");
  }
  Library library;
  library.create = reinterpret_cast<decltype(library.create)>(::dlsym(handle, "OSMesaCreateContextAttribs"));
  library.destroy = reinterpret_cast<decltype(library.destroy)>(::dlsym(handle, "OSMesaDestroyContext"));
  library.make_current = reinterpret_cast<decltype(library.make_current)>(::dlsym(handle, "OSMesaMakeCurrent"));
  library.look_up = reinterpret_cast<decltype(library.look_up)>(::dlsym(handle, "OSMesaGetProcAddress"));
  if (!library.create || !library.destroy || !library.make_current || !library.look_up) {
    return content_error("OSMesa", "is too old: libOSMesa.so.8 lacks functions of version 11");
  }
  return library;
}

class OsMesaContext final : public view::GlContext {
 public:
  static Result<std::unique_ptr<view::GlContext>> create(glm::ivec2 size) {
    const Result<Library> library = open_library();
    if (!library) return library.error();
    std::unique_ptr<OsMesaContext> made(new OsMesaContext(*library, size));
    const std::array attributes = {OSMESA_FORMAT,
                                   OSMESA_RGBA,
                                   OSMESA_PROFILE,
                                   OSMESA_CORE_PROFILE,
                                   OSMESA_CONTEXT_MAJOR_VERSION,
                                   3,
                                   OSMESA_CONTEXT_MINOR_VERSION,
                                   3,
                                   0};
    made->context_ = library->create(attributes.data(), nullptr);
    if (made->context_ == nullptr) return content_error("OSMesa", "cannot make an OpenGL 3.3 context");
    made->make_current();
    Result<view::GlFunctions> functions = view::load_gl_functions(library->look_up);
    if (!functions) return functions.error();
    made->gl_ = *functions;
    return std::unique_ptr<view::GlContext>(std::move(made));
  }

  ~OsMesaContext() override {
    if (context_ != nullptr) library_.destroy(context_);
  }

  void make_current() override { library_.make_current(context_, pixels_.data(), GL_UNSIGNED_BYTE, size_.x, size_.y); }
  [[nodiscard]] const view::GlFunctions& gl() const override { return gl_; }
  [[nodiscard]] glm::ivec2 size() const override { return size_; }

 private:
  OsMesaContext(const Library& library, glm::ivec2 size)
      : library_(library),
        size_(size),
        pixels_(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)) {}

  Library library_;
  glm::ivec2 size_;
  std::vector<unsigned char> pixels_;
  OSMesaContext context_ = nullptr;
  view::GlFunctions gl_;
};

}  // namespace

Result<std::unique_ptr<view::GlContext>> make_osmesa_context(glm::ivec2 size) {
  return OsMesaContext::create(size);
}

}  // namespace glint::gui
