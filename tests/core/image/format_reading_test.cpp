// One small map through every format that can be written, and files of special make through the block reader.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <random>
#include <utility>

#include <gmock/gmock.h>

#include "core/image/image_file.h"
#include "tests/core/image/image_tests.h"
#include "tests/temporary_folder.h"

namespace glint::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::vector<std::string> k_rgb{"R", "G", "B"};

std::vector<std::uint8_t> some_codes(int texels) {
  std::mt19937 generator(5);
  std::vector<std::uint8_t> codes(static_cast<std::size_t>(3 * texels));
  std::ranges::generate(codes, [&] { return static_cast<std::uint8_t>(generator() % 256); });
  return codes;
}

TEST(ReadingFormats, TheSameCodesGiveTheSameMap) {
  const TemporaryFolder folder;
  const auto codes = some_codes(37 * 29);
  write_image(folder / "a.png", 37, 29, k_rgb, codes);
  const NormalMap map = read(folder / "a.png").map;
  const std::vector<std::pair<const char*, const char*>> others{
      {"a.tif", "TIFF"}, {"a.tga", "TGA"}, {"a.bmp", "BMP"}, {"a.ppm", "PNM"}};
  for (const auto& [name, title] : others) {
    ASSERT_NO_FATAL_FAILURE(write_image(folder / name, 37, 29, k_rgb, codes));
    const ReadNormalMap result = read(folder / name);
    EXPECT_EQ(largest_difference(result.map, map), 0) << name;
    EXPECT_THAT(result.report.format, StartsWith(std::string(title) + ", 8-bit, RGB, 37 x 29"));
  }
}

TEST(ReadingFormats, TiffCompressionsTilesAndSeparatePlanesGiveTheSameMap) {
  const TemporaryFolder folder;
  const auto codes = some_codes(70 * 50);
  write_image(folder / "a.png", 70, 50, k_rgb, codes);
  const NormalMap map = read(folder / "a.png").map;
  for (const char* compression : {"none", "lzw", "zip", "packbits"}) {
    for (const bool tiled : {false, true}) {
      for (const char* planes : {"contig", "separate"}) {
        OIIO::ImageSpec extra;
        extra.attribute("compression", compression);
        extra.attribute("planarconfig", planes);
        if (tiled) extra.tile_width = extra.tile_height = 32;
        ASSERT_NO_FATAL_FAILURE(write_image(folder / "a.tif", 70, 50, k_rgb, codes, extra));
        EXPECT_EQ(largest_difference(read(folder / "a.tif").map, map), 0) << compression << tiled << planes;
      }
    }
  }
}

TEST(ReadingFormats, FloatsSurviveEveryLosslessExrCompressionAndTiles) {
  const TemporaryFolder folder;
  std::vector<float> values;
  for (const std::uint8_t code : some_codes(300 * 40)) values.push_back(static_cast<float>(code) / 255.F);
  write_image(folder / "a.tif", 40, 300, k_rgb, values);
  const NormalMap map = read(folder / "a.tif").map;
  for (const char* compression : {"none", "rle", "zips", "zip", "piz"}) {
    for (const bool tiled : {false, true}) {
      OIIO::ImageSpec extra;
      extra.attribute("compression", compression);
      if (tiled) extra.tile_width = extra.tile_height = 32;
      ASSERT_NO_FATAL_FAILURE(write_image(folder / "a.exr", 40, 300, k_rgb, values, extra));
      EXPECT_EQ(largest_difference(read(folder / "a.exr").map, map), 0) << compression << tiled;
    }
  }
}

TEST(ReadingFormats, TheDataWindowAloneIsRead) {
  const TemporaryFolder folder;
  OIIO::ImageSpec extra;
  extra.x = -7;
  extra.y = 13;
  extra.full_x = extra.full_y = 0;
  std::vector<float> values;
  for (const std::uint8_t code : some_codes(20 * 10)) values.push_back(static_cast<float>(code) / 255.F);
  write_image(folder / "a.tif", 20, 10, k_rgb, values);
  write_image(folder / "a.exr", 20, 10, k_rgb, values, extra);
  EXPECT_EQ(largest_difference(read(folder / "a.exr").map, read(folder / "a.tif").map), 0);
}

// PFM stores rows from the bottom.
TEST(ReadingFormats, PfmIsReadTheRightWayUp) {
  const TemporaryFolder folder;
  const std::vector<float> rows_from_bottom{0.3F, 0.2F, 0.8F, -0.4F, 0.1F, 0.7F};
  std::string file = std::endian::native == std::endian::little ? "PF\n1 2\n-1.0\n" : "PF\n1 2\n1.0\n";
  const std::size_t header = file.size();
  file.resize(header + 24);
  std::memcpy(file.data() + header, rows_from_bottom.data(), 24);
  write_text(folder / "a.pfm", file);
  const NormalMap map = read(folder / "a.pfm").map;
  ASSERT_EQ(map.height(), 2);
  EXPECT_NEAR(map.texel(0, 0).x, -0.4 / std::sqrt(0.66), 1e-6);
  EXPECT_NEAR(map.texel(0, 1).x, 0.3 / std::sqrt(0.77), 1e-6);
}

TEST(ReadingFormats, RadianceFilesAreRead) {
  const TemporaryFolder folder;
  const std::vector<float> values{0.75F, 0.5F, 1.F, 0.25F, 0.5F, 0.75F};
  write_image(folder / "a.hdr", 2, 1, k_rgb, values);
  const ReadNormalMap result = read(folder / "a.hdr");
  EXPECT_NEAR(result.map.texel(0, 0).x, 0.5 / std::sqrt(1.25), 0.01);
  EXPECT_THAT(result.report.format, StartsWith("Radiance HDR"));
}

TEST(ReadingFormats, OnlyTheFirstOfSeveralImagesIsRead) {
  const TemporaryFolder folder;
  const auto output = OIIO::ImageOutput::create((folder / "a.exr").string());
  std::vector<OIIO::ImageSpec> specs(2, OIIO::ImageSpec(2, 1, 3, OIIO::TypeDesc::FLOAT));
  ASSERT_TRUE(output->open((folder / "a.exr").string(), 2, specs.data()));
  const std::vector<float> first{0.1F, -0.2F, 0.9F, 0.3F, 0.2F, 0.8F};
  const std::vector<float> second(6, 0.5F);
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, first.data()));
  ASSERT_TRUE(output->open((folder / "a.exr").string(), specs[1], OIIO::ImageOutput::AppendSubimage));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, second.data()));
  ASSERT_TRUE(output->close());
  const ReadNormalMap result = read(folder / "a.exr");
  EXPECT_NEAR(result.map.texel(0, 0).x, 0.1 / std::sqrt(0.86), 1e-6);
  EXPECT_THAT(text_of(result.report), HasSubstr("holds 2 images"));
}

TEST(ReadingRows, BlocksCoverEveryRowOnceInOrderWithTheChannelsAskedFor) {
  const TemporaryFolder folder;
  std::vector<float> values;
  for (int k = 0; k < 3 * 700 * 3; ++k) values.push_back(static_cast<float>(k));
  write_image(folder / "a.tif", 3, 700, k_rgb, values);
  const Result<ImageInfo> info = inspect_image(folder / "a.tif");
  ASSERT_TRUE(info);
  ASSERT_GT(row_block_count(*info), 1U);
  JobControl control;
  control.expect_steps(row_block_count(*info));
  std::vector<float> seen;
  int next_row = 0;
  const std::vector<int> channels{2, 0};
  const Result<std::string> remark = read_rows(*info, channels, control, [&](const RowBlock& block) {
    EXPECT_EQ(block.first_row, next_row);
    next_row += block.row_count;
    seen.insert(seen.end(), block.samples.begin(), block.samples.end());
  });
  ASSERT_TRUE(remark);
  EXPECT_EQ(*remark, "");
  EXPECT_EQ(control.progress(), 1);
  ASSERT_EQ(seen.size(), 3U * 700 * 2);
  for (std::size_t k = 0; k < seen.size() / 2; ++k) {
    ASSERT_EQ(seen[2 * k], values[3 * k + 2]);
    ASSERT_EQ(seen[2 * k + 1], values[3 * k]);
  }
}

}  // namespace
}  // namespace glint::test
