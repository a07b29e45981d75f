#include "viewers/screen.h"

#include <utility>

#include "viewers/widgets/theme.h"

namespace glint::view {

Result<std::unique_ptr<Screen>> Screen::create(GlContext& context, float scale) {
  std::unique_ptr<Screen> screen(new Screen(context));
  screen->imgui_ = ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  Result<std::unique_ptr<DrawRenderer>> renderer = DrawRenderer::create(context.gl());
  if (!renderer) return renderer.error();
  screen->renderer_ = std::move(*renderer);
  screen->set_scale(scale);
  return screen;
}

Screen::~Screen() {
  if (imgui_ != nullptr) ImGui::DestroyContext(imgui_);
}

void Screen::set_scale(float scale) {
  scale_ = scale;
  apply_theme(scale);
  fonts_ = load_fonts(scale);
  ImGui::GetIO().FontDefault = fonts_.text;
  renderer_->upload_fonts();
}

void Screen::draw(glm::ivec2 size, const Frame& frame, const std::function<void(Ui&)>& body) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(size.x), static_cast<float>(size.y)};
  io.DeltaTime = frame.step > 0 ? frame.step : 1e-4F;
  io.ConfigInputTextCursorBlink = !frame.headless;
  pictures_.clear();
  widgets_.clear();
  ImGui::NewFrame();
  Ui ui{context_.gl(), fonts_, pictures_, widgets_, state_, scale_, frame.seconds, frame.headless, frame.blocked};
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(io.DisplaySize);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  constexpr ImGuiWindowFlags k_host = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                                      ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                      ImGuiWindowFlags_NoBackground;
  ImGui::Begin("##host", nullptr, k_host);
  ImGui::PopStyleVar(3);
  body(ui);
  ImGui::End();
  ImGui::Render();
  if (size.x > 0 && size.y > 0) paint(size);
  state_.focus.activate = false;
  state_.focus.right = state_.focus.down = 0;
  state_.focus.moved = false;
}

void Screen::paint(glm::ivec2 size) {
  if (!canvas_ || canvas_->size() != size) {
    canvas_ = std::make_unique<Framebuffer>(context_.gl(), size);
    damage_.forget();
  }
  const std::vector<PixelRectangle> damaged = damage_.update(*ImGui::GetDrawData());
  canvas_->bind();
  renderer_->draw(*ImGui::GetDrawData(), damaged, as_vector(color::k_window));
  changed_ = changed_ || !damaged.empty();
}

bool Screen::show(bool anyway) {
  if (!canvas_ || !(changed_ || anyway)) return false;
  canvas_->copy_to_window();
  changed_ = false;
  return true;
}

std::vector<std::uint8_t> Screen::pixels() const {
  if (!canvas_) return {};
  canvas_->bind();
  return read_pixels(context_.gl(), canvas_->size());
}

}  // namespace glint::view
