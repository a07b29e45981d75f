#include <algorithm>
#include <array>
#include <atomic>
#include <cfloat>
#include <string>
#include <utility>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "gui/platform/window.h"

namespace glint::gui {
namespace {

Modifiers modifiers_of(int bits) {
  return {(bits & GLFW_MOD_CONTROL) != 0, (bits & GLFW_MOD_SHIFT) != 0, (bits & GLFW_MOD_ALT) != 0,
          (bits & GLFW_MOD_SUPER) != 0};
}

Error last_error(const std::string& what) {
  const char* cause = nullptr;
  glfwGetError(&cause);
  return content_error("window", what + (cause != nullptr ? std::string(": ") + cause : std::string()));
}

// GLFW itself, once a process.
Status start_glfw() {
  if (glfwInit() == GLFW_TRUE) return success();
  return last_error("cannot be opened, there is no display");
}

class GlfwWindow final : public Window {
 public:
  static Result<std::unique_ptr<Window>> create(glm::ivec2 size, bool maximised, const std::string& title) {
    if (const Status started = start_glfw(); !started) return started.error();
    std::unique_ptr<GlfwWindow> made(new GlfwWindow());
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_MAXIMIZED, maximised ? GLFW_TRUE : GLFW_FALSE);
    made->window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
    if (made->window_ == nullptr) return last_error("cannot be opened");
    made->make_current();
    Result<view::GlFunctions> functions =
        view::load_gl_functions([](const char* name) { return glfwGetProcAddress(name); });
    if (!functions) return functions.error();
    made->gl_ = *functions;
    glfwSwapInterval(1);
    return std::unique_ptr<Window>(std::move(made));
  }

  ~GlfwWindow() override {
    for (GLFWcursor* cursor : cursors_) {
      if (cursor != nullptr) glfwDestroyCursor(cursor);
    }
    if (window_ != nullptr) glfwDestroyWindow(window_);
    glfwTerminate();
  }

  void make_current() override { glfwMakeContextCurrent(window_); }
  [[nodiscard]] const view::GlFunctions& gl() const override { return gl_; }
  [[nodiscard]] glm::ivec2 size() const override {
    glm::ivec2 size;
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
  }
  void listen(InputQueue& input) override {
    input_ = &input;
    set_callbacks();
  }
  void swap() override { glfwSwapBuffers(window_); }
  [[nodiscard]] bool take_exposure() override { return std::exchange(exposed_, false); }
  bool poll(double seconds) override {
    if (seconds > 0) {
      glfwWaitEventsTimeout(seconds);
    } else {
      glfwPollEvents();
    }
    const bool woken = woken_.exchange(false);
    return std::exchange(happened_, false) || woken;
  }
  void wake() override {
    woken_ = true;
    glfwPostEmptyEvent();
  }
  [[nodiscard]] bool close_requested() const override { return glfwWindowShouldClose(window_) == GLFW_TRUE; }
  void refuse_close() override { glfwSetWindowShouldClose(window_, GLFW_FALSE); }
  void set_title(const std::string& title) override { glfwSetWindowTitle(window_, title.c_str()); }
  [[nodiscard]] float content_scale() const override {
    float x = 1;
    float y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::max(x, y);
  }
  [[nodiscard]] bool minimised() const override { return glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE; }
  [[nodiscard]] bool maximised() const override { return glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) == GLFW_TRUE; }
  void set_clipboard(const std::string& text) override { glfwSetClipboardString(window_, text.c_str()); }
  [[nodiscard]] std::string clipboard() const override {
    const char* text = glfwGetClipboardString(window_);
    return text != nullptr ? text : "";
  }
  void set_cursor(Cursor cursor) override {
    constexpr std::array k_shapes = {GLFW_ARROW_CURSOR,     GLFW_IBEAM_CURSOR,   GLFW_HAND_CURSOR,
                                     GLFW_CROSSHAIR_CURSOR, GLFW_HRESIZE_CURSOR, GLFW_VRESIZE_CURSOR};
    if (cursor == shown_) return;
    shown_ = cursor;
    const auto index = static_cast<std::size_t>(cursor);
    if (cursors_[index] == nullptr) cursors_[index] = glfwCreateStandardCursor(k_shapes[index]);
    glfwSetCursor(window_, cursors_[index]);
  }

 private:
  GlfwWindow() = default;

  static GlfwWindow& of(GLFWwindow* window) { return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window)); }

  // Positions come in screen coordinates, which on some desktops are larger than pixels.
  [[nodiscard]] ImVec2 in_pixels(double x, double y) const {
    glm::ivec2 units;
    glfwGetWindowSize(window_, &units.x, &units.y);
    const glm::ivec2 pixels = size();
    return {static_cast<float>(x * pixels.x / std::max(1, units.x)),
            static_cast<float>(y * pixels.y / std::max(1, units.y))};
  }

  static void push(GLFWwindow* window, InputEvent event) {
    of(window).happened_ = true;
    if (InputQueue* input = of(window).input_) input->push(std::move(event));
  }

  void set_callbacks() {
    glfwSetWindowUserPointer(window_, this);
    glfwSetInputMode(window_, GLFW_LOCK_KEY_MODS, GLFW_FALSE);
    glfwSetCursorPosCallback(window_,
                             [](GLFWwindow* w, double x, double y) { push(w, MouseMove{of(w).in_pixels(x, y)}); });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int entered) {
      if (entered == GLFW_FALSE) push(w, MouseMove{{-FLT_MAX, -FLT_MAX}});
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int mods) {
      push(w, MouseButton{button, action == GLFW_PRESS, modifiers_of(mods)});
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) {
      push(w, MouseWheel{{static_cast<float>(x), static_cast<float>(y)}});
    });
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int /*scancode*/, int action, int mods) {
      if (key != GLFW_KEY_UNKNOWN) {
        push(w, KeyChange{static_cast<Key>(key), action != GLFW_RELEASE, modifiers_of(mods)});
      }
    });
    glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned code) { push(w, Character{code}); });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int focused) {
      if (focused == GLFW_FALSE) push(w, FocusLost{});
    });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { of(w).exposed_ = of(w).happened_ = true; });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { of(w).happened_ = true; });
    glfwSetWindowIconifyCallback(window_, [](GLFWwindow* w, int) { of(w).happened_ = true; });
    glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) { of(w).happened_ = true; });
    glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
      push(w, FileDrop{{paths, paths + count}});
    });
  }

  InputQueue* input_ = nullptr;
  GLFWwindow* window_ = nullptr;
  view::GlFunctions gl_;
  std::array<GLFWcursor*, 6> cursors_{};
  Cursor shown_ = Cursor::arrow;
  bool exposed_ = false;
  bool happened_ = false;
  std::atomic<bool> woken_ = false;
};

}  // namespace

Result<std::unique_ptr<Window>> make_glfw_window(glm::ivec2 size, bool maximised, const std::string& title) {
  return GlfwWindow::create(size, maximised, title);
}

}  // namespace glint::gui
