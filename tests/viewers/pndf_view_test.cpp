#include "viewers/pndf/pndf_view.h"

#include <cmath>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/gui/golden.h"
#include "tests/viewers/stage.h"

namespace glint::view {
namespace {

using testing::HasSubstr;

// A round lobe of that height at (0.3, 0.2).
std::shared_ptr<const PndfImage> lobe_image(int cells, double height, bool random) {
  auto image = std::make_shared<PndfImage>();
  image->grid = {-1, 1, -1, 1, cells, cells};
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const glm::dvec2 d = image->grid.center(column, row) - glm::dvec2(0.3, 0.2);
      image->density.push_back(height * std::exp(-20 * (d.x * d.x + d.y * d.y)));
    }
  }
  if (random) image->standard_error.assign(image->density.size(), 0.25);
  image->error = {random ? 0 : 1e-7, random ? 0.03 : 0};
  return image;
}

MethodPicture method_picture(PndfMethod method, std::shared_ptr<const PndfImage> image) {
  MethodPicture picture;
  picture.method = method;
  picture.image = std::move(image);
  picture.milliseconds = 68;
  picture.revision = 1;
  return picture;
}

class PndfViewTest : public testing::Test {
 protected:
  PndfViewTest() : stage_({960, 440}) {
    document_.methods = {PndfMethod::exact, PndfMethod::binning};
    document_.grid.window = glm::dvec4(-1, 1, -1, 1);
    results_ = std::make_shared<PndfResults>();
    results_->revision = 1;
    results_->grid = {-1, 1, -1, 1, 64, 64};
    results_->methods = {method_picture(PndfMethod::exact, lobe_image(64, 6, false)),
                         method_picture(PndfMethod::binning, lobe_image(64, 5, true))};
    frame();
  }

  void frame() {
    stage_.frame([&](Ui& ui) {
      PndfInput input{document_};
      input.revision = revision_;
      input.results = results_;
      input.nothing_because = nothing_because_;
      input.cancelled = !nothing_because_.empty();
      input.busy = busy_;
      input.computing = computing_;
      input.progress = 0.4;
      input.flipped = flipped_;
      input.flip_chord = "R";
      events_ = view_->draw(ui, {{10, 10}, {932, 414}}, input);
    });
    if (!events_.edit) return;
    edits_.push_back(*events_.edit);
    document_ = events_.edit->document;  // what the editor does
  }

  [[nodiscard]] Rectangle area(const char* name) const {
    const WidgetRecord::Entry* entry = stage_.widgets().find(name);
    EXPECT_NE(entry, nullptr) << name;
    return entry != nullptr ? entry->area : Rectangle{};
  }
  // Over a picture, at a normal of the whole disk.
  void move_to(const char* picture, glm::dvec2 s) {
    const Rectangle square = area(picture);
    stage_.io().MousePos = {square.min.x + static_cast<float>(0.5 * (s.x + 1)) * square.width(),
                            square.min.y + static_cast<float>(0.5 * (1 - s.y)) * square.height()};
    frame();
  }
  void press(int button) {
    stage_.io().MouseDown[button] = true;
    frame();
  }
  void release(int button) {
    stage_.io().MouseDown[button] = false;
    frame();
  }
  void click(const char* name) {
    stage_.io().MousePos = area(name).center();
    frame();
    press(0);
    release(0);
    frame();
  }
  // Into an entry, ended by a click elsewhere.
  void type(const char* name, const char* text) {
    click(name);
    frame();
    stage_.io().AddInputCharactersUTF8(text);
    frame();
    stage_.io().MousePos = {940, 430};
    frame();
    press(0);
    release(0);
    frame();
  }
  [[nodiscard]] int blue_pixels(const char* name) const {
    const Rectangle square = area(name);
    const std::vector<std::uint8_t> rgb = stage_.pixels();
    int count = 0;
    for (int y = static_cast<int>(square.min.y); y < static_cast<int>(square.max.y); ++y) {
      for (int x = static_cast<int>(square.min.x); x < static_cast<int>(square.max.x); ++x) {
        const auto at = static_cast<std::size_t>(3 * (y * stage_.size().x + x));
        if (rgb[at + 2] > rgb[at] + 20) ++count;
      }
    }
    return count;
  }

  test::Stage stage_;
  std::unique_ptr<PndfView> view_ = std::make_unique<PndfView>();
  Document document_;
  std::shared_ptr<PndfResults> results_;
  std::uint64_t revision_ = 1;
  std::string nothing_because_;
  bool busy_ = false;
  std::optional<PndfMethod> computing_;
  bool flipped_ = false;
  PndfEvents events_;
  std::vector<Edit> edits_;
};

TEST_F(PndfViewTest, RecordsEveryPictureAndEveryControl) {
  for (const char* name :
       {"pndf.picture.exact", "pndf.picture.binning", "pndf.picture.difference", "pndf.bar", "grid.window.whole",
        "grid.window.fit", "view.density_scale.log", "view.density_scale.linear", "grid.size",
        "view.density_range.highest", "view.density_range.lowest", "view.density_range.fit", "view.difference_range"}) {
    EXPECT_NE(stage_.widgets().find(name), nullptr) << name;
  }
  ASSERT_NE(stage_.widgets().find("pndf.time.exact"), nullptr);
  EXPECT_TRUE(stage_.widgets().find("pndf.time.exact")->varies);
  EXPECT_THAT(stage_.widgets().find("view.density_range.fit")->reason, HasSubstr("already"));
}

TEST_F(PndfViewTest, ReadsEveryMethodUnderTheMouse) {
  EXPECT_FALSE(view_->reading());
  move_to("pndf.picture.difference", {0.3, 0.2});
  ASSERT_TRUE(view_->reading());
  const PndfReading& reading = *view_->reading();
  EXPECT_NEAR(reading.s.x, 0.3, 0.01);
  ASSERT_EQ(reading.values.size(), 2U);
  EXPECT_NEAR(*reading.values[0].density, 6, 0.1);
  EXPECT_FALSE(reading.values[0].standard_error);
  EXPECT_NEAR(*reading.values[1].density, 5, 0.1);
  EXPECT_EQ(reading.values[1].standard_error, 0.25);
  EXPECT_THAT(view_->reading_text(), HasSubstr("D binning "));
}

TEST_F(PndfViewTest, PinsTheCrosshairUntilItsRingIsClicked) {
  move_to("pndf.picture.exact", {0.3, 0.2});
  press(0);
  release(0);
  stage_.io().MousePos = {1, 1};
  frame();
  ASSERT_TRUE(view_->reading());
  EXPECT_NEAR(view_->reading()->s.y, 0.2, 0.01);
  stage_.io().MouseDoubleClickTime = 0;  // the next click is one of its own
  move_to("pndf.picture.binning", {0.3, 0.2});
  press(0);
  release(0);
  stage_.io().MousePos = {1, 1};
  frame();
  EXPECT_FALSE(view_->reading());
  EXPECT_TRUE(edits_.empty()) << "the crosshair is no part of the document";
}

TEST_F(PndfViewTest, MovesThePinByCellsFromTheKeyboard) {
  stage_.state().focus.name = "pndf.picture.exact";
  stage_.state().focus.activate = true;
  frame();
  ASSERT_TRUE(view_->reading());
  EXPECT_EQ(view_->reading()->s, glm::dvec2(0, 0));
  stage_.state().focus.right = 2;
  stage_.state().focus.down = -1;
  frame();
  EXPECT_EQ(view_->reading()->s, glm::dvec2(2 / 32.0, 1 / 32.0));
}

TEST_F(PndfViewTest, ZoomsAboutTheCursorAsOneStep) {
  move_to("pndf.picture.exact", {0.5, 0});
  stage_.io().MouseWheel = 1;
  frame();
  ASSERT_EQ(edits_.size(), 1U);
  EXPECT_FALSE(edits_[0].finished);
  EXPECT_NEAR(document_.grid.window->y - document_.grid.window->x, 1.6, 0.01);
  stage_.io().MouseWheel = 0;
  for (int k = 0; k < 20 && edits_.size() < 2; ++k) frame();
  ASSERT_EQ(edits_.size(), 2U);
  EXPECT_TRUE(edits_[1].finished);
  EXPECT_EQ(edits_[1].label, edits_[0].label);
}

TEST_F(PndfViewTest, PansWithTheRightButtonAsOneStep) {
  document_.grid.window = glm::dvec4(-0.5, 0.5, -0.5, 0.5);
  frame();
  stage_.io().MousePos = area("pndf.picture.exact").center();
  frame();
  press(1);
  stage_.io().MousePos.x += 0.1F * area("pndf.picture.exact").width();
  frame();
  release(1);
  ASSERT_GE(edits_.size(), 2U);
  EXPECT_FALSE(edits_.front().finished);
  EXPECT_TRUE(edits_.back().finished);
  EXPECT_NEAR(document_.grid.window->x, -0.6, 0.01);
  EXPECT_NEAR(document_.grid.window->w, 0.5, 1e-9);
}

TEST_F(PndfViewTest, TogglesTheWindowByADoubleClick) {
  move_to("pndf.picture.exact", {0.3, 0.2});
  press(0);
  release(0);
  press(0);
  release(0);
  ASSERT_EQ(edits_.size(), 1U);
  EXPECT_FALSE(document_.grid.window);
  stage_.io().MousePos = {1, 1};
  frame();
  EXPECT_FALSE(view_->reading()) << "the first click's pin is taken back";
}

TEST_F(PndfViewTest, ShiftsTheRangeByDraggingTheBar) {
  stage_.io().MousePos = area("pndf.bar").center();
  frame();
  press(0);
  stage_.io().MousePos.y -= 0.25F * area("pndf.bar").height();
  frame();
  ASSERT_FALSE(edits_.empty());
  EXPECT_FALSE(edits_.back().finished);
  release(0);
  EXPECT_TRUE(edits_.back().finished);
  ASSERT_TRUE(document_.view.density_range);
  EXPECT_LT(document_.view.density_range->y, 2) << "was 10";
  frame();
  click("view.density_range.fit");
  EXPECT_FALSE(document_.view.density_range);
}

TEST_F(PndfViewTest, TakesATypedEnd) {
  type("view.density_range.highest", "1e2");
  ASSERT_TRUE(document_.view.density_range);
  EXPECT_DOUBLE_EQ(document_.view.density_range->y, 100);
  EXPECT_DOUBLE_EQ(document_.view.density_range->x, 1e-3) << "as it was fitted";
  type("view.difference_range", "3");
  EXPECT_EQ(document_.view.difference_range, 3);
}

TEST_F(PndfViewTest, RefusesAnEndThatMakesNoRange) {
  type("view.density_range.lowest", "20");
  EXPECT_FALSE(document_.view.density_range);
  EXPECT_THAT(stage_.state().editing_error, HasSubstr("below its upper end"));
  EXPECT_EQ(stage_.state().text, "20") << "it stays to be corrected";
}

TEST_F(PndfViewTest, ShowsADifferenceOfEqualPicturesOnly) {
  EXPECT_GT(blue_pixels("pndf.picture.difference"), 100) << "binning is below exact";
  view_ = std::make_unique<PndfView>();
  results_->methods[1].image = lobe_image(32, 5, true);
  frame();
  EXPECT_EQ(blue_pixels("pndf.picture.difference"), 0) << "another grid";
  results_->methods[1].image = lobe_image(64, 5, true);
  results_->methods[1].coarse = true;
  frame();
  EXPECT_EQ(blue_pixels("pndf.picture.difference"), 0) << "another quality";
  results_->methods[0].coarse = true;
  results_->methods[0].surface = Interpolation::linear;
  frame();
  EXPECT_EQ(blue_pixels("pndf.picture.difference"), 0) << "another surface";
}

TEST_F(PndfViewTest, KeepsTheLastDifferenceUntilThereIsANewerOne) {
  results_->methods[1].image = lobe_image(32, 5, true);
  frame();
  EXPECT_GT(blue_pixels("pndf.picture.difference"), 100);
}

TEST_F(PndfViewTest, WhileItWaitsForTheDocumentsPicturesOldFiguresAreGone) {
  const auto figure_width = [&] { return area("pndf.time.binning").width(); };
  const float with_figure = figure_width();
  revision_ = 2;
  busy_ = true;  // reading the map: no method's turn yet
  frame();
  EXPECT_EQ(stage_.widgets().find("pndf.progress.exact"), nullptr);  // not at once: a quick picture does not flicker
  EXPECT_EQ(figure_width(), with_figure);
  for (int k = 0; k < 20; ++k) frame();
  EXPECT_NE(stage_.widgets().find("pndf.progress.exact"), nullptr);
  EXPECT_LT(figure_width(), with_figure);
  computing_ = PndfMethod::binning;
  frame();
  EXPECT_NE(stage_.widgets().find("pndf.refining.binning"), nullptr);
  EXPECT_LT(figure_width(), with_figure);
  test::Picture picture{stage_.size(), stage_.pixels()};
  test::cover_what_varies(picture, stage_.widgets());
  test::expect_golden("busy-pndf-960x440", picture);

  for (MethodPicture& method : results_->methods) method.revision = 2;
  busy_ = false;
  computing_.reset();
  frame();
  EXPECT_EQ(stage_.widgets().find("pndf.progress.exact"), nullptr);
  EXPECT_EQ(figure_width(), with_figure);
}

TEST_F(PndfViewTest, OffersToComputeAgainWhatWasCancelled) {
  results_.reset();
  nothing_because_ = "The computation was cancelled.";
  frame();
  stage_.io().MousePos = area("pndf.restart").center();
  frame();
  press(0);
  stage_.io().MouseDown[0] = false;
  frame();
  EXPECT_TRUE(events_.restart_pressed);
}

TEST_F(PndfViewTest, OffersItInTheOnePictureThatIsMissing) {
  results_->methods[1].image = nullptr;
  nothing_because_ = "The computation was cancelled.";
  frame();
  stage_.io().MousePos = area("pndf.restart").center();
  frame();
  press(0);
  stage_.io().MouseDown[0] = false;
  frame();
  EXPECT_TRUE(events_.restart_pressed);
}

TEST_F(PndfViewTest, KeepsItsPlacesWhateverTheValuesAre) {
  const Rectangle before = area("pndf.picture.difference");
  results_->methods[0].milliseconds = 123456;
  results_->methods[0].coarse = true;
  results_->methods[0].progress = 0.41;
  results_->methods[1].image = nullptr;
  frame();
  EXPECT_EQ(area("pndf.picture.difference").min.x, before.min.x);
  EXPECT_EQ(area("pndf.picture.difference").max.y, before.max.y);
  EXPECT_TRUE(stage_.widgets().find("pndf.refining.exact")->varies);
}

TEST_F(PndfViewTest, ChangesNoFigureWhileFlipped) {
  results_->reference = lobe_image(64, 4, false);
  move_to("pndf.picture.exact", {0.3, 0.2});
  const std::string before = view_->reading_text();
  EXPECT_THAT(before, HasSubstr("D reference "));
  const std::vector<std::uint8_t> seen = stage_.pixels();
  flipped_ = true;
  frame();
  EXPECT_EQ(view_->reading_text(), before);
  EXPECT_NE(stage_.pixels(), seen);
}

TEST_F(PndfViewTest, FindingsStandInTheTooltipOfTheirMethod) {
  const Rectangle square = area("pndf.picture.binning");
  stage_.io().MousePos = {square.min.x + 12, square.min.y - 12};  // its title
  frame();
  frame();
  const std::vector<std::uint8_t> without = stage_.pixels();
  results_->methods[1].findings = {"elements at h = 0.5 ripple by 5.5 %"};
  frame();
  frame();
  EXPECT_NE(stage_.pixels(), without);
}

}  // namespace
}  // namespace glint::view
