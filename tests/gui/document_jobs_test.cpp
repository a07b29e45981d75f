#include "gui/jobs/document_jobs.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/image/normal_map_writer.h"
#include "tests/gui/document_jobs_fixture.h"
#include "tests/temporary_folder.h"

namespace glint::gui {
namespace {

using test::DocumentJobsTest;
using test::k_endless_samples;
using test::small_document;
using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

std::vector<double> own_picture(const Document& document, PndfMethod method, const Surface& surface) {
  JobControl control;
  return make_document_model(document, method, surface)
      ->image(document.footprint, document_grid(document, surface), control)
      ->density;
}

TEST_F(DocumentJobsTest, BeginWithNothing) {
  EXPECT_TRUE(jobs_.idle());
  EXPECT_EQ(jobs_.results(), nullptr);
  EXPECT_EQ(jobs_.surface(), nullptr);
  EXPECT_FALSE(jobs_.status().busy);
  EXPECT_FALSE(jobs_.cancelled());
}

TEST_F(DocumentJobsTest, PicturesComeCoarseThenFullThenTheirErrors) {
  Document document = small_document();
  document.surface.interpolation.reset();
  document.footprint = isotropic_footprint({32, 32}, 0.6);
  document.grid.size = 96;
  document.binning_samples = 200'000;
  see_every_step();
  ASSERT_TRUE(show(document));
  ASSERT_GE(seen_.size(), 6U);
  const view::PndfResults& first = *seen_.front();
  EXPECT_EQ(first.revision, 1U);
  EXPECT_TRUE(first.methods[0].coarse);
  EXPECT_EQ(first.methods[0].coarse_note, "64² cells, 2 triangles");
  EXPECT_EQ(first.methods[0].surface, Interpolation::linear);
  EXPECT_EQ(first.methods[0].image->grid.columns, 64);
  EXPECT_EQ(first.methods[1].image, nullptr);
  EXPECT_LT(first.methods[1].progress, 1);

  const auto rank = [](const view::MethodPicture& p) { return !p.image ? 0 : p.coarse ? 1 : p.errors ? 3 : 2; };
  std::vector<std::array<int, 2>> ranks;
  for (const auto& results : seen_) ranks.push_back({rank(results->methods[0]), rank(results->methods[1])});
  ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
  const std::vector<std::array<int, 2>> expected{{1, 0}, {1, 1}, {2, 1}, {2, 2}, {3, 2}, {3, 3}};
  EXPECT_EQ(ranks, expected);
  const auto binned = std::find_if(seen_.begin(), seen_.end(), [](const auto& r) { return r->methods[1].image; });
  EXPECT_EQ((*binned)->methods[1].coarse_note, "64² cells, 100 k samples");

  const view::PndfResults& last = *jobs_.results();
  EXPECT_EQ(last.surface, jobs_.surface());
  EXPECT_EQ(last.document, document);
  ASSERT_NE(last.reference, nullptr);
  EXPECT_EQ(last.reference->grid, last.grid);
  EXPECT_LT(last.methods[0].errors->relative_l1, 0.02);
  EXPECT_GT(last.methods[1].errors->relative_l1, last.methods[0].errors->relative_l1);
  EXPECT_EQ(last.methods[0].progress, 1);
  EXPECT_GT(last.methods[0].milliseconds, 0);
  EXPECT_TRUE(errors_.empty());
}

TEST_F(DocumentJobsTest, FewCellsHaveNoCoarsePicture) {
  see_every_step();
  ASSERT_TRUE(show(small_document()));
  for (const auto& results : seen_) EXPECT_FALSE(results->methods[0].coarse);
  EXPECT_EQ(picture(0).image->density, own_picture(document_, PndfMethod::exact, surface()));
  EXPECT_EQ(picture(1).image->density, own_picture(document_, PndfMethod::binning, surface()));
}

TEST_F(DocumentJobsTest, LooksWideFootprintsUpWhileTheyMoveAndNotWhereTheRoughnessChanged) {
  Document document = small_document();
  document.methods = {PndfMethod::mixture};
  document.footprint = isotropic_footprint({32, 32}, 18);
  document.grid.window = glm::dvec4(-0.6, 0.6, -0.6, 0.6);
  document.grid.size = 16;
  ASSERT_TRUE(show(document));
  EXPECT_EQ(picture(0).image->answer.text, "") << "the direct method answers first";
  document.footprint.center.x += 3;
  ASSERT_TRUE(show(document));
  EXPECT_EQ(picture(0).image->answer.text, "atlas");
  EXPECT_LT(picture(0).errors->relative_l1, 0.01);
  document.intrinsic_roughness = 0.04;
  ASSERT_TRUE(show(document));
  EXPECT_EQ(picture(0).image->answer.text, "");
}

TEST_F(DocumentJobsTest, ANewerRevisionSupersedesALongOne) {
  document_.binning_samples = k_endless_samples;
  ++revision_;
  ASSERT_TRUE(frames_until([this] { return jobs_.results() != nullptr; }));
  Document document = small_document();
  document.intrinsic_roughness = 0.05;
  ASSERT_TRUE(show(document));
  EXPECT_EQ(jobs_.results()->revision, 2U);
  EXPECT_EQ(jobs_.results()->document, document);
  EXPECT_EQ(picture(0).image->density, own_picture(document, PndfMethod::exact, surface()));
  EXPECT_EQ(picture(1).image->density, own_picture(document, PndfMethod::binning, surface()));
  EXPECT_TRUE(picture(0).errors && picture(1).errors);
}

TEST_F(DocumentJobsTest, ManyQuickEditsEndWithTheResultsOfTheLast) {
  ASSERT_TRUE(show(small_document()));
  for (int edit = 0; edit < 100; ++edit) {
    document_.footprint.center.x = 10 + 0.25 * edit;
    ++revision_;
    frame();
    if (edit % 10 == 0) std::this_thread::sleep_for(3ms);
  }
  ASSERT_TRUE(settle());
  EXPECT_EQ(jobs_.results()->revision, revision_);
  EXPECT_EQ(jobs_.results()->document, document_);
  for (const std::size_t k : {0U, 1U}) {
    EXPECT_EQ(picture(k).revision, revision_);
    EXPECT_EQ(picture(k).image->density, own_picture(document_, document_.methods[k], surface()));
  }
  for (std::size_t k = 1; k < seen_.size(); ++k) EXPECT_LE(seen_[k - 1]->revision, seen_[k]->revision);
}

TEST_F(DocumentJobsTest, AnOlderPictureStaysUntilThereIsANewOneAndSaysSo) {
  ASSERT_TRUE(show(small_document()));
  const auto older = jobs_.results();
  document_.footprint.center.x += 1;
  see_every_step();
  ASSERT_TRUE(show(document_));
  const auto first =
      std::find_if(seen_.begin(), seen_.end(), [](const auto& results) { return results->revision == 2; });
  ASSERT_NE(first, seen_.end());
  EXPECT_EQ((*first)->methods[0].revision, 2U);
  EXPECT_NE((*first)->methods[0].image, older->methods[0].image);
  EXPECT_EQ((*first)->methods[1].revision, 1U);
  EXPECT_EQ((*first)->methods[1].image, older->methods[1].image);
  EXPECT_EQ((*first)->reference, nullptr);
}

TEST_F(DocumentJobsTest, OnlyWhatChangedIsComputed) {
  ASSERT_TRUE(show(small_document()));
  const auto before = jobs_.results();
  document_.binning_samples = 30'000;
  ASSERT_TRUE(show(document_));
  const auto more_samples = jobs_.results();
  EXPECT_EQ(more_samples->methods[0].image, before->methods[0].image);
  EXPECT_EQ(more_samples->methods[0].milliseconds, before->methods[0].milliseconds);
  EXPECT_EQ(more_samples->methods[0].revision, revision_);
  EXPECT_TRUE(more_samples->methods[0].errors);
  EXPECT_EQ(more_samples->reference, before->reference);
  EXPECT_NE(more_samples->methods[1].image, before->methods[1].image);
  EXPECT_TRUE(more_samples->methods[1].errors);

  document_.methods = {PndfMethod::binning, PndfMethod::exact};
  ASSERT_TRUE(show(document_));
  EXPECT_EQ(picture(0).image, more_samples->methods[1].image);
  EXPECT_EQ(picture(1).image, more_samples->methods[0].image);
  document_.methods = {PndfMethod::exact};
  ASSERT_TRUE(show(document_));
  EXPECT_EQ(picture(0).image, more_samples->methods[0].image);
  document_.methods = {PndfMethod::exact, PndfMethod::binning};
  ASSERT_TRUE(show(document_));
  EXPECT_EQ(picture(0).image, more_samples->methods[0].image);
  EXPECT_EQ(picture(1).revision, revision_);

  document_.intrinsic_roughness = 0.06;
  ASSERT_TRUE(show(document_));
  EXPECT_NE(picture(0).image, more_samples->methods[0].image);
  EXPECT_NE(jobs_.results()->reference, more_samples->reference);
}

TEST_F(DocumentJobsTest, NameAndViewComputeNothingAndResultsAreUpToDate) {
  ASSERT_TRUE(show(small_document()));
  const auto before = jobs_.results();
  document_.name = "another";
  document_.view.difference_range = 3;
  document_.surface.scratches.count += 1;  // of a generator that is not used
  ++revision_;
  frame();
  EXPECT_TRUE(jobs_.idle());
  EXPECT_EQ(jobs_.results()->revision, revision_);
  EXPECT_EQ(jobs_.results()->document, document_);
  for (const std::size_t k : {0U, 1U}) {
    EXPECT_EQ(picture(k).image, before->methods[k].image);
    EXPECT_EQ(picture(k).revision, revision_);
  }
}

TEST_F(DocumentJobsTest, ARunningJobGoesOnUnderANewName) {
  document_.binning_samples = k_endless_samples;
  ++revision_;
  ASSERT_TRUE(frames_until([this] { return jobs_.results() != nullptr; }));
  const auto before = jobs_.results();
  document_.name = "another";
  ++revision_;
  frame();
  EXPECT_FALSE(jobs_.idle());
  EXPECT_EQ(jobs_.results()->revision, revision_);
  EXPECT_EQ(picture(0).image, before->methods[0].image);
  EXPECT_EQ(picture(0).revision, revision_);
  EXPECT_EQ(picture(1).image, nullptr);
  EXPECT_LT(picture(1).progress, 1);
  ASSERT_TRUE(frames_until([this] { return jobs_.status().method == PndfMethod::binning; }));
  EXPECT_EQ(jobs_.status().text, "Binning");
}

TEST_F(DocumentJobsTest, AnotherInterpolationKeepsTheMap) {
  const glint::test::TemporaryFolder folder;
  ASSERT_TRUE(show(small_document()));
  const std::filesystem::path file = folder / "map.png";
  ASSERT_TRUE(write_normal_map(file, surface().map()));
  document_.surface.source = SurfaceSource::file;
  document_.surface.path = file;
  ASSERT_TRUE(show(document_));
  EXPECT_NE(jobs_.surface()->loaded.stored, nullptr);
  const auto before = jobs_.surface();
  std::filesystem::remove(file);
  document_.surface.interpolation = Interpolation::constant;
  ASSERT_TRUE(show(document_));
  EXPECT_EQ(jobs_.surface()->loaded.surface.shared_map(), before->loaded.surface.shared_map());
  EXPECT_EQ(jobs_.surface()->pyramid, before->pyramid);
  EXPECT_EQ(jobs_.surface()->description, document_.surface);
  EXPECT_EQ(surface().interpolation(), Interpolation::constant);
  EXPECT_EQ(picture(0).image->density, own_picture(document_, PndfMethod::exact, surface()));
  EXPECT_TRUE(picture(0).errors);
  EXPECT_TRUE(errors_.empty());

  jobs_.reload_surface();
  EXPECT_FALSE(jobs_.idle());
  ASSERT_TRUE(settle());
  EXPECT_EQ(errors_.size(), 1U);
  EXPECT_TRUE(jobs_.surface_error());
  EXPECT_EQ(jobs_.surface()->pyramid, before->pyramid);
}

TEST_F(DocumentJobsTest, AnotherWrapIsAnotherMap) {
  ASSERT_TRUE(show(small_document()));
  const auto before = jobs_.surface();
  document_.surface.reading.wrap = Wrap::clamp;
  ASSERT_TRUE(show(document_));
  EXPECT_EQ(surface().map().wrap(), Wrap::clamp);
  EXPECT_EQ(jobs_.surface()->pyramid->map(), surface().shared_map());
  EXPECT_EQ(jobs_.results()->surface, jobs_.surface());
}

TEST_F(DocumentJobsTest, ASurfaceThatFailsLeavesTheOldOneAndOneError) {
  ASSERT_TRUE(show(small_document()));
  const auto before = jobs_.surface();
  document_.surface.source = SurfaceSource::file;
  document_.surface.path = "/nowhere/missing.png";
  ASSERT_TRUE(show(document_));
  ASSERT_EQ(errors_.size(), 1U);
  EXPECT_EQ(errors_[0].subject, "/nowhere/missing.png");
  EXPECT_TRUE(jobs_.surface_error());
  EXPECT_EQ(jobs_.surface(), before);

  document_.footprint.center.x += 2;  // the rest of the document goes on, on the surface in use
  ASSERT_TRUE(show(document_));
  EXPECT_EQ(errors_.size(), 1U);
  EXPECT_EQ(jobs_.results()->revision, revision_);
  EXPECT_EQ(jobs_.results()->document.surface, before->description);
  EXPECT_EQ(picture(0).image->density, own_picture(document_, PndfMethod::exact, surface()));

  document_.surface = small_document().surface;
  ASSERT_TRUE(show(document_));
  EXPECT_FALSE(jobs_.surface_error());
  EXPECT_EQ(jobs_.surface()->pyramid, before->pyramid);
  EXPECT_EQ(errors_.size(), 1U);
}

TEST_F(DocumentJobsTest, AFirstSurfaceThatFailsLeavesNothing) {
  document_.surface.source = SurfaceSource::file;
  document_.surface.path = "/nowhere/missing.png";
  ASSERT_TRUE(settle());
  EXPECT_EQ(errors_.size(), 1U);
  EXPECT_EQ(jobs_.surface(), nullptr);
  EXPECT_EQ(jobs_.results(), nullptr);
}

TEST_F(DocumentJobsTest, AFootprintOutsideAMapThatClampsIsOneErrorADrag) {
  document_.surface.reading.wrap = Wrap::clamp;
  ASSERT_TRUE(show(document_));
  const auto before = jobs_.results();
  for (const double x : {70.0, 80.0, 90.0}) {
    document_.footprint.center.x = x;
    ASSERT_TRUE(show(document_));
  }
  ASSERT_EQ(errors_.size(), 1U);
  EXPECT_EQ(errors_[0].subject, "footprint.center");
  EXPECT_EQ(jobs_.results()->revision, before->revision);
}

TEST_F(DocumentJobsTest, CancelledIsNotBegunAgainBeforeTheDocumentChanges) {
  document_.binning_samples = k_endless_samples;
  ++revision_;
  ASSERT_TRUE(frames_until([this] { return jobs_.results() != nullptr; }));
  jobs_.cancel();
  EXPECT_TRUE(jobs_.cancelled());
  EXPECT_FALSE(jobs_.status().busy);
  ASSERT_TRUE(settle());
  document_.name = "another";
  ++revision_;
  frame();
  EXPECT_TRUE(jobs_.cancelled());
  EXPECT_TRUE(jobs_.idle());
  EXPECT_EQ(picture(1).image, nullptr);
  EXPECT_EQ(picture(1).progress, 1);

  const auto before = picture(0).image;
  jobs_.restart();
  EXPECT_FALSE(jobs_.cancelled());
  EXPECT_FALSE(jobs_.idle());
  ASSERT_TRUE(frames_until([this] { return jobs_.status().text == "Binning"; }));
  jobs_.cancel();
  ASSERT_TRUE(settle());
  EXPECT_EQ(picture(0).image, before);

  ASSERT_TRUE(show(small_document()));
  EXPECT_FALSE(jobs_.cancelled());
  EXPECT_TRUE(picture(1).errors);
}

TEST_F(DocumentJobsTest, ACancelledSurfaceIsLoadedByRestart) {
  document_.surface.noise.size = document_.surface.scratches.size = 256;
  ++revision_;
  frame();
  jobs_.cancel();
  ASSERT_TRUE(settle());
  EXPECT_TRUE(jobs_.cancelled());
  EXPECT_EQ(jobs_.surface(), nullptr);
  EXPECT_TRUE(errors_.empty());
  jobs_.restart();
  ASSERT_TRUE(settle());
  ASSERT_NE(jobs_.surface(), nullptr);
  EXPECT_TRUE(picture(0).errors);
}

TEST_F(DocumentJobsTest, CancellingNothingIsNothing) {
  ASSERT_TRUE(show(small_document()));
  jobs_.cancel();
  EXPECT_FALSE(jobs_.cancelled());
}

TEST(DocumentJobs, EndQuicklyWhileMuchIsToDo) {
  Document document = small_document();
  document.binning_samples = k_endless_samples;
  document.grid.size = 512;
  Clock::time_point end;
  {
    DocumentJobs jobs([] {});
    while (!jobs.results()) {
      jobs.update(document, 1);
      std::this_thread::sleep_for(1ms);
    }
    end = Clock::now();
  }
  EXPECT_LT(Clock::now() - end, 20s);  // the job itself would take minutes
}

}  // namespace
}  // namespace glint::gui
