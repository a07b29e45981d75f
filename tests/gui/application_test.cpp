// The whole window without a display: what clicks, drags, keys and scripts do to the document.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <set>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/document/names.h"
#include "core/document/preset.h"
#include "core/document/workspace.h"
#include "core/image/pndf_exr.h"
#include "tests/gui/application_stage.h"
#include "tests/viewers/full_redraw.h"

namespace glint::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Application, EveryActionSaysWhatItDoesAndNoTwoShareAChord) {
  const ApplicationStage stage;
  EXPECT_THAT(stage.app().actions().faults(), IsEmpty());
  for (const gui::Action& action : stage.app().actions().all()) {
    EXPECT_FALSE(action.title.empty()) << action.name;
    EXPECT_GT(action.tooltip.size(), 12U) << action.name;
    EXPECT_TRUE(!action.menu.empty() || action.chord) << action.name << " can only be found in the palette";
  }
}

TEST(Application, ADisabledActionSaysWhyAndChangesNothing) {
  const ApplicationStage stage;
  stage.open_small();
  const Document before = stage.document();
  for (const gui::Action& action : stage.app().actions().all()) {
    const std::string reason = action.disabled_because();
    if (reason.empty()) continue;
    EXPECT_THAT(stage.app().run_action(action.name), HasSubstr(reason)) << action.name;
  }
  EXPECT_EQ(stage.document(), before);
}

TEST(Application, AClickInTheMapPlacesTheFootprintAndItsPicturesFollow) {
  const ApplicationStage stage;
  stage.open_small();
  stage.play("map-click 60.5,62.25\nwait jobs\nexpect footprint.center 60.5,62.25 0.3");
  const auto results = stage.app().workbench().jobs().results();
  ASSERT_NE(results, nullptr);
  EXPECT_EQ(results->revision, stage.app().workbench().editor().revision());
  EXPECT_EQ(results->document.footprint, stage.document().footprint);
  ASSERT_EQ(results->methods.size(), 2U);
  for (const view::MethodPicture& picture : results->methods) {
    ASSERT_NE(picture.image, nullptr);
    EXPECT_FALSE(picture.coarse);
    EXPECT_TRUE(picture.errors.has_value());
  }
}

TEST(Application, FramesDrawnWhereTheyChangedLookLikeWholeOnes) {
  const ApplicationStage stage;
  FullRedraw full(stage.window->gl(), {1280, 720});
  stage.open_small();
  gui::InputQueue& input = stage.app().input();
  const ImVec2 at = stage.app().panels().map().picture().center();
  for (int k = 0; k < 60; ++k) {
    input.push(gui::MouseMove{{at.x + 3 * static_cast<float>(k), at.y - 30 + static_cast<float>(k)}});
    if (k == 5) input.push(gui::MouseButton{0, true, {}, true});
    if (k == 25) input.push(gui::MouseButton{0, false, {}, true});
    if (k > 30 && k < 40) input.push(gui::MouseWheel{{0, k < 36 ? 1.0F : -1.0F}});
    if (k == 45) stage.app().overlays().open_palette();
    if (k == 50) input.push(gui::Character{'s'});
    stage.frames(1);
    ASSERT_EQ(stage.app().screen().pixels(), full.pixels()) << "frame " << k;
  }
}

TEST(Application, ADragOfAHandleIsOneStepOfUndo) {
  const ApplicationStage stage;
  stage.open_small();
  const Document before = stage.document();
  stage.play("drag map.handle.1 30,-12");
  EXPECT_FALSE(stage.document().footprint.covariance == before.footprint.covariance);
  EXPECT_FALSE(document_fault(stage.document()).has_value());
  stage.play("key Ctrl+Z");
  EXPECT_EQ(stage.document(), before);
  stage.play("key Ctrl+Y");
  EXPECT_FALSE(stage.document() == before);
}

TEST(Application, ElementsOnTheMapAreOneStepOfUndoAndFollowTheCrosshair) {
  const ApplicationStage stage;
  stage.open_small();
  const gui::Action* action = stage.app().actions().find("view.elements");
  ASSERT_NE(action, nullptr);
  EXPECT_EQ(action->disabled_because(), "The mixture is not among the methods");
  stage.play("key E\nwait 2");
  EXPECT_FALSE(stage.document().view.elements);
  stage.play("set methods exact,mixture\nkey E\naction view.footprint\nwait jobs");
  EXPECT_TRUE(stage.document().view.elements);
  EXPECT_TRUE(action->is_checked());
  ASSERT_NE(stage.widget("map.elements"), nullptr);
  const float of_weight = stage.widget("map.elements")->area.width();
  stage.play("click pndf.picture.exact\nwait 3");
  EXPECT_NE(stage.widget("map.elements")->area.width(), of_weight);  // its legend speaks of the density
  stage.play("set view.elements false\nkey Ctrl+Z");
  EXPECT_TRUE(stage.document().view.elements);
  stage.play("key Ctrl+Z");
  EXPECT_FALSE(stage.document().view.elements);
}

TEST(Application, RestsWithElementsOnAMapThatIsNotSeen) {
  const ApplicationStage stage;
  stage.open_small();
  stage.play("set methods exact,mixture\nkey E\naction view.footprint\nwait jobs");
  stage.play("click pndf.maximise\nwait 2\nclick pndf.picture.exact\nwait jobs");
  ASSERT_TRUE(stage.document().view.elements);
  ASSERT_TRUE(stage.app().panels().pndf().reading().has_value());
  for (int k = 0; k < 300 && stage.app().pace() != gui::Application::Pace::on_event; ++k) stage.frames(1);
  EXPECT_EQ(stage.app().pace(), gui::Application::Pace::on_event);
}

TEST(Application, ASliderDragIsOneStepOfUndo) {
  const ApplicationStage stage;
  stage.open_small();
  const Document before = stage.document();
  stage.play("drag intrinsic_roughness.slider 20,0");
  EXPECT_NE(stage.document().intrinsic_roughness, before.intrinsic_roughness);
  EXPECT_EQ(stage.app().workbench().editor().undo_label().find("Roughness"), 0U)
      << stage.app().workbench().editor().undo_label();
  stage.play("key Ctrl+Z");
  EXPECT_EQ(stage.document(), before);
}

TEST(Application, ATypedValueCountsWhenItIsEnteredAndARefusedOneSaysWhy) {
  const ApplicationStage stage;
  stage.open_small();
  stage.play("click intrinsic_roughness\nkey Ctrl+A\ntype 0.05\nkey Enter\nexpect intrinsic_roughness 0.05");
  const Document before = stage.document();
  stage.play("click intrinsic_roughness\nkey Ctrl+A\ntype 7\nkey Enter\nwait 3");
  EXPECT_EQ(stage.document(), before);
  EXPECT_THAT(stage.app().screen().state().editing_error, HasSubstr("allowed"));
  stage.play("key Esc\nwait 3");
  EXPECT_EQ(stage.document(), before);
}

TEST(Application, EscapeTakesBackADragUnderWay) {
  const ApplicationStage stage;
  stage.open_small();
  const Document before = stage.document();
  gui::InputQueue& input = stage.app().input();
  const view::Rectangle area = stage.widget("map.handle.1")->area;
  input.push(gui::MouseMove{area.center()});
  stage.frames(2);
  input.push(gui::MouseButton{0, true, {}, true});
  stage.frames(2);
  input.push(gui::MouseMove{{area.center().x + 25, area.center().y + 10}});
  stage.frames(3);
  EXPECT_FALSE(stage.document() == before);
  input.push(gui::KeyChange{gui::Key::escape, true, {}});
  input.push(gui::KeyChange{gui::Key::escape, false, {}});
  stage.frames(3);
  EXPECT_EQ(stage.document(), before);
  input.push(gui::MouseMove{{area.center().x + 40, area.center().y + 10}});
  stage.frames(2);
  input.push(gui::MouseButton{0, false, {}, true});
  stage.frames(3);
  EXPECT_EQ(stage.document(), before);
}

TEST(Application, AHundredEditsInFiveSecondsShowPicturesOnTheWayAndEndWithThoseOfTheLast) {
  using Clock = std::chrono::steady_clock;
  const ApplicationStage stage;
  stage.open_small();
  std::set<std::uint64_t> shown;
  for (int k = 0; k < 100; ++k) {
    stage.app().workbench().change("Footprint", [&](Document& document) {
      document.footprint.center = {40 + 0.37 * k, 70 - 0.21 * k};
      document.intrinsic_roughness = 0.02 + 0.0002 * k;
    });
    const Clock::time_point next = Clock::now() + std::chrono::milliseconds(50);
    do {
      stage.window->frame(false);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      const auto results = stage.app().workbench().jobs().results();
      ASSERT_NE(results, nullptr);
      shown.insert(results->methods.at(0).revision);
    } while (Clock::now() < next);
  }
  EXPECT_GT(shown.size(), 10U);
  stage.settle();
  const auto results = stage.app().workbench().jobs().results();
  EXPECT_EQ(results->document.footprint.center, glm::dvec2(40 + 0.37 * 99, 70 - 0.21 * 99));
  const Surface& surface = results->surface->loaded.surface;
  JobControl control;
  const auto model = make_document_model(stage.document(), PndfMethod::exact, surface);
  const auto expected = model->image(stage.document().footprint, document_grid(stage.document(), surface), control);
  EXPECT_EQ(results->methods[0].image->density, expected->density);
  EXPECT_TRUE(stage.app().workbench().editor().can_undo());
}

TEST(Application, ClosingWhileJobsRunIsQuick) {
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin;
  {
    const ApplicationStage stage;
    stage.open_small();
    stage.play("set footprint.covariance 900,0,900\nset binning.samples 1e9\nset grid.size 1024\nwait 3");
    EXPECT_FALSE(stage.app().jobs_idle());
    begin = Clock::now();
  }
  EXPECT_LT(std::chrono::duration<double>(Clock::now() - begin).count(), 10.0);  // the jobs would take minutes
}

TEST(Application, CancelKeepsThePicturesAndTheNextEditComputesAgain) {
  const ApplicationStage stage;
  stage.open_small();
  stage.play("set binning.samples 2e9\nwait 5");
  EXPECT_FALSE(stage.app().jobs_idle());
  stage.play("click status.cancel\nwait 5");
  EXPECT_TRUE(stage.app().workbench().jobs().cancelled());
  EXPECT_TRUE(stage.app().jobs_idle());
  EXPECT_NE(stage.app().workbench().jobs().results()->methods[0].image, nullptr);
  stage.play("set binning.samples 100000\nwait jobs");
  EXPECT_FALSE(stage.app().workbench().jobs().cancelled());
}

TEST(Application, ABrokenFileIsOneSentenceAndChangesNothing) {
  const ApplicationStage stage;
  stage.open_small();
  const Document before = stage.document();
  write_text(stage.folder / "broken.png", "\x89PNG\r\n\x1a\nnothing");
  stage.app().workbench().open(stage.folder / "broken.png");
  stage.settle();
  EXPECT_EQ(stage.document(), before);
  ASSERT_NE(stage.app().workbench().messages().newest(), nullptr);
  EXPECT_THAT(stage.app().workbench().messages().newest()->text, HasSubstr("broken.png"));
  stage.frames(200);
  EXPECT_NE(stage.widget("message.0.close"), nullptr) << "messages stay until they are dismissed";
  stage.play("click message.0.close");
  EXPECT_EQ(stage.app().workbench().messages().newest(), nullptr);
}

TEST(Application, ADroppedMapIsOpened) {
  const ApplicationStage stage;
  stage.open_small();
  stage.play("export normals " + (stage.folder / "dropped.exr").string());
  stage.app().input().push(gui::FileDrop{{stage.folder / "dropped.exr"}});
  stage.frames(1);
  stage.settle();
  EXPECT_EQ(stage.document().surface.source, SurfaceSource::file);
  EXPECT_EQ(stage.document().surface.path.filename(), "dropped.exr");
  EXPECT_TRUE(stage.app().workbench().editor().is_saved());
}

TEST(Application, AnExportedExrRestoresTheDocument) {
  const ApplicationStage stage;
  stage.open_small();
  stage.play("map-click 61,59\nset intrinsic_roughness 0.025\nwait jobs");
  const Document exported = stage.document();
  stage.play("export images " + (stage.folder / "out.exr").string() + "\npreset flat-oracle\nwait jobs\nopen " +
             (stage.folder / "out.exr").string() + "\nwait jobs");
  EXPECT_EQ(stage.document().footprint, exported.footprint);
  EXPECT_EQ(stage.document().intrinsic_roughness, exported.intrinsic_roughness);
  EXPECT_EQ(stage.document().surface.noise, exported.surface.noise);
}

TEST(Application, EveryPanelCanBeExportedAsAPicture) {
  const ApplicationStage stage;
  stage.open_small();
  for (const char* what : {"map", "pndf", "inspector", "window"}) {
    const std::filesystem::path file = stage.folder / (std::string(what) + ".png");
    stage.play("export " + std::string(what) + " " + file.string());
    EXPECT_GT(std::filesystem::file_size(file), 1000U) << what;
  }
  EXPECT_FALSE(stage.app().export_to("nonsense", stage.folder / "x.png"));
  EXPECT_FALSE(stage.app().export_to("map", stage.folder / "x.gif"));
  EXPECT_FALSE(std::filesystem::exists(stage.folder / "x.png"));
}

TEST(Application, SavingUnderANameOfOnesOwnMakesAPresetThatIsListed) {
  const ApplicationStage stage;
  stage.open_small();
  stage.play("set intrinsic_roughness 0.04");
  EXPECT_FALSE(stage.app().workbench().editor().is_saved());
  const Status saved = stage.app().workbench().save_to(stage.folder / "own" / "my-steel.json", "my steel");
  ASSERT_TRUE(saved) << saved.error().message();
  EXPECT_TRUE(stage.app().workbench().editor().is_saved());
  EXPECT_EQ(stage.document().name, "my steel");
  const auto& presets = stage.app().workbench().presets();
  EXPECT_TRUE(std::any_of(presets.begin(), presets.end(), [](const PresetEntry& e) { return e.name == "my-steel"; }));
  stage.play("preset my-steel\nwait jobs\nexpect intrinsic_roughness 0.04");
}

TEST(Application, ThePresetsThatShipAreNotOverwritten) {
  const ApplicationStage stage;
  stage.play("preset flat-oracle\nwait jobs");
  EXPECT_FALSE(stage.app().workbench().can_save_in_place());
}

TEST(Application, HoldingTheKeyShowsTheReferenceAndLettingGoTakesItBack) {
  const ApplicationStage stage({1600, 1000});
  stage.open_small();
  stage.frames(3);
  const Picture before = stage.picture();
  stage.app().input().push(gui::KeyChange{gui::Key::r, true, {}});
  stage.frames(3);
  const Picture held = stage.picture();
  EXPECT_GT(compare_pictures(before, held).differing, 1e-3);
  stage.app().input().push(gui::KeyChange{gui::Key::r, false, {}});
  stage.frames(3);
  EXPECT_LT(compare_pictures(before, stage.picture()).differing, 2e-4);
}

TEST(Application, TheCrosshairReadsEveryMethodAndCanBeCopied) {
  const ApplicationStage stage;
  stage.open_small();
  stage.play("click pndf.picture.exact\nwait 3");
  const auto& reading = stage.app().panels().pndf().reading();
  ASSERT_TRUE(reading.has_value());
  ASSERT_EQ(reading->values.size(), 2U);
  stage.play("action edit.copy");
  EXPECT_THAT(stage.window->clipboard(), HasSubstr("exact"));
  EXPECT_THAT(stage.window->clipboard(), HasSubstr("binning"));
}

TEST(Application, TheExactPictureCanBeCheckedAgainstDoublePrecision) {
  const ApplicationStage stage;
  stage.open_small();
  stage.play("wait jobs");
  EXPECT_THAT(stage.app().run_action("compute.check_precision"), HasSubstr("There is no crosshair"));
  stage.play("click pndf.picture.exact\nwait 3\naction compute.check_precision\nwait jobs\nwait 3");
  const gui::Message* message = stage.app().workbench().messages().newest();
  ASSERT_NE(message, nullptr);
  double single_precision = 0;
  double double_precision = 0;
  const std::string values = message->text.substr(message->text.find(": ") + 2);
  ASSERT_EQ(
      std::sscanf(values.c_str(), "%lf in single and %lf in double precision", &single_precision, &double_precision), 2)
      << message->text;
  const auto picture = stage.app().workbench().jobs().results()->methods[0].image;
  EXPECT_TRUE(std::any_of(picture->density.begin(), picture->density.end(), [&](double density) {
    return std::abs(density - single_precision) <= 1e-6 * single_precision;
  })) << "the picture holds no such value";
  EXPECT_GT(double_precision, 0);
  EXPECT_NEAR(single_precision, double_precision, 1e-4 * double_precision);
  EXPECT_NE(single_precision, double_precision) << "they were not computed apart";
  stage.play("set exact.precision double\nwait jobs");
  EXPECT_THAT(stage.app().run_action("compute.check_precision"), HasSubstr("in double precision already"));
}

TEST(Application, SplittersMoveAndTheLayoutCanBeReset) {
  const ApplicationStage stage;
  stage.open_small();
  const view::Rectangle before = stage.widget("map")->area;
  stage.play("drag splitter.map 40,0\nwait 2");
  EXPECT_NEAR(stage.widget("map")->area.max.x, before.max.x + 40, 3);
  stage.play("action view.reset_layout\nwait 2");
  EXPECT_EQ(stage.widget("map")->area.max.x, before.max.x);
}

TEST(Application, APanelCanFillTheWindowAndComesBack) {
  const ApplicationStage stage;
  stage.open_small();
  for (const char* panel : {"map", "pndf", "inspector"}) {
    stage.play("click " + std::string(panel) + ".maximise\nwait 2");
    EXPECT_GT(stage.widget(panel)->area.width(), 1200) << panel;
    stage.play("key Esc\nwait 2");
    EXPECT_LT(stage.widget(panel)->area.width(), 800) << panel;
  }
}

TEST(Application, TheInterfaceCanBeMadeLargerAndSmaller) {
  const ApplicationStage stage({1920, 1200});
  stage.open_small();
  const float before = stage.widget("map.help")->area.width();
  stage.play("action view.larger\nwait 3");
  EXPECT_GT(stage.widget("map.help")->area.width(), before);
  stage.play("action view.own_size\nwait 3");
  EXPECT_EQ(stage.widget("map.help")->area.width(), before);
}

}  // namespace
}  // namespace glint::test
