// What the report says: suspicions where they are clear, and silence where nothing is wrong.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/vec3.hpp>
#include <gmock/gmock.h>

#include "tests/core/image/image_tests.h"
#include "tests/temporary_folder.h"
#include "tests/test_data.h"

namespace glint::test {
namespace {

using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

const std::vector<std::string> k_rgb{"R", "G", "B"};
constexpr int k_side = 64;

// A unit vector of a smooth surface that repeats.
glm::dvec3 wavy(int i, int j) {
  const double step = 2 * std::numbers::pi / k_side;
  const double h_u = 0.4 * std::cos(step * (2 * i + 3 * j));
  const double h_v = 0.6 * std::cos(step * (2 * i + 3 * j)) + 0.3 * std::sin(step * 4 * j);
  const double w = std::sqrt(1 + h_u * h_u + h_v * h_v);
  return {-h_u / w, h_v / w, 1 / w};
}

// Codes of the wavy surface; `curve` maps the value in [0, 1] of each of x, y and z.
template <class Curve>
Bytes wavy_codes(Curve curve) {
  Bytes codes;
  for (int j = 0; j < k_side; ++j) {
    for (int i = 0; i < k_side; ++i) {
      const glm::dvec3 n = wavy(i, j);
      for (const double v : {n.x, n.y, n.z}) {
        codes.push_back(static_cast<std::uint8_t>(std::lround(255 * curve(0.5 + 0.5 * v))));
      }
    }
  }
  return codes;
}

double plain(double v) {
  return v;
}
double encoded(double v) {
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}
double linearised(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

ReadReport report_on(const Bytes& codes, const ReadOptions& options = {}) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", k_side, k_side, k_rgb, codes);
  return read(folder / "a.png", options).report;
}

TEST(ReadReport, AGoodMapRaisesNoWarning) {
  const ReadReport report = report_on(wavy_codes(plain));
  EXPECT_EQ(warning_count(report), 0) << text_of(report);
  EXPECT_FALSE(report.suggested_green);
  EXPECT_EQ(report.format, "PNG, 8-bit, RGB, 64 x 64");
}

TEST(ReadReport, TheOtherGreenDirectionIsSuggestedFromTheCurl) {
  const ReadReport wrong_down = report_on(wavy_codes(plain), with_green(GreenDirection::down));
  EXPECT_EQ(wrong_down.suggested_green, GreenDirection::up);
  EXPECT_TRUE(warns_of(wrong_down, "--green up"));

  Bytes flipped = wavy_codes(plain);
  for (std::size_t k = 1; k < flipped.size(); k += 3) flipped[k] = static_cast<std::uint8_t>(255 - flipped[k]);
  const ReadReport wrong_up = report_on(flipped);
  EXPECT_EQ(wrong_up.suggested_green, GreenDirection::down);
  EXPECT_TRUE(warns_of(wrong_up, "--green down"));
  EXPECT_FALSE(report_on(flipped, with_green(GreenDirection::down)).suggested_green);
}

TEST(ReadReport, ACurveTooMuchIsNoticedBothWays) {
  EXPECT_TRUE(warns_of(report_on(wavy_codes(encoded)), "sRGB curve had been applied"));
  EXPECT_TRUE(warns_of(report_on(wavy_codes(linearised)), "from sRGB to linear"));
  EXPECT_FALSE(warns_of(report_on(wavy_codes(plain)), "sRGB"));
}

TEST(ReadReport, SwappedChannelsAreNoticed) {
  Bytes swapped = wavy_codes(plain);
  for (std::size_t k = 0; k < swapped.size(); k += 3) std::swap(swapped[k], swapped[k + 2]);
  EXPECT_TRUE(warns_of(report_on(swapped), "BGR"));
}

TEST(ReadReport, NormalsAllRoundLookLikeObjectSpace) {
  Bytes codes;
  for (int j = 0; j < k_side; ++j) {
    for (int i = 0; i < k_side; ++i) {
      const double azimuth = 2 * std::numbers::pi * i / k_side;
      const double z = 1 - 2 * (j + 0.5) / k_side;
      const double radius = std::sqrt(1 - z * z);
      for (const double v : {radius * std::cos(azimuth), radius * std::sin(azimuth), z}) {
        codes.push_back(static_cast<std::uint8_t>(std::lround(127.5 + 127.5 * v)));
      }
    }
  }
  EXPECT_TRUE(warns_of(report_on(codes), "object-space"));
}

TEST(ReadReport, EdgesThatDoNotMeetAreNoticedWhereTheMapRepeats) {
  Bytes codes = wavy_codes(plain);
  for (std::size_t j = 0; j < k_side; ++j) {  // a ramp of s from left to right
    for (std::size_t i = 0; i < k_side; ++i) codes[3 * (j * k_side + i)] = static_cast<std::uint8_t>(64 + 2 * i);
  }
  EXPECT_TRUE(warns_of(report_on(codes), "the left and right edges do not meet"));
  ReadOptions clamped;
  clamped.wrap = Wrap::clamp;
  EXPECT_FALSE(warns_of(report_on(codes, clamped), "do not meet"));
}

TEST(ReadReport, VectorsFarFromUnitLengthAreNoticed) {
  const TemporaryFolder folder;
  write_image(folder / "a.exr", 2, 1, k_rgb, std::vector<float>{0.1F, -0.1F, 0.2F, -1, 1, 3});
  EXPECT_TRUE(warns_of(read(folder / "a.exr").report, "vectors between 0.245 and 3.32 long"));
}

TEST(ReadReport, ARangeGuessedWrongIsNoticed) {
  const TemporaryFolder folder;
  std::vector<float> all_positive;  // unit vectors that lean right and up everywhere
  std::vector<float> slightly_negative;
  for (int k = 0; k < 256; ++k) {
    const double x = 0.05 + 0.0005 * k;
    const double y = 0.05 + 0.0002 * k;
    for (const double v : {x, y, std::sqrt(1 - x * x - y * y)}) all_positive.push_back(static_cast<float>(v));
    const glm::dvec3 n = wavy(k, k);
    for (const double v : {n.x, n.y, n.z}) slightly_negative.push_back(static_cast<float>(0.5 + 0.5 * v));
  }
  slightly_negative[0] = -0.001F;
  write_image(folder / "a.exr", 256, 1, k_rgb, all_positive);
  EXPECT_TRUE(warns_of(read(folder / "a.exr").report, "--range signed"));
  write_image(folder / "b.exr", 256, 1, k_rgb, slightly_negative);
  EXPECT_TRUE(warns_of(read(folder / "b.exr").report, "--range unsigned"));
}

TEST(QuantisationStep, IsTheSmallestStepThatOccurs) {
  EXPECT_NEAR(report_on(wavy_codes(plain)).quantisation_step, 2 / 255.0, 1e-9);
  Bytes coarse = wavy_codes(plain);
  for (std::uint8_t& code : coarse) code = static_cast<std::uint8_t>(17 * (code / 17));
  EXPECT_NEAR(report_on(coarse).quantisation_step, 2 * 17 / 255.0, 1e-9);
}

TEST(QuantisationStep, EightBitsInASixteenBitFileAreNoFiner) {
  const TemporaryFolder folder;
  std::vector<std::uint16_t> wide;
  for (const std::uint8_t code : wavy_codes(plain)) wide.push_back(static_cast<std::uint16_t>(257 * code));
  write_image(folder / "a.png", k_side, k_side, k_rgb, wide);
  EXPECT_NEAR(read(folder / "a.png").report.quantisation_step, 2 / 255.0, 1e-9);
}

TEST(QuantisationStep, IsZeroForFloatFiles) {
  const TemporaryFolder folder;
  write_image(folder / "a.exr", 2, 1, k_rgb, std::vector<float>{0.1F, -0.1F, 0.2F, -1, 1, 3});
  EXPECT_EQ(read(folder / "a.exr").report.quantisation_step, 0);
}

TEST(QuantisationNote, SpeaksWhereTheRoughnessIsBelowTheStep) {
  const ReadReport report = report_on(wavy_codes(plain));
  EXPECT_FALSE(quantisation_note(report, 0.02));
  EXPECT_FALSE(quantisation_note(report, 0.0079));
  ASSERT_TRUE(quantisation_note(report, 0.005));
  EXPECT_THAT(*quantisation_note(report, 0.005), HasSubstr("0.005"));
  EXPECT_FALSE(quantisation_note(ReadReport{}, 0.0001));
}

// Maps of the data set: which direction of green is suggested against the default, as far as it is clear.
TEST(ReadReport, RealMapsRaiseNoWrongSuspicion) {
  GLINT_NEEDS_DATA();
  const std::vector<std::string> down{"brick_2048.jpg",
                                      "dented_metal_512.png",
                                      "dielectric_wavy_f16_512.exr",
                                      "flow_bands_1024.png",
                                      "gaussian_beckmann_f32_512.exr",
                                      "leather_fine_512.png",
                                      "paper_crumpled_512.png",
                                      "rock_face_512.png",
                                      "scratches_crossed_1024.png",
                                      "striped_cotton_2048.jpg"};
  const std::vector<std::string> seams{"chessboard_lowslope_2048.jpg",
                                       "dented_metal_512.png",
                                       "derived_bullet_land_16bit_640x200.png",
                                       "dielectric_wavy_f16_512.exr",
                                       "flakes_carpaint_512.png",
                                       "flakes_voronoi_1024.tga",
                                       "flow_bands_1024.png",
                                       "gaussian_beckmann_f32_512.exr",
                                       "paper_crumpled_512.png",
                                       "rock_face_512.png",
                                       "snow_drift_501x512.png"};
  int maps = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data_directory() / "normals")) {
    const std::string name = entry.path().filename().string();
    const ReadReport report = read(entry.path()).report;
    ++maps;
    EXPECT_EQ(report.suggested_green.has_value(), std::ranges::count(down, name) == 1) << name;
    EXPECT_EQ(report.suggested_green.value_or(GreenDirection::down), GreenDirection::down) << name;
    EXPECT_EQ(warns_of(report, "do not meet"), std::ranges::count(seams, name) == 1) << name;
    for (const char* suspicion : {"sRGB", "BGR", "object-space", "--range", "cut short", "decoder", "NaN",
                                  "zero vector", "constant", "long were normalised"}) {
      EXPECT_FALSE(warns_of(report, suspicion)) << name << "\n" << text_of(report);
    }
  }
  EXPECT_EQ(maps, 23);
}

}  // namespace
}  // namespace glint::test
