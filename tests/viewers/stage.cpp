#include "tests/viewers/stage.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "core/image/png_file.h"
#include "gui/platform/osmesa_context.h"
#include "viewers/screen.h"

namespace glint::test {

struct Stage::Own {
  std::unique_ptr<view::GlContext> context;
  std::unique_ptr<view::Screen> screen;
  double seconds = 0;
};

Stage::Stage(glm::ivec2 size, float scale) : own_(std::make_unique<Own>()) {
  auto context = gui::make_osmesa_context(size);
  if (!context) throw std::runtime_error(context.error().message());
  own_->context = std::move(*context);
  auto screen = view::Screen::create(*own_->context, scale);
  if (!screen) throw std::runtime_error(screen.error().message());
  own_->screen = std::move(*screen);
}

Stage::~Stage() = default;

const view::GlFunctions& Stage::gl() const {
  return own_->context->gl();
}
glm::ivec2 Stage::size() const {
  return own_->context->size();
}
ImGuiIO& Stage::io() const {
  return ImGui::GetIO();
}
view::UiState& Stage::state() {
  return own_->screen->state();
}
const view::WidgetRecord& Stage::widgets() const {
  return own_->screen->widgets();
}

void Stage::frame(const std::function<void(view::Ui&)>& body) {
  own_->seconds += 1.0 / 60;
  own_->screen->draw(size(), {.seconds = own_->seconds, .headless = true}, body);
}

void Stage::click(const char* widget, const std::function<void(view::Ui&)>& body) {
  const view::WidgetRecord::Entry* entry = widgets().find(widget);
  ASSERT_NE(entry, nullptr) << widget;
  io().MousePos = entry->area.center();
  frame(body);
  io().MouseDown[0] = true;
  frame(body);
  io().MouseDown[0] = false;
  frame(body);
  frame(body);
}

std::vector<std::uint8_t> Stage::pixels() const {
  return own_->screen->pixels();
}

void Stage::save(const std::filesystem::path& png) const {
  const Status written = write_png_8(png, size().x, size().y, pixels());
  ASSERT_TRUE(written) << written.error().message();
}

}  // namespace glint::test
