#include "core/study/study.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "core/study/error_metrics.h"
#include "core/study/reference.h"

namespace glint {
namespace {

Document small_document() {
  Document document;
  document.surface.source = SurfaceSource::noise;
  document.surface.noise.size = 64;
  document.surface.scratches.size = 64;
  document.surface.noise.wavelengths = {8, 32};
  document.footprint = isotropic_footprint({32.5, 32.5}, 2);
  document.intrinsic_roughness = 0.02;
  document.grid.size = 48;
  document.binning_samples = 20'000;
  document.methods = {PndfMethod::exact, PndfMethod::binning};
  return document;
}

Surface surface_of(const Document& document, Interpolation interpolation) {
  JobControl control;
  Result<LoadedSurface> loaded = load_surface(document.surface, control);
  EXPECT_TRUE(loaded);
  return {loaded->surface.shared_map(), interpolation};
}

TEST(Reference, OfTheSmoothSurfaceKnowsItsOwnError) {
  const Document document = small_document();
  const Surface surface = surface_of(document, Interpolation::smooth);
  const PndfGrid grid = document_grid(document, surface);
  JobControl control;
  const auto reference = reference_image(surface, 0.02, document.footprint, grid, CellContent::point, control);
  ASSERT_TRUE(reference);
  EXPECT_GT(reference->own_error, 0);
  EXPECT_LT(reference->own_error, 2e-4);
  // The 32-triangle map is near the smooth surface, but not as near as the reference says it is itself.
  const auto exact = ExactPndf(surface, 0.02).image(document.footprint, grid, control);
  const double difference = compare(*exact, reference->image).relative_l1;
  EXPECT_GT(difference, reference->own_error);
  EXPECT_LT(difference, 0.02);
}

TEST(Reference, OfTheLinearSurfaceIsTheExactMethodItself) {
  const Document document = small_document();
  const Surface surface = surface_of(document, Interpolation::linear);
  const PndfGrid grid = document_grid(document, surface);
  JobControl control;
  const auto reference = reference_image(surface, 0.02, document.footprint, grid, CellContent::point, control);
  const auto exact = ExactPndf(surface, 0.02).image(document.footprint, grid, control);
  EXPECT_LT(compare(*exact, reference->image).relative_l1, 3e-7);  // the image's narrower cut
}

// A lobe of one Gaussian over cells of its own width: the mean is the product of differences of erf.
TEST(Reference, OfMeansIsTheIntegralOverEachCell) {
  const Surface surface(std::make_shared<const NormalMap>(2, 2, std::vector<glm::vec2>(4, {0, 0}), Wrap::repeat),
                        Interpolation::linear);
  const PndfGrid grid{-0.2, 0.2, -0.2, 0.2, 16, 16};
  const double sigma = grid.pitch().x;
  JobControl control;
  const auto reference =
      reference_image(surface, sigma, isotropic_footprint({1, 1}, 1), grid, CellContent::mean, control);
  ASSERT_TRUE(reference);
  const auto mass = [&](double x) { return 0.5 * std::erf(x / (sigma * std::sqrt(2.0))); };
  for (const int column : {5, 7, 8}) {
    const double s = grid.center(column, 6).x;
    const double t = grid.center(column, 6).y;
    const double half = 0.5 * sigma;
    const double expected = (mass(s + half) - mass(s - half)) * (mass(t + half) - mass(t - half)) / grid.cell_area();
    EXPECT_NEAR(reference->image.density[grid.index(column, 6)] / expected, 1, 2e-3) << column;
  }
}

TEST(Study, ReportsEveryMethodAgainstItsOwnSurface) {
  const Document document = small_document();
  const Surface surface = surface_of(document, Interpolation::smooth);
  StudySettings settings;
  settings.repeats = 2;
  settings.query_seconds = 0.2;
  JobControl control;
  const Result<std::vector<StudyResult>> results = run_study(document, surface, settings, control);
  ASSERT_TRUE(results);
  ASSERT_EQ(results->size(), 2U);
  const StudyResult& exact = (*results)[0];
  const StudyResult& binning = (*results)[1];
  EXPECT_EQ(exact.method, PndfMethod::exact);
  EXPECT_EQ(exact.reference.surface, Interpolation::smooth);
  EXPECT_LT(exact.relative_l1, 0.02);
  EXPECT_EQ(exact.own_noise, 0);
  EXPECT_GT(exact.image_ms, 0);
  EXPECT_GT(exact.query_us, 0);
  EXPECT_GT(exact.query_count, 0U);
  EXPECT_GE(exact.bytes, 64U * 64U * 8U);
  // What binning is off by is its own noise: the estimate and the measurement agree.
  EXPECT_NEAR(binning.relative_l1 / binning.own_noise, 1, 0.15);
}

TEST(Study, HoldsTheMixtureOfALinearSurfaceAgainstTheSmoothOne) {
  Document document = small_document();
  document.methods = {PndfMethod::exact, PndfMethod::mixture};
  document.surface.interpolation = Interpolation::linear;
  JobControl control;
  const auto results = run_study(document, surface_of(document, Interpolation::linear), {}, control);
  ASSERT_TRUE(results);
  EXPECT_EQ((*results)[0].surface, Interpolation::linear);
  EXPECT_EQ((*results)[0].reference.surface, Interpolation::linear);
  EXPECT_EQ((*results)[1].surface, Interpolation::smooth);
  EXPECT_EQ((*results)[1].reference.surface, Interpolation::smooth);
  EXPECT_LT((*results)[1].relative_l1, 0.02);
}

TEST(Study, ForcedReferenceSurfaceIsNamed) {
  Document document = small_document();
  document.methods = {PndfMethod::exact};
  StudySettings settings;
  settings.repeats = 1;
  settings.query_seconds = 0.05;
  settings.reference_surface = Interpolation::linear;
  JobControl control;
  const auto results = run_study(document, surface_of(document, Interpolation::smooth), settings, control);
  ASSERT_TRUE(results);
  EXPECT_EQ(results->front().reference.surface, Interpolation::linear);
  EXPECT_GT(results->front().relative_l1, 0.01);  // two triangles are not the smooth surface
}

TEST(Study, CancelledSaysSo) {
  const Document document = small_document();
  JobControl control;
  control.cancel();
  const auto results = run_study(document, surface_of(document, Interpolation::smooth), {}, control);
  ASSERT_FALSE(results);
  EXPECT_EQ(results.error().sentence, "cancelled");
}

TEST(Study, NamesTheMachine) {
  EXPECT_FALSE(machine_name().empty());
}

}  // namespace
}  // namespace glint
