// Frames are drawn only where they changed: the same pixels as when all is drawn, and few of them.

#include "viewers/gl/draw_damage.h"

#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "gui/platform/osmesa_context.h"
#include "tests/viewers/full_redraw.h"
#include "tests/viewers/stage.h"
#include "viewers/screen.h"

namespace glint::test {
namespace {

using view::DrawDamage;
using view::PixelRectangle;

int area_of(const std::vector<PixelRectangle>& rectangles) {
  int area = 0;
  for (const PixelRectangle& rectangle : rectangles) area += rectangle.area();
  return area;
}

// Panels, letters and a picture that move, change their colours and their values.
class Scenery {
 public:
  explicit Scenery(const view::GlFunctions& gl) : gl_(gl) { new_values(); }

  void change() {
    switch (std::uniform_int_distribution(0, 5)(engine_)) {
      case 0:
        place_ = {coordinate(), coordinate()};
        break;
      case 1:
        hue_ = IM_COL32(byte(), byte(), byte(), 255);
        break;
      case 2:
        veil_ = IM_COL32(byte(), byte(), byte(), byte());
        break;
      case 3:
        highest_ = 0.5F + 0.01F * static_cast<float>(byte());
        break;
      case 4:
        new_values();
        break;
      default:
        ++count_;
    }
  }

  void draw(view::Ui& ui) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({20, 20}, {380, 280}, hue_, 4);
    list.AddImage(ui.pictures.add(values_, {view::Shading::Kind::density, 0.1F, highest_, false, true}), {200, 40},
                  {360, 200});
    list.PushClipRect({30, 30}, {330, 250}, true);
    list.AddRectFilled(place_, {place_.x + 90, place_.y + 70}, veil_);
    list.AddCircle({place_.x + 40, place_.y + 40}, 50, IM_COL32(255, 255, 255, 128), 40, 2);
    list.PopClipRect();
    list.AddText({40, 255}, IM_COL32_WHITE, ("frame " + std::to_string(count_)).c_str());
  }

 private:
  int byte() { return std::uniform_int_distribution(0, 255)(engine_); }
  float coordinate() { return std::uniform_real_distribution(0.0F, 260.0F)(engine_); }
  void new_values() {
    std::vector<float> values(16 * 16);
    for (float& value : values) value = std::uniform_real_distribution(0.0F, 2.0F)(engine_);
    values_ = view::Texture(gl_, view::Texture::Format::value, {16, 16}, values.data());
  }

  const view::GlFunctions& gl_;
  std::mt19937 engine_{3};
  view::Texture values_;
  ImVec2 place_{50, 50};
  ImU32 hue_ = IM_COL32(40, 40, 60, 255);
  ImU32 veil_ = IM_COL32(200, 100, 50, 120);
  float highest_ = 1;
  int count_ = 0;
};

TEST(DrawDamage, DrawsTheSamePixelsAsAFullFrame) {
  Stage stage({400, 300});
  FullRedraw full(stage.gl(), stage.size());
  Scenery scenery(stage.gl());
  std::vector<std::uint8_t> last;
  int changes = 0;
  for (int frame = 0; frame < 120; ++frame) {
    scenery.change();
    stage.frame([&](view::Ui& ui) { scenery.draw(ui); });
    const std::vector<std::uint8_t> seen = stage.pixels();
    ASSERT_EQ(seen, full.pixels()) << "frame " << frame;
    if (seen != last) ++changes;
    last = seen;
  }
  EXPECT_GT(changes, 80);
}

TEST(DrawDamage, IsNothingWhereNothingChanged) {
  Stage stage({400, 300});
  Scenery scenery(stage.gl());
  DrawDamage damage;
  const auto update = [&] {
    stage.frame([&](view::Ui& ui) { scenery.draw(ui); });
    return damage.update(*ImGui::GetDrawData());
  };
  update();
  EXPECT_EQ(area_of(update()), 0);
  damage.forget();
  EXPECT_EQ(area_of(update()), 400 * 300);
}

TEST(DrawDamage, IsAsLargeAsWhatChanged) {
  Stage stage({1280, 720});
  DrawDamage damage;
  const auto with_square_at = [&](float x) {
    stage.frame([&](view::Ui&) {
      ImDrawList& list = *ImGui::GetWindowDrawList();
      list.AddRectFilled({0, 0}, {1280, 720}, IM_COL32(9, 9, 9, 255));
      list.AddRectFilled({x, 100}, {x + 20, 120}, IM_COL32_WHITE);
    });
    return damage.update(*ImGui::GetDrawData());
  };
  with_square_at(100);
  const std::vector<PixelRectangle> moved = with_square_at(900);
  EXPECT_LE(area_of(moved), 8 * 32 * 32);
  const auto holds = [&](int x, int y) {
    return std::any_of(moved.begin(), moved.end(),
                       [&](const PixelRectangle& r) { return x >= r.x0 && x < r.x1 && y >= r.y0 && y < r.y1; });
  };
  EXPECT_TRUE(holds(110, 110));
  EXPECT_TRUE(holds(910, 110));
}

// As when a picture of few cells gives way to one of many.
TEST(DrawDamage, SeesANewPictureThatIsAlsoFilteredAnotherWay) {
  Stage stage({400, 300});
  FullRedraw full(stage.gl(), stage.size());
  std::vector<view::Texture> textures;
  std::mt19937 engine(9);
  for (int k = 0; k < 4; ++k) {
    std::vector<float> values(16 * 16);
    for (float& value : values) value = std::uniform_real_distribution(0.0F, 2.0F)(engine);
    textures.emplace_back(stage.gl(), view::Texture::Format::value, glm::ivec2(16, 16), values.data());
  }
  for (const view::Texture& texture : textures) {
    for (const bool nearest : {true, false}) {
      for (const view::Texture& next : textures) {
        for (const auto& [shown, squares] : {std::pair{&texture, nearest}, std::pair{&next, !nearest}}) {
          stage.frame([&, shown = shown, squares = squares](view::Ui& ui) {
            const view::Shading shading{view::Shading::Kind::density, 0.1F, 2, false, squares};
            ImGui::GetWindowDrawList()->AddImage(ui.pictures.add(*shown, shading), {20, 20}, {220, 220});
          });
          ASSERT_EQ(stage.pixels(), full.pixels());
        }
      }
    }
  }
}

TEST(DrawDamage, ShapesAnyDistanceAwayAreNoTrouble) {
  Stage stage({400, 300});
  FullRedraw full(stage.gl(), stage.size());
  DrawDamage damage;
  for (const float far : {1e6F, 3e9F, 1e11F, 3e38F, -1e11F, std::numeric_limits<float>::quiet_NaN()}) {
    stage.frame([&](view::Ui&) {
      ImDrawList& list = *ImGui::GetWindowDrawList();
      list.AddRectFilled({far, 10}, {far + 20, 30}, IM_COL32_WHITE);
      list.AddRectFilled({10, far}, {30, far + 20}, IM_COL32_WHITE);
      list.AddRectFilled({-far, 40}, {far, 60}, IM_COL32(90, 0, 0, 255));
    });
    for (const PixelRectangle& r : damage.update(*ImGui::GetDrawData())) {
      EXPECT_TRUE(r.x0 >= 0 && r.y0 >= 0 && r.x1 <= 400 && r.y1 <= 300) << far;
    }
    EXPECT_EQ(stage.pixels(), full.pixels()) << far;
  }
}

TEST(DrawDamage, AWindowOfAnotherSizeOrScaleIsDrawnWhole) {
  auto context = gui::make_osmesa_context({800, 600});
  ASSERT_TRUE(context) << context.error().message();
  auto screen = view::Screen::create(**context, 1);
  ASSERT_TRUE(screen) << screen.error().message();
  const auto body = [](view::Ui& ui) {
    ImGui::GetWindowDrawList()->AddText(ui.fonts.text, ui.fonts.text->FontSize, {30, 30}, IM_COL32_WHITE, "Letters");
    ImGui::GetWindowDrawList()->AddRectFilled({100, 100}, {300, 200}, IM_COL32(30, 90, 60, 255));
  };
  double seconds = 0;
  const auto expect_whole = [&](glm::ivec2 size) {
    (*screen)->draw(size, {.seconds = seconds += 0.1, .headless = true}, body);
    FullRedraw full((*context)->gl(), size);
    EXPECT_EQ((*screen)->pixels(), full.pixels()) << size.x;
  };
  expect_whole({640, 480});
  expect_whole({800, 600});
  expect_whole({640, 480});
  (*screen)->set_scale(2);
  expect_whole({640, 480});
}

TEST(DrawDamage, ManySmallChangesAreFewRectanglesThatShareNoPixel) {
  Stage stage({1280, 720});
  DrawDamage damage;
  std::mt19937 engine(5);
  for (int frame = 0; frame < 30; ++frame) {
    stage.frame([&](view::Ui&) {
      for (int k = 0; k < 40; ++k) {
        const ImVec2 at{std::uniform_real_distribution(0.0F, 1270.0F)(engine),
                        std::uniform_real_distribution(0.0F, 710.0F)(engine)};
        ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + 9, at.y + 9}, IM_COL32_WHITE);
      }
    });
    const std::vector<PixelRectangle> rectangles = damage.update(*ImGui::GetDrawData());
    ASSERT_LE(rectangles.size(), 12U);
    if (frame > 0) {
      ASSERT_LT(area_of(rectangles), 1280 * 720);
    }
    for (std::size_t i = 0; i < rectangles.size(); ++i) {
      for (std::size_t j = i + 1; j < rectangles.size(); ++j) {
        ASSERT_TRUE(view::common_part(rectangles[i], rectangles[j]).empty());
      }
    }
  }
}

}  // namespace
}  // namespace glint::test
