#include "core/document/workspace.h"

#include <numeric>

#include <gtest/gtest.h>

#include "core/image/normal_map_writer.h"
#include "tests/temporary_folder.h"

namespace glint {
namespace {

using test::TemporaryFolder;

Document small_noise() {
  Document document;
  document.surface.source = SurfaceSource::noise;
  document.surface.noise.size = 64;
  document.footprint = isotropic_footprint({32, 32}, 2);
  document.binning_samples = 2'000'000;
  return document;
}

Surface surface_of(const Document& document) {
  JobControl control;
  Result<LoadedSurface> loaded = load_surface(document.surface, control);
  EXPECT_TRUE(loaded);
  EXPECT_EQ(loaded->stored, nullptr);
  return loaded->surface;
}

double density(const PndfModel& model, const Footprint& footprint, glm::dvec2 s) {
  PndfWorkspace workspace;
  return model.at(footprint, workspace).pdf(s);
}

TEST(DocumentModel, ShiftsTheVerticesWhereTheDocumentSaysSo) {
  Document document = small_noise();
  const Surface surface = surface_of(document);
  const auto value = [&] {
    return density(*make_document_model(document, PndfMethod::exact, surface), document.footprint, {0.02, 0.03});
  };
  const double plain = value();
  document.exact_vertex_shift = true;
  EXPECT_NE(value(), plain);
  EXPECT_NEAR(value() / plain, 1, 0.05);
}

TEST(CoarseModel, IsNearTheDocumentsOwn) {
  const Document document = small_noise();
  const Surface surface = surface_of(document);
  const PndfGrid grid = coarse_grid(document_grid(document, surface), 32);
  ASSERT_EQ(grid.columns, 32);
  for (const PndfMethod method : {PndfMethod::exact, PndfMethod::binning}) {
    JobControl control;
    const auto fine = make_document_model(document, method, surface)->image(document.footprint, grid, control);
    const auto coarse = make_coarse_model(document, method, surface)->image(document.footprint, grid, control);
    ASSERT_TRUE(fine && coarse);
    double difference = 0;
    for (std::size_t k = 0; k < grid.cells(); ++k) difference += std::abs(fine->density[k] - coarse->density[k]);
    EXPECT_GT(difference, 0);
    EXPECT_LT(difference * grid.cell_area(), 0.3);
    EXPECT_NEAR(integral(*coarse), integral(*fine), 0.01);
  }
}

TEST(CoarseGrid, IsTheSameWindowInFewerCells) {
  EXPECT_EQ(coarse_grid({-1, 0.5, -0.25, 1, 256, 256}), (PndfGrid{-1, 0.5, -0.25, 1, 64, 64}));
  EXPECT_EQ(coarse_grid({-1, 0.5, -0.25, 1, 20, 256}, 32), (PndfGrid{-1, 0.5, -0.25, 1, 20, 32}));
}

TEST(LoadedSurface, KeepsWhatTheFileHoldsWhenAsked) {
  const TemporaryFolder folder;
  const NormalMap map(2, 1, {{0.5F, -0.25F}, {0, 0}}, Wrap::repeat);
  ASSERT_TRUE(write_normal_map(folder / "map.exr", map));
  SurfaceDescription description;
  description.source = SurfaceSource::file;
  description.path = folder / "map.exr";
  JobControl control;
  const Result<LoadedSurface> without = load_surface(description, control);
  ASSERT_TRUE(without);
  EXPECT_EQ(without->stored, nullptr);
  const Result<LoadedSurface> with = load_surface(description, control, KeepStored::yes);
  ASSERT_TRUE(with);
  ASSERT_NE(with->stored, nullptr);
  EXPECT_EQ(with->stored->text(0, 0), "0.5 -0.25 0.8292");
  description.source = SurfaceSource::noise;
  EXPECT_EQ(load_surface(description, control, KeepStored::yes)->stored, nullptr);
}

}  // namespace
}  // namespace glint
