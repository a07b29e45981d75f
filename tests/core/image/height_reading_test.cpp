// Height fields: values times a scale in texels, turned into normals by central differences.

#include <algorithm>
#include <cmath>
#include <utility>

#include <gmock/gmock.h>

#include "tests/core/image/image_tests.h"
#include "tests/temporary_folder.h"
#include "tests/test_data.h"

namespace glint::test {
namespace {

using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;
using Floats = std::vector<float>;

// Heights that rise by 0.25 a texel to the right and by 0.5 a texel downwards.
Floats plane(int side) {
  Floats heights;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) heights.push_back(0.25F * static_cast<float>(i) + 0.5F * static_cast<float>(j));
  }
  return heights;
}

ReadOptions clamped_height(double scale) {
  ReadOptions options = as_height(scale);
  options.wrap = Wrap::clamp;
  return options;
}

TEST(ReadingHeights, APlaneHasOneNormalEverywhere) {
  const TemporaryFolder folder;
  write_image(folder / "a.exr", 5, 5, {"Y"}, plane(5));
  const ReadNormalMap result = read(folder / "a.exr", clamped_height(2));
  const double w = std::sqrt(1 + 0.5 * 0.5 + 1.0 * 1.0);
  for (const glm::vec2 normal : result.map.normals()) {
    EXPECT_NEAR(normal.x, -0.5 / w, 1e-7);
    EXPECT_NEAR(normal.y, 1.0 / w, 1e-7);
  }
  EXPECT_EQ(warning_count(result.report), 0) << text_of(result.report);
  EXPECT_EQ(result.report.quantisation_step, 0);
}

TEST(ReadingHeights, IntegersCountAsZeroToOne) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", 3, 1, {"Y"}, Bytes{0, 51, 102});
  const ReadNormalMap result = read(folder / "a.png", clamped_height(10));
  EXPECT_NEAR(result.map.texel(1, 0).x, -2 / std::sqrt(5.0), 1e-6);  // 0.2 * 10 texels a texel
  EXPECT_NEAR(result.report.quantisation_step, 0.5 * 10 * 0.2, 1e-6);
}

TEST(ReadingHeights, EqualChannelsAndALuminanceWithAlphaAreHeights) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", 3, 1, {"R", "G", "B"}, Bytes{0, 0, 0, 51, 51, 51, 102, 102, 102});
  write_image(folder / "b.png", 3, 1, {"Y", "A"}, Bytes{0, 255, 51, 9, 102, 255});
  EXPECT_NEAR(read(folder / "a.png", clamped_height(10)).map.texel(1, 0).x, -2 / std::sqrt(5.0), 1e-6);
  const ReadNormalMap with_alpha = read(folder / "b.png", clamped_height(10));
  EXPECT_NEAR(with_alpha.map.texel(1, 0).x, -2 / std::sqrt(5.0), 1e-6);
  EXPECT_THAT(text_of(with_alpha.report), HasSubstr("alpha"));
}

TEST(ReadingHeights, ChannelsThatDifferAreRefused) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", 2, 1, {"R", "G", "B"}, Bytes{0, 0, 1, 51, 51, 51});
  const Error error = refusal(folder / "a.png", as_height(1));
  EXPECT_EQ(error.kind, ErrorKind::content);
  EXPECT_THAT(error.sentence, HasSubstr("channels differ"));
}

TEST(ReadingHeights, ScalesThatCannotBeAreTheFaultOfTheRequest) {
  const TemporaryFolder folder;
  write_image(folder / "a.exr", 5, 5, {"Y"}, plane(5));
  for (const double scale : {0.0, std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    const Error error = refusal(folder / "a.exr", as_height(scale));
    EXPECT_EQ(error.kind, ErrorKind::request) << scale;
    EXPECT_EQ(error.subject, "--height");
  }
  ReadOptions flipped = as_height(1);
  flipped.green = GreenDirection::down;
  EXPECT_EQ(refusal(folder / "a.exr", flipped).kind, ErrorKind::request);
}

TEST(ReadingHeights, HeightsThatAreNotFiniteMakeFlatTexels) {
  const TemporaryFolder folder;
  Floats heights = plane(5);
  heights[12] = std::nanf("");
  write_image(folder / "a.exr", 5, 5, {"Y"}, heights);
  const ReadNormalMap result = read(folder / "a.exr", clamped_height(1));
  for (const auto& [i, j] : {std::pair{1, 2}, {3, 2}, {2, 1}, {2, 3}}) {
    EXPECT_EQ(result.map.texel(i, j), glm::vec2(0, 0)) << i << " " << j;
  }
  EXPECT_NE(result.map.texel(0, 0), glm::vec2(0, 0));
  EXPECT_TRUE(warns_of(result.report, "1 texel held no finite height"));
  EXPECT_TRUE(warns_of(result.report, "4 texels without a finite slope"));
  EXPECT_TRUE(warns_of(result.report, "the first at column 2, row 1"));
}

TEST(ReadingHeights, AConstantHeightIsFlatAndSaidToBe) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", 3, 1, {"Y"}, Bytes{9, 9, 9});
  const ReadNormalMap result = read(folder / "a.png", as_height(10));
  for (const glm::vec2 normal : result.map.normals()) EXPECT_EQ(normal, glm::vec2(0, 0));
  EXPECT_TRUE(warns_of(result.report, "constant"));
}

TEST(ReadingHeights, EdgesThatDoNotMeetAreSaidWhereTheMapRepeats) {
  const TemporaryFolder folder;
  write_image(folder / "a.exr", 16, 16, {"Y"}, plane(16));
  EXPECT_TRUE(warns_of(read(folder / "a.exr", as_height(1)).report, "do not meet"));
  EXPECT_FALSE(warns_of(read(folder / "a.exr", clamped_height(1)).report, "do not meet"));
}

TEST(ReadingHeights, MeasuredHeightsWithHolesAreRead) {
  GLINT_NEEDS_DATA();
  const std::filesystem::path path = data_directory() / "heights/measured_bullet_land_um_f32_918x256_nan.exr";
  const ReadNormalMap result = read(path, as_height(1 / 2.58));
  EXPECT_EQ(result.map.width(), 918);
  EXPECT_TRUE(warns_of(result.report, "25292 texels held no finite height"));
  for (const glm::vec2 normal : result.map.normals()) ASSERT_LE(std::hypot(normal.x, normal.y), 1);
}

// The same scan as heights and as normals derived from them elsewhere, with slopes of the surface in micrometres.
TEST(ReadingHeights, MeasuredHeightsAgreeWithTheirNormalMap) {
  GLINT_NEEDS_DATA();
  const double scale = (20.722 + 8.920) / 2.58;
  const NormalMap heights =
      read(data_directory() / "heights/measured_bullet_land_16bit_640x200.png", as_height(scale)).map;
  const NormalMap normals = read(data_directory() / "normals/derived_bullet_land_16bit_640x200.png").map;
  ASSERT_EQ(heights.width(), normals.width());
  double largest = 0;
  for (int j = 1; j + 1 < heights.height(); ++j) {
    for (int i = 1; i + 1 < heights.width(); ++i) {
      const glm::dvec2 difference = glm::dvec2(heights.texel(i, j)) - glm::dvec2(normals.texel(i, j));
      largest = std::max({largest, std::abs(difference.x), std::abs(difference.y)});
    }
  }
  EXPECT_LT(largest, 3e-4);
}

}  // namespace
}  // namespace glint::test
