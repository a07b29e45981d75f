#include "gui/jobs/open_jobs.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/document/preset.h"
#include "core/image/normal_map_writer.h"
#include "core/image/pndf_exr.h"
#include "tests/gui/document_jobs_fixture.h"
#include "tests/temporary_folder.h"

namespace glint::gui {
namespace {

class OpenJobsTest : public test::DocumentJobsTest {
 protected:
  OpenJobsTest() {
    document_.methods = {PndfMethod::exact};
    document_.footprint = isotropic_footprint({32, 32}, 1);
    document_.intrinsic_roughness = 0.1;
  }

  std::optional<Opened> open(const std::filesystem::path& file) {
    jobs_.open(file);
    std::optional<Opened> opened;
    EXPECT_TRUE(frames_until([&] {
      opened = jobs_.take_opened();
      return opened || jobs_.idle();
    }));
    return opened;
  }

  void write_map(const std::filesystem::path& file, int width, int height) {
    std::vector<glm::vec2> normals(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), {0.1F, 0});
    normals[3] = {0, 0.2F};
    ASSERT_TRUE(write_normal_map(file, NormalMap(width, height, std::move(normals), Wrap::repeat)));
  }

  void write_exr(const std::filesystem::path& file, const std::string& recipe) {
    PndfImage image;
    image.grid.columns = image.grid.rows = 2;
    image.density.assign(4, 0.25);
    const NamedPndfImage named{"exact", &image};
    ASSERT_TRUE(write_pndf_exr(file, {&named, 1}, recipe));
  }

  void expect_one_error_and_no_change(const std::filesystem::path& file) {
    const auto surface = jobs_.surface();
    const auto results = jobs_.results();
    errors_.clear();
    EXPECT_FALSE(open(file)) << file;
    frame();
    ASSERT_EQ(errors_.size(), 1U) << file;
    EXPECT_NE(errors_[0].message().find(file.filename().string()), std::string::npos) << errors_[0].message();
    EXPECT_EQ(jobs_.surface(), surface);
    EXPECT_EQ(jobs_.results(), results);
    EXPECT_FALSE(jobs_.surface_error());
  }

  glint::test::TemporaryFolder folder_;
};

TEST_F(OpenJobsTest, AMapBecomesTheSurfaceOfTheCurrentDocument) {
  document_.surface.reading.wrap = Wrap::clamp;
  ASSERT_TRUE(show(document_));
  write_map(folder_ / "wood.png", 20, 10);
  const std::optional<Opened> opened = open(folder_ / "wood.png");
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->label, "Open wood.png");
  Document expected = document_;
  expected.name = "wood";
  expected.surface.source = SurfaceSource::file;
  expected.surface.path = folder_ / "wood.png";
  expected.surface.reading = {};
  expected.surface.interpolation.reset();
  expected.footprint.center = {10, 5};
  EXPECT_EQ(opened->document, expected);
  EXPECT_FALSE(jobs_.take_opened());

  std::filesystem::remove(folder_ / "wood.png");  // it is not read again
  document_ = opened->document;
  ++revision_;
  frame();
  EXPECT_EQ(jobs_.surface()->description, expected.surface);
  EXPECT_NE(jobs_.surface()->loaded.stored, nullptr);
  ASSERT_TRUE(frames_until([&] { return jobs_.results() != nullptr && jobs_.results()->document == expected; }));
  EXPECT_EQ(jobs_.results()->surface, jobs_.surface());
  EXPECT_TRUE(errors_.empty());
}

TEST_F(OpenJobsTest, AFootprintInsideTheMapStays) {
  ASSERT_TRUE(settle());
  write_map(folder_ / "wood.png", 48, 48);
  const std::optional<Opened> opened = open(folder_ / "wood.png");
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->document.footprint, document_.footprint);
}

TEST_F(OpenJobsTest, TheSameFileAgainIsTheFileAsItIsNow) {
  write_map(folder_ / "wood.png", 20, 10);
  std::optional<Opened> opened = open(folder_ / "wood.png");
  ASSERT_TRUE(opened);
  document_ = opened->document;
  ++revision_;
  frame();
  EXPECT_EQ(surface().map().width(), 20);
  write_map(folder_ / "wood.png", 40, 20);
  opened = open(folder_ / "wood.png");
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->document, document_);
  frame();
  EXPECT_EQ(surface().map().width(), 40);
  ASSERT_TRUE(
      frames_until([this] { return jobs_.results() != nullptr && jobs_.results()->surface == jobs_.surface(); }));
}

TEST_F(OpenJobsTest, APresetIsItsDocument) {
  ASSERT_TRUE(settle());
  Document preset = test::small_document();
  preset.name = "from a preset";
  preset.surface.noise.seed = preset.surface.scratches.seed = preset.surface.flakes.seed = 11;
  ASSERT_TRUE(save_preset(folder_ / "worn.json", preset));
  const std::optional<Opened> opened = open(folder_ / "worn.json");
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->document, preset);
  EXPECT_EQ(opened->label, "Open worn.json");
  ASSERT_TRUE(show(opened->document));
  EXPECT_EQ(jobs_.results()->document, preset);
}

TEST_F(OpenJobsTest, AnExrWithARecipeIsItsDocumentAndFindsTheMapBesideIt) {
  ASSERT_TRUE(settle());
  write_map(folder_ / "wood.png", 20, 10);
  Document made = test::small_document();
  made.surface.source = SurfaceSource::file;
  made.surface.path = "wood.png";
  write_exr(folder_ / "pndf.exr", recipe_of(made));
  const std::optional<Opened> opened = open(folder_ / "pndf.exr");
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->document.surface.path, folder_ / "wood.png");
  EXPECT_EQ(opened->document.footprint, made.footprint);
  EXPECT_EQ(opened->document.methods, made.methods);
}

TEST_F(OpenJobsTest, AnExrWithoutARecipeIsAMap) {
  write_map(folder_ / "wood.exr", 20, 10);
  const std::optional<Opened> opened = open(folder_ / "wood.exr");
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->document.surface.path, folder_ / "wood.exr");
  EXPECT_EQ(opened->document.name, "wood");
}

TEST_F(OpenJobsTest, WhatCannotBeOpenedIsOneErrorAndChangesNothing) {
  ASSERT_TRUE(settle());
  glint::test::write_text(folder_ / "broken.png", "this is no picture");
  glint::test::write_text(folder_ / "broken.json", "{\"glintscope\": 3");
  write_exr(folder_ / "recipe.exr", "{\"glintscope\": \"preset\", \"version\": 1, \"unknown\": 2}");
  Document lost = test::small_document();
  lost.surface.source = SurfaceSource::file;
  lost.surface.path = folder_ / "missing.png";
  ASSERT_TRUE(save_preset(folder_ / "missing.png.json", lost));
  expect_one_error_and_no_change(folder_ / "broken.png");
  expect_one_error_and_no_change(folder_ / "broken.json");
  expect_one_error_and_no_change(folder_ / "recipe.exr");
  expect_one_error_and_no_change(folder_ / "nowhere.png");
  errors_.clear();
  EXPECT_FALSE(open(folder_ / "missing.png.json"));
  frame();
  EXPECT_EQ(errors_.size(), 1U);
}

TEST_F(OpenJobsTest, TheNewestOfSeveralIsOpened) {
  write_map(folder_ / "first.png", 20, 10);
  write_map(folder_ / "second.png", 20, 10);
  jobs_.open(folder_ / "first.png");
  const std::optional<Opened> opened = open(folder_ / "second.png");
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->document.name, "second");
  ASSERT_TRUE(settle());
  EXPECT_FALSE(jobs_.take_opened());
}

}  // namespace
}  // namespace glint::gui
