// Every file of the data set's folder of hard ones, with what must come of it.

#include <algorithm>
#include <array>
#include <cmath>

#include <gmock/gmock.h>

#include "tests/core/image/image_tests.h"
#include "tests/test_data.h"

namespace glint::test {
namespace {

using testing::HasSubstr;

// A file that is read: its size, and a part of a sentence of its report ("" for any, "-" for no warning at all).
struct ReadableFile {
  const char* name;
  int width;
  int height;
  const char* note;
};

constexpr std::array k_readable{
    ReadableFile{"1x1_flat.png", 1, 1, "constant"},
    ReadableFile{"1x1_tilted.png", 1, 1, "constant"},
    ReadableFile{"1x256_column.png", 1, 256, "-"},
    ReadableFile{"256x1_row.png", 256, 1, "-"},
    ReadableFile{"2x2.png", 2, 2, "-"},
    ReadableFile{"bc5_style_blue_zero.png", 256, 256, "blue is constant"},
    ReadableFile{"blue_below_half_patch.png", 256, 256, "6400 texels had z <= 0"},
    ReadableFile{"channels_named_NxNyNz_f32.exr", 256, 256, "-"},
    ReadableFile{"channels_swapped_bgr.png", 256, 256, "BGR"},
    ReadableFile{"cmyk.jpg", 256, 256, "-"},
    ReadableFile{"datawindow_offset.exr", 256, 256, "-"},
    ReadableFile{"dwaa_compressed.exr", 256, 256, "-"},
    ReadableFile{"dxt5nm_swizzle_x_in_alpha.png", 256, 256, "DXT5nm"},
    ReadableFile{"flat_127_127_255.png", 256, 256, "constant"},
    ReadableFile{"flat_128_128_255.png", 256, 256, "constant"},
    ReadableFile{"float_strip.tif", 256, 256, "-"},
    ReadableFile{"green_flipped_pair.png", 256, 256, "--green down"},
    ReadableFile{"green_original_pair.png", 256, 256, "-"},
    ReadableFile{"interlaced.png", 256, 256, "-"},
    ReadableFile{"jpeg_named.png", 256, 256, "-"},
    ReadableFile{"jpeg_q10_420.jpg", 256, 256, "46 texels had z <= 0"},
    ReadableFile{"jpeg_q30_420.jpg", 256, 256, "16 texels had z <= 0"},
    ReadableFile{"jpeg_q75_420.jpg", 256, 256, "2 texels had z <= 0"},
    ReadableFile{"linearised_by_mistake.png", 256, 256, "from sRGB to linear"},
    ReadableFile{"made_bc5_ati2.dds", 256, 256, "two channels"},
    ReadableFile{"name with space \xc3\xa9.png", 256, 256, "-"},
    ReadableFile{"nan_inf_zero_signed_f32.exr", 256, 256, "16 texels held a zero vector"},
    ReadableFile{"npot_251x193.png", 251, 193, "-"},
    ReadableFile{"object_space_sphere_512x256.png", 512, 256, "object-space"},
    ReadableFile{"only_RG_f16.exr", 256, 256, "two channels"},
    ReadableFile{"palette256.png", 256, 256, "-"},
    ReadableFile{"palette64.png", 256, 256, "-"},
    ReadableFile{"png_with_gama_chunk.png", 256, 256, "-"},
    ReadableFile{"quantised_4bit_per_channel.png", 256, 256, "-"},
    ReadableFile{"real_baked_pole_texels_f32_512.exr", 512, 512, "2 texels had z <= 0"},
    ReadableFile{"real_black_border_522.png", 522, 522, "10340 texels had z <= 0"},
    ReadableFile{"real_brushed_nz_below_zero_1024.png", 1024, 1024, "39167 texels had z <= 0"},
    ReadableFile{"real_isotropic_blue_missing_1024.png", 1024, 1024, "blue is constant"},
    ReadableFile{"real_lossy_original.webp", 512, 512, "--green down"},
    ReadableFile{"rgba16_alpha_is_roughness.png", 256, 256, "-"},
    ReadableFile{"rle_bottom_up.tga", 256, 256, "-"},
    ReadableFile{"signed_f16.exr", 256, 256, "as they stand"},
    ReadableFile{"srgb_encoded_by_mistake.png", 256, 256, "sRGB curve had been applied"},
    ReadableFile{"strength_x6_extreme_slopes.png", 256, 256, "-"},
    ReadableFile{"tiled_f32.exr", 157, 201, "-"},
    ReadableFile{"transparent_color_key.png", 256, 256, "-"},
    ReadableFile{"truncated.jpg", 256, 256, "cut short"},
    ReadableFile{"two_channel_LA.png", 256, 256, "luminance and alpha"},
    ReadableFile{"two_channel_blue_255.png", 256, 256, "blue is constant"},
    ReadableFile{"uint16_bigendian_tiled.tif", 256, 256, "-"},
    ReadableFile{"unnormalised_length_0.2_to_3_f32.exr", 256, 256, "vectors between 0.109 and 3.94 long"},
    ReadableFile{"unsigned01_f16.exr", 256, 256, "2c - 1"},
    ReadableFile{"wide_256x37.png", 256, 37, "-"},
};

// A file that is refused, and a part of the sentence.
struct RefusedFile {
  const char* name;
  const char* sentence;
};

constexpr std::array k_refused{
    RefusedFile{"all_black.png", "not a normal map"},
    RefusedFile{"all_white.png", "not a normal map"},
    RefusedFile{"empty.png", "empty"},
    RefusedFile{"greyscale_height_as_normal.png", "--height SCALE"},
    RefusedFile{"huge_header_1000000sq.png", "1000000 x 1000000 is too large"},
    RefusedFile{"huge_header_2147483647x2.png", "2147483647 x 2 is too large"},
    RefusedFile{"huge_header_32768sq.png", "32768 x 32768 is too large"},
    RefusedFile{"one_bit.png", "--height SCALE"},
    RefusedFile{"text_not_image.png", "none of the image formats"},
    RefusedFile{"truncated.exr", "nexpected end of file"},
    RefusedFile{"truncated.png", "cut short"},
    RefusedFile{"truncated_in_header.png", "header is damaged or cut short"},
    RefusedFile{"zero_width.png", "0 x 512 is zero"},
};

std::filesystem::path hard_file(const std::string& name) {
  return data_directory() / "hard" / name;
}

TEST(HardFiles, EachIsListedHere) {
  GLINT_NEEDS_DATA();
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(data_directory() / "hard")) ++files;
  EXPECT_EQ(files, k_readable.size() + k_refused.size());
}

TEST(HardFiles, ThoseWithAMapAreReadWithTheRightNotes) {
  GLINT_NEEDS_DATA();
  for (const ReadableFile& file : k_readable) {
    SCOPED_TRACE(file.name);
    const ReadNormalMap result = read(hard_file(file.name));
    EXPECT_EQ(result.map.width(), file.width);
    EXPECT_EQ(result.map.height(), file.height);
    for (const glm::vec2 normal : result.map.normals()) ASSERT_LE(std::hypot(normal.x, normal.y), 1.000001F);
    if (std::string_view(file.note) == "-") {
      EXPECT_EQ(warning_count(result.report), 0) << text_of(result.report);
    } else {
      EXPECT_THAT(text_of(result.report), HasSubstr(file.note));
    }
  }
}

TEST(HardFiles, ThoseWithoutAreRefusedWithOneSentence) {
  GLINT_NEEDS_DATA();
  for (const RefusedFile& file : k_refused) {
    const Error error = refusal(hard_file(file.name));
    EXPECT_EQ(error.kind, ErrorKind::content);
    EXPECT_EQ(error.subject, hard_file(file.name));
    EXPECT_THAT(error.sentence, HasSubstr(file.sentence));
  }
}

// The same map in other clothes; the tolerance is what the format's own precision allows.
TEST(HardFiles, TheSameMapInOtherFormatsAgrees) {
  GLINT_NEEDS_DATA();
  const NormalMap original = read(hard_file("green_original_pair.png")).map;
  struct Twin {
    const char* name;
    double tolerance;
  };
  constexpr std::array k_twins{Twin{"interlaced.png", 0},
                               Twin{"name with space \xc3\xa9.png", 0},
                               Twin{"png_with_gama_chunk.png", 0},
                               Twin{"transparent_color_key.png", 0},
                               Twin{"rle_bottom_up.tga", 0},
                               Twin{"channels_named_NxNyNz_f32.exr", 5e-7},
                               Twin{"float_strip.tif", 5e-7},
                               Twin{"rgba16_alpha_is_roughness.png", 5e-7},
                               Twin{"uint16_bigendian_tiled.tif", 5e-7},
                               Twin{"unnormalised_length_0.2_to_3_f32.exr", 5e-7},
                               Twin{"signed_f16.exr", 5e-4},
                               Twin{"datawindow_offset.exr", 5e-4},
                               Twin{"unsigned01_f16.exr", 2e-3},
                               Twin{"dwaa_compressed.exr", 0.02},
                               Twin{"cmyk.jpg", 0.2},
                               Twin{"palette256.png", 0.4},
                               Twin{"jpeg_named.png", 0.4},
                               Twin{"palette64.png", 0.45}};
  for (const Twin& twin : k_twins) {
    EXPECT_LE(largest_difference(read(hard_file(twin.name)).map, original), twin.tolerance) << twin.name;
  }
}

// Crops of the same map, whose texels must be its own.
TEST(HardFiles, CropsOfTheMapHoldItsTexels) {
  GLINT_NEEDS_DATA();
  const NormalMap original = read(hard_file("green_original_pair.png")).map;
  for (const char* name :
       {"1x256_column.png", "256x1_row.png", "2x2.png", "npot_251x193.png", "wide_256x37.png", "tiled_f32.exr"}) {
    const NormalMap crop = read(hard_file(name)).map;
    double largest = 0;
    for (int j = 0; j < crop.height(); ++j) {
      for (int i = 0; i < crop.width(); ++i) {
        const glm::vec2 difference = crop.texel(i, j) - original.texel(i, j);
        largest = std::max<double>({largest, std::abs(difference.x), std::abs(difference.y)});
      }
    }
    EXPECT_LE(largest, 5e-7) << name;
  }
}

TEST(HardFiles, TheDirectxTwinWithGreenDownIsTheOriginal) {
  GLINT_NEEDS_DATA();
  const NormalMap original = read(hard_file("green_original_pair.png")).map;
  const ReadNormalMap twin = read(hard_file("green_flipped_pair.png"), with_green(GreenDirection::down));
  EXPECT_LE(largest_difference(twin.map, original), 5e-7);
  EXPECT_FALSE(twin.report.suggested_green);
  EXPECT_EQ(read(hard_file("green_flipped_pair.png")).report.suggested_green, GreenDirection::down);
}

TEST(HardFiles, TwoChannelsAgreeHoweverTheyAreStored) {
  GLINT_NEEDS_DATA();
  const NormalMap pair = read(hard_file("two_channel_blue_255.png")).map;
  EXPECT_EQ(largest_difference(read(hard_file("bc5_style_blue_zero.png")).map, pair), 0);
  EXPECT_EQ(largest_difference(read(hard_file("two_channel_LA.png")).map, pair), 0);
  EXPECT_EQ(largest_difference(read(hard_file("dxt5nm_swizzle_x_in_alpha.png")).map, pair), 0);
  EXPECT_LE(largest_difference(read(hard_file("only_RG_f16.exr")).map, pair), 5e-4);
  EXPECT_LE(largest_difference(read(hard_file("made_bc5_ati2.dds")).map, pair), 0.25);
}

TEST(HardFiles, ContentOfFourBitsIsNotedAsCoarse) {
  GLINT_NEEDS_DATA();
  const ReadReport report = read(hard_file("quantised_4bit_per_channel.png")).report;
  EXPECT_GE(report.quantisation_step, 2 * 15 / 255.0);
  EXPECT_TRUE(quantisation_note(report, 0.05));
}

TEST(HardFiles, AHeightMapIsReadAsOneWhenAskedTo) {
  GLINT_NEEDS_DATA();
  EXPECT_EQ(read(hard_file("greyscale_height_as_normal.png"), as_height(20)).map.width(), 512);
  EXPECT_EQ(read(hard_file("one_bit.png"), as_height(1)).map.width(), 256);
  EXPECT_THAT(refusal(hard_file("2x2.png"), as_height(1)).sentence, HasSubstr("channels differ"));
}

}  // namespace
}  // namespace glint::test
