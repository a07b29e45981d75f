#include "viewers/pndf/pndf_pictures.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/viewers/stage.h"

namespace glint::view {
namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

// Density of a cell: its number, by rows from the top.
PndfImage numbered_image(int columns, int rows) {
  PndfImage image;
  image.grid = {-1, 1, -1, 1, columns, rows};
  for (std::size_t k = 0; k < image.grid.cells(); ++k) {
    image.density.push_back(static_cast<double>(k));
    image.standard_error.push_back(0.5 * static_cast<double>(k));
  }
  return image;
}

TEST(ReadCell, PicksTheCellUnderTheNormal) {
  const PndfImage image = numbered_image(4, 4);
  EXPECT_EQ(read_cell(image, {-0.9, 0.9})->density, 0) << "row 0 holds the largest t";
  EXPECT_EQ(read_cell(image, {0.9, 0.9})->density, 3);
  EXPECT_EQ(read_cell(image, {-0.9, -0.9})->density, 12);
  EXPECT_EQ(read_cell(image, {0.1, -0.1})->density, 10);
}

TEST(ReadCell, HasEveryCellCentre) {
  const PndfImage image = numbered_image(5, 3);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 5; ++column) {
      const auto reading = read_cell(image, image.grid.center(column, row));
      ASSERT_TRUE(reading);
      EXPECT_EQ(reading->density, static_cast<double>(image.grid.index(column, row)));
    }
  }
}

TEST(ReadCell, TakesTheFarEdgesIn) {
  const PndfImage image = numbered_image(4, 4);
  EXPECT_EQ(read_cell(image, {1, 1})->density, 3);
  EXPECT_EQ(read_cell(image, {1, -1})->density, 15);
}

TEST(ReadCell, IsNothingOutsideTheWindow) {
  const PndfImage image = numbered_image(4, 4);
  EXPECT_FALSE(read_cell(image, {1.01, 0}));
  EXPECT_FALSE(read_cell(image, {0, -1.01}));
  EXPECT_FALSE(read_cell(image, {k_nan, 0}));
}

TEST(ReadCell, ComesWithItsStandardErrorWhereThereIsOne) {
  PndfImage image = numbered_image(4, 4);
  EXPECT_EQ(read_cell(image, {0.9, 0.9})->standard_error, 1.5);
  image.standard_error.clear();
  EXPECT_FALSE(read_cell(image, {0.9, 0.9})->standard_error);
}

TEST(DifferenceOf, IsFirstMinusSecond) {
  PndfImage image = numbered_image(2, 2);
  const PndfImage reference = image;
  image.density = {1, 1, 0, 3};
  const auto difference = difference_of(image, reference);
  ASSERT_TRUE(difference);
  EXPECT_THAT(difference->values, testing::ElementsAre(1, 0, -2, 0));
  EXPECT_EQ(difference->largest, 2);
  EXPECT_EQ(difference_at(*difference, {-0.5, -0.5}), -2);
  EXPECT_FALSE(difference_at(*difference, {2, 0}));
}

TEST(DifferenceOf, NeedsEqualGrids) {
  EXPECT_FALSE(difference_of(numbered_image(4, 4), numbered_image(4, 2)));
  PndfImage moved = numbered_image(4, 4);
  moved.grid.s_max = 0.9;
  EXPECT_FALSE(difference_of(numbered_image(4, 4), moved));
}

TEST(LargestMagnitude, PassesOverWhatIsNoNumber) {
  const std::vector<double> values{1, -3, k_nan, std::numeric_limits<double>::infinity()};
  EXPECT_EQ(largest_magnitude(values), 3);
  EXPECT_EQ(largest_magnitude({}), 0);
  EXPECT_EQ(largest_magnitude(std::vector<double>{k_nan}), 0);
}

TEST(ReducedTexels, AreTheCellsWhereTheyFit) {
  const PndfImage image = numbered_image(3, 2);
  const Texels texels = reduced_texels(image.grid, image.density);
  EXPECT_EQ(texels.size, glm::ivec2(3, 2));
  EXPECT_THAT(texels.values, testing::ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(ReducedTexels, AreMeansOfBlocksBeyondThat) {
  const PndfImage image = numbered_image(4, 4);
  const Texels texels = reduced_texels(image.grid, image.density, 2);
  EXPECT_EQ(texels.size, glm::ivec2(2, 2));
  EXPECT_THAT(texels.values, testing::ElementsAre(2.5F, 4.5F, 10.5F, 12.5F));
}

TEST(ReducedTexels, MeanOverFewerCellsAtTheFarEdges) {
  const PndfImage image = numbered_image(3, 3);
  const Texels texels = reduced_texels(image.grid, image.density, 2);
  EXPECT_THAT(texels.values, testing::ElementsAre(2, 3.5F, 6.5F, 8));
}

TEST(ReducedTexels, ShowNaN) {
  PndfImage image = numbered_image(4, 4);
  image.density[5] = k_nan;
  const Texels texels = reduced_texels(image.grid, image.density, 2);
  EXPECT_TRUE(std::isnan(texels.values[0]));
  EXPECT_FALSE(std::isnan(texels.values[3]));
}

TEST(PndfPictures, MakeATextureOnceAndDropItWhenItIsNoLongerAskedFor) {
  const test::Stage stage({32, 32});
  const auto image = std::make_shared<const PndfImage>(numbered_image(4, 4));
  PndfPictures pictures;
  const GLuint first = pictures.shown(stage.gl(), image).texture.name();
  EXPECT_EQ(pictures.shown(stage.gl(), image).texture.name(), first);
  pictures.forget_unused();
  EXPECT_EQ(pictures.shown(stage.gl(), image).texture.name(), first);
  EXPECT_EQ(image.use_count(), 2);
  pictures.forget_unused();
  pictures.forget_unused();
  EXPECT_EQ(image.use_count(), 1);
}

TEST(PndfPictures, KnowTheMassAndTheLargestDensity) {
  const test::Stage stage({32, 32});
  PndfPictures pictures;
  const ShownImage& shown = pictures.shown(stage.gl(), std::make_shared<const PndfImage>(numbered_image(2, 2)));
  EXPECT_EQ(shown.largest, 3);
  EXPECT_EQ(shown.mass, 6);
}

TEST(PndfPictures, HaveNoDifferenceOfUnequalGrids) {
  const test::Stage stage({32, 32});
  PndfPictures pictures;
  const auto a = std::make_shared<const PndfImage>(numbered_image(4, 4));
  const auto b = std::make_shared<const PndfImage>(numbered_image(4, 2));
  EXPECT_EQ(pictures.shown_difference(stage.gl(), a, b), nullptr);
  EXPECT_NE(pictures.shown_difference(stage.gl(), a, a), nullptr);
}

}  // namespace
}  // namespace glint::view
