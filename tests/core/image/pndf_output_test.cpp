// P-NDF images out: the EXR's channels, rows and metadata; the picture's colours; normal maps there and back.

#include <cmath>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "core/image/color_map.h"
#include "core/image/normal_map_reader.h"
#include "core/image/normal_map_writer.h"
#include "core/image/pndf_exr.h"
#include "core/image/pndf_picture.h"
#include "tests/temporary_folder.h"

namespace glint {
namespace {

PndfImage gradient_image() {
  PndfImage image;
  image.grid = {-0.5, 0.5, -0.25, 0.75, 3, 2};
  image.density = {1, 2, 3, 4, 5, 6.125};
  image.widening = {0.001, 0.002};
  return image;
}

TEST(PndfExr, HoldsChannelsRowsAndMetadata) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "out.exr";
  const PndfImage exact = gradient_image();
  PndfImage binned = gradient_image();
  binned.density[0] = 10;
  binned.standard_error.assign(6, 0.25);
  const std::vector<NamedPndfImage> images = {{"exact", &exact}, {"binning", &binned}};
  ASSERT_TRUE(write_pndf_exr(path, images, "{\"a\":1}"));

  const auto input = OIIO::ImageInput::open(path.string());
  ASSERT_TRUE(input);
  const OIIO::ImageSpec spec = input->spec();
  EXPECT_EQ(spec.width, 3);
  EXPECT_EQ(spec.height, 2);
  EXPECT_EQ(spec.nchannels, 3);
  EXPECT_EQ(spec.format, OIIO::TypeDesc::FLOAT);
  EXPECT_EQ(spec.get_string_attribute("glintscope:window"), "-0.5 0.5 -0.25 0.75");
  EXPECT_EQ(spec.get_string_attribute("glintscope:widening"), "0.001 0.002");
  std::vector<float> pixels(18);
  ASSERT_TRUE(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data()));
  const auto value = [&](const char* channel, std::size_t cell) {
    return pixels[cell * 3 + static_cast<std::size_t>(spec.channelindex(channel))];
  };
  EXPECT_EQ(value("D.exact", 0), 1.0F);  // row 0 first
  EXPECT_EQ(value("D.exact", 5), 6.125F);
  EXPECT_EQ(value("D.binning", 0), 10.0F);
  EXPECT_EQ(value("D.binning.error", 3), 0.25F);
  const Result<std::string> recipe = read_recipe(path);
  ASSERT_TRUE(recipe);
  EXPECT_EQ(*recipe, "{\"a\":1}");
}

TEST(PndfExr, EqualInputsGiveEqualBytes) {
  const test::TemporaryFolder folder;
  const PndfImage image = gradient_image();
  const std::vector<NamedPndfImage> images = {{"exact", &image}};
  ASSERT_TRUE(write_pndf_exr(folder.path() / "a.exr", images, "r"));
  ASSERT_TRUE(write_pndf_exr(folder.path() / "b.exr", images, "r"));
  EXPECT_EQ(test::text_of(folder.path() / "a.exr"), test::text_of(folder.path() / "b.exr"));
}

TEST(PndfExr, WithoutRecipeIsAnError) {
  const test::TemporaryFolder folder;
  const NormalMap map(2, 2, std::vector<glm::vec2>(4, {0.1F, 0.2F}), Wrap::repeat);
  ASSERT_TRUE(write_normal_map(folder.path() / "map.exr", map));
  EXPECT_FALSE(read_recipe(folder.path() / "map.exr"));
  EXPECT_FALSE(read_recipe(folder.path() / "missing.exr"));
}

TEST(NormalMapWriter, GivesTheSameNormalsBack) {
  const test::TemporaryFolder folder;
  std::vector<glm::vec2> normals;
  for (int k = 0; k < 35; ++k)
    normals.emplace_back(0.02F * static_cast<float>(k) - 0.4F, 0.6F - 0.03F * static_cast<float>(k));
  const NormalMap map(7, 5, normals, Wrap::repeat);
  JobControl control;
  for (const auto& [name, tolerance] : {std::pair{"map.exr", 1e-7}, std::pair{"map.png", 2.0 / 65535}}) {
    ASSERT_TRUE(write_normal_map(folder.path() / name, map)) << name;
    const Result<ReadNormalMap> read = read_normal_map(folder.path() / name, {}, control);
    ASSERT_TRUE(read) << name;
    ASSERT_EQ(read->map.width(), 7);
    for (std::size_t k = 0; k < normals.size(); ++k) {
      EXPECT_NEAR(read->map.normals()[k].x, normals[k].x, tolerance) << name << " " << k;
      EXPECT_NEAR(read->map.normals()[k].y, normals[k].y, tolerance) << name << " " << k;
    }
  }
  EXPECT_EQ(write_normal_map(folder.path() / "map.gif", map).error().kind, ErrorKind::request);
}

TEST(ColorMap, HasItsPinnedEndsAndMiddle) {
  EXPECT_EQ(viridis(0), DisplayColor(0x44, 0x01, 0x54));
  EXPECT_EQ(viridis(1), DisplayColor(0xfd, 0xe7, 0x25));
  EXPECT_EQ(viridis(7.0 / 15), DisplayColor(0x23, 0x88, 0x8e));
}

TEST(ColorMap, NeverHidesClipping) {
  EXPECT_EQ(viridis(-1e-9), k_underflow_color);
  EXPECT_EQ(viridis(1 + 1e-9), k_overflow_color);
  EXPECT_EQ(viridis(std::nan("")), k_underflow_color);
  const LogScale scale{1e-2, 100};
  EXPECT_EQ(scale.color(0), k_underflow_color);
  EXPECT_EQ(scale.color(101), k_overflow_color);
  EXPECT_DOUBLE_EQ(scale.position(1), 0.5);
}

TEST(ColorMap, DifferencesHaveTheStopsOfTheDesign) {
  EXPECT_EQ(difference_color(-1), DisplayColor(0x9c, 0xd3, 0xff));
  EXPECT_EQ(difference_color(-0.6), DisplayColor(0x3f, 0x8f, 0xcf));
  EXPECT_EQ(difference_color(-0.25), DisplayColor(0x1d, 0x45, 0x66));
  EXPECT_EQ(difference_color(0), DisplayColor(0x0b, 0x0b, 0x0b));
  EXPECT_EQ(difference_color(0.25), DisplayColor(0x66, 0x2c, 0x16));
  EXPECT_EQ(difference_color(0.6), DisplayColor(0xcc, 0x5a, 0x2c));
  EXPECT_EQ(difference_color(1), DisplayColor(0xff, 0xbb, 0x9c));
  EXPECT_EQ(difference_color(0.8), DisplayColor(230, 139, 100));  // half way between the last two
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(difference_color(-inf), difference_color(-1));
  EXPECT_EQ(difference_color(inf), difference_color(1));
  EXPECT_EQ(difference_color(std::nan("")), DisplayColor(0xff, 0, 0));
}

TEST(ColorMap, TablesRunFromEndToEnd) {
  EXPECT_EQ(viridis_table().front(), viridis(0));
  EXPECT_EQ(viridis_table()[51], viridis(0.2));
  EXPECT_EQ(viridis_table().back(), viridis(1));
  EXPECT_EQ(difference_table().front(), difference_color(-1));
  EXPECT_EQ(difference_table()[51], difference_color(-0.6));
  EXPECT_EQ(difference_table().back(), difference_color(1));
}

TEST(ColorMap, FittedScaleIsFourDecadesUnderARoundNumber) {
  EXPECT_DOUBLE_EQ(fitted_scale(37).hi, 50);
  EXPECT_DOUBLE_EQ(fitted_scale(37).lo, 50e-4);
  EXPECT_DOUBLE_EQ(fitted_scale(0.1).hi, 0.1);
  EXPECT_DOUBLE_EQ(fitted_scale(0).hi, 1);
}

TEST(PndfPicture, ShowsEveryCellOfEveryImage) {
  PndfImage image;
  image.grid = {-0.2, 0.2, -0.2, 0.2, 64, 64};
  image.density.assign(64 * 64, 0.0);
  image.density[image.grid.index(63, 0)] = 100;  // largest s and t: the upper right corner
  const std::vector<PictureEntry> entries = {{"a", "", "", &image}, {"b", "", "", &image}};
  const test::TemporaryFolder folder;
  ASSERT_TRUE(draw_pndf_picture(entries, "footer").write_png(folder.path() / "p.png"));
  const auto input = OIIO::ImageInput::open((folder.path() / "p.png").string());
  ASSERT_TRUE(input);
  const OIIO::ImageSpec spec = input->spec();
  std::vector<unsigned char> pixels(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) * 3);
  ASSERT_TRUE(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, pixels.data()));
  // The bright corner is 8 x 8 pixels in each picture; the colour bar's top row has that colour too.
  int bright = 0;
  for (std::size_t k = 0; k < pixels.size(); k += 3) bright += pixels[k] == 0xfd && pixels[k + 1] == 0xe7 ? 1 : 0;
  EXPECT_GE(bright, 2 * 64);
  EXPECT_LE(bright, 2 * 64 + 14 * 4);
}

}  // namespace
}  // namespace glint
