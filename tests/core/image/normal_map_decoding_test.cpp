// Every row of the conventions' table on reading, on files small enough to work out by hand.

#include <algorithm>
#include <cmath>
#include <random>

#include <gmock/gmock.h>

#include "tests/core/image/image_tests.h"
#include "tests/temporary_folder.h"

namespace glint::test {
namespace {

using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;
using Floats = std::vector<float>;

const std::vector<std::string> k_rgb{"R", "G", "B"};
const std::vector<std::string> k_rgba{"R", "G", "B", "A"};

double decoded(int code, double largest = 255) {
  return 2 * code / largest - 1;
}

void expect_normal(glm::vec2 normal, double s, double t, double tolerance = 3e-7) {
  EXPECT_NEAR(normal.x, s, tolerance);
  EXPECT_NEAR(normal.y, t, tolerance);
}

void expect_vector(glm::vec2 normal, double x, double y, double z, double tolerance = 3e-7) {
  const double length = std::sqrt(x * x + y * y + z * z);
  expect_normal(normal, x / length, y / length, tolerance);
}

TEST(DecodingIntegers, EightBitsAreTwoCMinusOneNormalised) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", 2, 2, k_rgb, Bytes{128, 128, 255, 200, 60, 220, 0, 128, 190, 127, 255, 128});
  const NormalMap map = read(folder / "a.png").map;
  expect_vector(map.texel(0, 0), decoded(128), decoded(128), 1);
  expect_vector(map.texel(1, 0), decoded(200), decoded(60), decoded(220));
  expect_vector(map.texel(0, 1), -1, decoded(128), decoded(190));
  expect_vector(map.texel(1, 1), decoded(127), 1, decoded(128));
}

TEST(DecodingIntegers, SixteenBitsAreTwoCMinusOneNormalised) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", 2, 1, k_rgb, std::vector<std::uint16_t>{40000, 20000, 60000, 32768, 32767, 65535});
  const NormalMap map = read(folder / "a.png").map;
  expect_vector(map.texel(0, 0), decoded(40000, 65535), decoded(20000, 65535), decoded(60000, 65535));
  expect_vector(map.texel(1, 0), decoded(32768, 65535), decoded(32767, 65535), 1);
}

TEST(DecodingIntegers, SignedIntegersAreTakenAsTheyStand) {
  const TemporaryFolder folder;
  write_image(folder / "a.tif", 2, 1, k_rgb, std::vector<std::int16_t>{-16000, 8000, 30000, 0, 0, 32767});
  const ReadNormalMap result = read(folder / "a.tif");
  expect_vector(result.map.texel(0, 0), -16000, 8000, 30000, 1e-4);
  expect_normal(result.map.texel(1, 0), 0, 0);
  EXPECT_THAT(text_of(result.report), HasSubstr("signed integers"));
}

// Where alpha scaled the colours, red would come back as 128 * 0.25 and so on.
TEST(DecodingIntegers, AlphaIsIgnoredAndNotMultipliedIn) {
  const TemporaryFolder folder;
  const Bytes values{200, 60, 220, 64, 100, 140, 230, 255, 90, 128, 240, 0, 10, 128, 200, 3};
  for (const char* name : {"a.png", "a.tif", "a.tga", "a.bmp", "a.webp"}) {
    ASSERT_NO_FATAL_FAILURE(write_image(folder / name, 2, 2, k_rgba, values));
    if (std::string(name) == "a.webp") continue;  // lossy: only that it is read, below
    const ReadNormalMap result = read(folder / name);
    expect_vector(result.map.texel(0, 0), decoded(200), decoded(60), decoded(220));
    expect_vector(result.map.texel(0, 1), decoded(90), decoded(128), decoded(240));
    EXPECT_THAT(text_of(result.report), HasSubstr("alpha")) << name;
  }
  EXPECT_EQ(read(folder / "a.webp").map.width(), 2);
}

TEST(DecodingChannels, ConstantBlueIsRebuiltAtAnyValue) {
  const TemporaryFolder folder;
  for (const std::uint8_t blue : {std::uint8_t{0}, std::uint8_t{41}, std::uint8_t{128}, std::uint8_t{255}}) {
    write_image(folder / "a.png", 2, 1, k_rgb, Bytes{200, 60, blue, 100, 130, blue});
    const ReadNormalMap result = read(folder / "a.png");
    expect_normal(result.map.texel(0, 0), decoded(200), decoded(60));
    expect_normal(result.map.texel(1, 0), decoded(100), decoded(130));
    EXPECT_THAT(text_of(result.report), HasSubstr("blue is constant")) << int{blue};
  }
}

TEST(DecodingChannels, BlueIsRebuiltWhereOnlyOneOtherChannelVaries) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", 2, 1, k_rgb, Bytes{128, 60, 255, 128, 130, 255});
  expect_normal(read(folder / "a.png").map.texel(0, 0), decoded(128), decoded(60));
}

TEST(DecodingChannels, TwoChannelsLongerThanOneGoToTheRimAndAreCounted) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", 2, 2, k_rgb, Bytes{200, 60, 9, 255, 255, 9, 128, 128, 9, 0, 20, 9});
  const ReadNormalMap result = read(folder / "a.png");
  expect_normal(result.map.texel(1, 0), std::sqrt(0.5), std::sqrt(0.5));
  expect_vector(result.map.texel(0, 1), decoded(128), decoded(128), std::sqrt(1 - 2 * decoded(128) * decoded(128)));
  expect_vector(result.map.texel(1, 1), -1, decoded(20), 0);
  EXPECT_TRUE(warns_of(result.report, "2 texels had (s, t) longer than 1"));
  EXPECT_TRUE(warns_of(result.report, "the first at column 1, row 0"));
}

TEST(DecodingChannels, Dxt5nmTakesXFromAlpha) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", 2, 1, k_rgba, Bytes{255, 60, 255, 200, 255, 130, 255, 100});
  const ReadNormalMap result = read(folder / "a.png");
  expect_normal(result.map.texel(0, 0), decoded(200), decoded(60));
  expect_normal(result.map.texel(1, 0), decoded(100), decoded(130));
  EXPECT_THAT(text_of(result.report), HasSubstr("DXT5nm"));
}

TEST(DecodingChannels, LuminanceAndAlphaAreAPairWhereAlphaVaries) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", 2, 1, {"Y", "A"}, Bytes{200, 60, 100, 130});
  const ReadNormalMap result = read(folder / "a.png");
  expect_normal(result.map.texel(0, 0), decoded(200), decoded(60));
  EXPECT_THAT(text_of(result.report), HasSubstr("luminance and alpha"));
  write_image(folder / "b.png", 2, 1, {"Y", "A"}, Bytes{200, 60, 100, 60});
  EXPECT_THAT(refusal(folder / "b.png").sentence, HasSubstr("--height"));
}

TEST(DecodingChannels, TwoFloatChannelsAreAPair) {
  const TemporaryFolder folder;
  write_image(folder / "a.exr", 2, 1, {"R", "G"}, Floats{0.5F, -0.25F, 0.F, 0.125F});
  const ReadNormalMap result = read(folder / "a.exr");
  EXPECT_EQ(result.map.texel(0, 0), glm::vec2(0.5F, -0.25F));
  EXPECT_EQ(result.map.texel(1, 0), glm::vec2(0.F, 0.125F));
  EXPECT_THAT(text_of(result.report), HasSubstr("two channels"));
}

TEST(DecodingChannels, ConstantColourIsDecodedAsItStandsAndReported) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", 2, 1, k_rgb, Bytes{200, 60, 220, 200, 60, 220});
  const ReadNormalMap result = read(folder / "a.png");
  expect_vector(result.map.texel(1, 0), decoded(200), decoded(60), decoded(220));
  EXPECT_TRUE(warns_of(result.report, "constant"));
}

TEST(DecodingChannels, ConstantGreyIsNotANormalMap) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", 2, 1, k_rgb, Bytes{77, 77, 77, 77, 77, 77});
  EXPECT_THAT(refusal(folder / "a.png").sentence, HasSubstr("not a normal map"));
  write_image(folder / "b.png", 2, 1, {"Y"}, Bytes{77, 77});
  EXPECT_THAT(refusal(folder / "b.png").sentence, HasSubstr("not a normal map"));
}

TEST(DecodingChannels, OneOrEqualChannelsAreRefusedNamingHeight) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", 2, 1, k_rgb, Bytes{77, 77, 77, 78, 78, 78});
  write_image(folder / "b.png", 2, 1, {"Y"}, Bytes{77, 78});
  write_image(folder / "c.png", 2, 1, k_rgba, Bytes{77, 77, 77, 9, 78, 78, 78, 200});
  for (const char* name : {"a.png", "b.png", "c.png"}) {
    const Error error = refusal(folder / name);
    EXPECT_EQ(error.kind, ErrorKind::content);
    EXPECT_EQ(error.subject, folder / name);
    EXPECT_THAT(error.sentence, HasSubstr("--height SCALE"));
  }
}

TEST(DecodingChannels, NamesInAnyCaseSettleTheOrder) {
  const TemporaryFolder folder;
  const Floats vector{0.1F, -0.2F, 0.9F, 0.3F, 0.2F, 0.8F};
  const std::vector<std::vector<std::string>> sets{{"X", "Y", "Z"},       {"x", "y", "z"},    {"N.X", "N.Y", "N.Z"},
                                                   {"n.x", "n.y", "n.z"}, {"NX", "NY", "NZ"}, {"nx", "ny", "nz"},
                                                   {"r", "g", "b"}};
  for (const auto& names : sets) {
    write_image(folder / "a.exr", 2, 1, names, vector);
    expect_vector(read(folder / "a.exr").map.texel(0, 0), 0.1, -0.2, 0.9);
  }
  // In TIFF order stands, in OpenEXR names are sorted, and both must come out right.
  write_image(folder / "b.exr", 2, 1, {"depth", "N.Z", "N.Y", "N.X"},
              Floats{7, 0.9F, -0.2F, 0.1F, 7, 0.8F, 0.2F, 0.3F});
  const ReadNormalMap result = read(folder / "b.exr");
  expect_vector(result.map.texel(0, 0), 0.1, -0.2, 0.9);
  expect_vector(result.map.texel(1, 0), 0.3, 0.2, 0.8);
  EXPECT_THAT(text_of(result.report), HasSubstr("N.X, N.Y, N.Z"));
}

TEST(DecodingChannels, NormalsAreFoundBesideColours) {
  const TemporaryFolder folder;
  write_image(folder / "a.exr", 2, 1, {"R", "G", "B", "N.X", "N.Y", "N.Z"},
              Floats{.1F, .1F, .1F, 0.1F, -0.2F, 0.9F, .2F, .2F, .2F, 0.3F, 0.2F, 0.8F});
  expect_vector(read(folder / "a.exr").map.texel(1, 0), 0.3, 0.2, 0.8);
}

TEST(DecodingChannels, UnknownNamesAreTakenInOrder) {
  const TemporaryFolder folder;
  write_image(folder / "a.exr", 2, 1, {"a1", "a2", "a3", "a4"},
              Floats{0.1F, -0.2F, 0.9F, 0.5F, 0.3F, 0.2F, 0.8F, 0.6F});
  expect_vector(read(folder / "a.exr").map.texel(0, 0), 0.1, -0.2, 0.9);
}

TEST(DecodingFloats, AnyNegativeXOrYMeansAsItStands) {
  const TemporaryFolder folder;
  write_image(folder / "a.exr", 2, 1, k_rgb, Floats{0.1F, 0.2F, 0.9F, 0.3F, -0.0001F, 0.8F});
  expect_vector(read(folder / "a.exr").map.texel(0, 0), 0.1, 0.2, 0.9);
  write_image(folder / "a.tif", 2, 1, k_rgb, Floats{0.1F, 0.2F, 0.9F, -0.3F, 0.1F, 0.8F});
  expect_vector(read(folder / "a.tif").map.texel(0, 0), 0.1, 0.2, 0.9);
}

TEST(DecodingFloats, WithoutANegativeXOrYTheyAreTwoCMinusOne) {
  const TemporaryFolder folder;
  write_image(folder / "a.exr", 2, 1, k_rgb, Floats{0.75F, 0.5F, 0.9F, 0.25F, 0.5F, -0.8F});  // z alone does not count
  const ReadNormalMap result = read(folder / "a.exr");
  expect_vector(result.map.texel(0, 0), 0.5, 0, 0.8);
  expect_vector(result.map.texel(1, 0), -0.5, 0, -2.6);
  EXPECT_THAT(text_of(result.report), HasSubstr("--range signed"));
}

TEST(DecodingFloats, TheRangeCanBeForced) {
  const TemporaryFolder folder;
  write_image(folder / "a.exr", 2, 1, k_rgb, Floats{0.75F, 0.5F, 0.9F, 0.25F, 0.5F, 0.8F});
  write_image(folder / "b.exr", 2, 1, k_rgb, Floats{0.75F, -0.5F, 0.9F, 0.25F, 0.5F, 0.8F});
  ReadOptions as_signed;
  as_signed.range = ValueRange::signed_values;
  expect_vector(read(folder / "a.exr", as_signed).map.texel(0, 0), 0.75, 0.5, 0.9);
  ReadOptions as_unsigned;
  as_unsigned.range = ValueRange::unsigned_values;
  expect_vector(read(folder / "b.exr", as_unsigned).map.texel(0, 0), 0.5, -2, 0.8);
}

TEST(DecodingFloats, IntegersAreTwoCMinusOneWhateverTheRange) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", 2, 1, k_rgb, Bytes{200, 60, 220, 100, 70, 230});
  ReadOptions as_signed;
  as_signed.range = ValueRange::signed_values;
  expect_vector(read(folder / "a.png", as_signed).map.texel(0, 0), decoded(200), decoded(60), decoded(220));
}

TEST(DecodingGreen, DownFlipsTAndNothingElse) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", 2, 1, k_rgb, Bytes{200, 60, 220, 100, 70, 230});
  const NormalMap up = read(folder / "a.png").map;
  const NormalMap down = read(folder / "a.png", with_green(GreenDirection::down)).map;
  for (int i = 0; i < 2; ++i) EXPECT_EQ(down.texel(i, 0), glm::vec2(up.texel(i, 0).x, -up.texel(i, 0).y));
}

TEST(DecodingRepairs, ZeroVectorsNanAndInfinityBecomeFlatAndAreCounted) {
  const TemporaryFolder folder;
  constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float k_infinity = std::numeric_limits<float>::infinity();
  write_image(folder / "a.exr", 3, 2, k_rgb,
              Floats{0.1F, -0.2F, 0.9F, 0, 0, 0, k_nan, 0, 1, 0, 0, -k_infinity, 0.3F, 0.2F, k_nan, 0, 0, 0});
  const ReadNormalMap result = read(folder / "a.exr");
  expect_vector(result.map.texel(0, 0), 0.1, -0.2, 0.9);
  for (int k = 1; k < 6; ++k) EXPECT_EQ(result.map.texel(k % 3, k / 3), glm::vec2(0, 0)) << k;
  EXPECT_TRUE(warns_of(result.report,
                       "3 texels held NaN or infinity and became the flat normal; the first at column 2, row 0"));
  EXPECT_TRUE(
      warns_of(result.report, "2 texels held a zero vector and became the flat normal; the first at column 1, row 0"));
}

TEST(DecodingRepairs, NanInAnUnusedChannelDoesNoHarm) {
  const TemporaryFolder folder;
  constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
  write_image(folder / "a.exr", 2, 1, k_rgba, Floats{0.1F, -0.2F, 0.9F, k_nan, 0.3F, 0.2F, 0.8F, 1});
  const ReadNormalMap result = read(folder / "a.exr");
  expect_vector(result.map.texel(0, 0), 0.1, -0.2, 0.9);
  EXPECT_EQ(warning_count(result.report), 0) << text_of(result.report);
}

TEST(DecodingRepairs, NormalsTurnedAwayAreKeptAndCounted) {
  const TemporaryFolder folder;
  write_image(folder / "a.exr", 2, 2, k_rgb,
              Floats{0.1F, -0.2F, 0.9F, 0.6F, 0, -0.8F, 0.6F, 0.8F, 0, 0.3F, 0.2F, 0.8F});
  const ReadNormalMap result = read(folder / "a.exr");
  expect_normal(result.map.texel(1, 0), 0.6, 0);
  expect_normal(result.map.texel(0, 1), 0.6, 0.8);
  EXPECT_TRUE(warns_of(result.report, "2 texels had z <= 0"));
  EXPECT_TRUE(warns_of(result.report, "the first at column 1, row 0"));
}

// The floats in memory are the map: one rounding of the double computation, none before it. The expected values go
// through volatile memory, as g++ drops a conversion to float and back inside vectorised pairs.
TEST(DecodingPrecision, EachTexelIsTheDoubleComputationRoundedOnce) {
  const TemporaryFolder folder;
  std::mt19937 generator(7);
  std::uniform_real_distribution<float> uniform(0.001F, 0.999F);
  constexpr int k_side = 64;
  Floats values(3 * k_side * k_side);
  std::ranges::generate(values, [&] { return uniform(generator); });
  write_image(folder / "a.exr", k_side, k_side, k_rgb, values);
  const NormalMap map = read(folder / "a.exr").map;
  for (std::size_t k = 0; k < map.normals().size(); ++k) {
    volatile double x = 2 * static_cast<double>(values[3 * k]) - 1;
    volatile double y = 2 * static_cast<double>(values[3 * k + 1]) - 1;
    volatile double z = 2 * static_cast<double>(values[3 * k + 2]) - 1;
    volatile double squares = x * x;
    squares = squares + y * y;
    squares = squares + z * z;
    volatile double length = std::sqrt(squares);
    volatile float s = static_cast<float>(x / length);
    volatile float t = static_cast<float>(y / length);
    ASSERT_EQ(map.normals()[k].x, s) << k;
    ASSERT_EQ(map.normals()[k].y, t) << k;
  }
}

TEST(DecodingMap, KeepsTheWrapAndTheOrderOfRows) {
  const TemporaryFolder folder;
  ReadOptions options;
  options.wrap = Wrap::clamp;
  write_image(folder / "a.png", 1, 3, k_rgb, Bytes{10, 128, 200, 128, 10, 200, 245, 128, 200});
  const NormalMap map = read(folder / "a.png", options).map;
  EXPECT_EQ(map.wrap(), Wrap::clamp);
  EXPECT_EQ(map.height(), 3);
  EXPECT_LT(map.texel(0, 0).x, -0.5F);
  EXPECT_LT(map.texel(0, 1).y, -0.5F);
  EXPECT_GT(map.texel(0, 2).x, 0.5F);
}

}  // namespace
}  // namespace glint::test
