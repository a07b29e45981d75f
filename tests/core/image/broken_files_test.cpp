// Bad input: one sentence that names the file and the cause, nothing on standard error, no hang and no crash.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <random>
#include <unistd.h>

#include <gmock/gmock.h>

#include "core/image/image_file.h"
#include "core/image/quiet_stderr.h"
#include "tests/core/image/image_tests.h"
#include "tests/temporary_folder.h"
#include "tests/test_data.h"

namespace glint::test {
namespace {

using namespace std::string_view_literals;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

// A PNG of some 64 x 64 map.
void write_png(const std::filesystem::path& path) {
  std::mt19937 generator(1);
  std::vector<std::uint8_t> codes(3 * 64 * 64);
  std::ranges::generate(codes, [&] { return static_cast<std::uint8_t>(generator() % 256); });
  write_image(path, 64, 64, {"R", "G", "B"}, codes);
}

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>(value >> shift & 0xff));
  return bytes;
}

TEST(BrokenFiles, WhatIsNoFileIsSaidSo) {
  const TemporaryFolder folder;
  write_text(folder / "empty.png", "");
  EXPECT_THAT(refusal(folder / "missing.png").sentence, HasSubstr("no such file"));
  EXPECT_THAT(refusal(folder.path()).sentence, HasSubstr("directory"));
  EXPECT_THAT(refusal(folder / "empty.png").sentence, HasSubstr("empty"));
  EXPECT_THAT(refusal("/dev/null").sentence, HasSubstr("not a regular file"));
  EXPECT_EQ(refusal(folder / "missing.png").kind, ErrorKind::content);
}

TEST(BrokenFiles, UnknownContentListsTheFormatsThatAreRead) {
  const TemporaryFolder folder;
  write_text(folder / "a.png", "this is a letter, not a picture");
  EXPECT_THAT(refusal(folder / "a.png").sentence, HasSubstr("PNG, JPEG, OpenEXR, TIFF"));
}

TEST(BrokenFiles, ContentDecidesTheFormatAndNotTheName) {
  const TemporaryFolder folder;
  write_png(folder / "a.png");
  const NormalMap map = read(folder / "a.png").map;
  for (const char* name : {"b.exr", "b.tga", "b", "b.jpg", "b.mp4"}) {
    std::filesystem::copy_file(folder / "a.png", folder / name);
    const ReadNormalMap result = read(folder / name);
    EXPECT_EQ(largest_difference(result.map, map), 0) << name;
    EXPECT_THAT(result.report.format, testing::StartsWith("PNG")) << name;
  }
}

TEST(BrokenFiles, SizesAreRefusedFromTheHeaderByName) {
  const TemporaryFolder folder;
  write_png(folder / "a.png");
  std::string png = text_of(folder / "a.png");
  const auto refused = [&](std::uint32_t width, std::uint32_t height) {
    png.replace(16, 8, big_endian(width) + big_endian(height));
    write_text(folder / "b.png", png);
    return refusal(folder / "b.png").sentence;
  };
  EXPECT_THAT(refused(16385, 1), HasSubstr("16385 x 1 is too large"));
  EXPECT_THAT(refused(1, 2147483647), HasSubstr("1 x 2147483647 is too large"));
  EXPECT_THAT(refused(16384, 16384), HasSubstr("2 GiB"));
  EXPECT_THAT(refused(0, 512), HasSubstr("0 x 512 is zero"));
  EXPECT_THAT(refused(16384, 14000), HasSubstr("cannot be decoded"));  // within bounds, but nothing like it follows
}

TEST(BrokenFiles, AJpegTooShortForItsSizeIsRefusedBeforeItIsFilledWithGrey) {
  const TemporaryFolder folder;
  write_image(folder / "a.jpg", 8, 8, {"R", "G", "B"}, std::vector<std::uint8_t>(192, 90));
  std::string jpeg = text_of(folder / "a.jpg");
  const std::size_t frame = jpeg.find("\xff\xc0");
  ASSERT_NE(frame, std::string::npos);
  jpeg.replace(frame + 5, 4, "\x36\xb0\x36\xb0");  // 14000 x 14000
  write_text(folder / "b.jpg", jpeg);
  EXPECT_THAT(refusal(folder / "b.jpg").sentence, HasSubstr("cannot hold a JPEG image of 14000 x 14000"));
}

TEST(BrokenFiles, AJpegCutShortIsReadWithAWarning) {
  const TemporaryFolder folder;
  std::vector<std::uint8_t> codes(3 * 64 * 64);
  std::mt19937 generator(1);
  std::ranges::generate(codes, [&] { return static_cast<std::uint8_t>(generator() % 256); });
  write_image(folder / "a.jpg", 64, 64, {"R", "G", "B"}, codes);
  EXPECT_FALSE(warns_of(read(folder / "a.jpg").report, "cut short"));
  const std::string jpeg = text_of(folder / "a.jpg");
  for (const std::size_t keep : {jpeg.size() / 2, jpeg.size() - 40, jpeg.size() - 1}) {
    write_text(folder / "b.jpg", jpeg.substr(0, keep));
    EXPECT_TRUE(warns_of(read(folder / "b.jpg").report, "cut short")) << keep;
  }
}

TEST(BrokenFiles, FilesCutShortAreRefused) {
  const TemporaryFolder folder;
  std::mt19937 generator(3);
  std::vector<std::uint8_t> codes(3 * 64 * 64);
  std::ranges::generate(codes, [&] { return static_cast<std::uint8_t>(generator() % 256); });
  for (const char* name : {"a.png", "a.exr", "a.tif", "a.tga", "a.webp", "a.bmp", "a.ppm", "a.hdr"}) {
    ASSERT_NO_FATAL_FAILURE(write_image(folder / name, 64, 64, {"R", "G", "B"}, codes));
    EXPECT_EQ(read(folder / name).map.width(), 64) << name;
    const std::string whole = text_of(folder / name);
    for (const std::size_t keep : {whole.size() / 2, whole.size() / 10, std::size_t{30}}) {
      write_text(folder / name, whole.substr(0, keep));
      const Error error = refusal(folder / name);
      EXPECT_EQ(error.subject, folder / name);
      EXPECT_FALSE(error.sentence.empty());
    }
  }
}

TEST(BrokenFiles, ADdsWithoutChannelMasksIsRefused) {
  const TemporaryFolder folder;
  std::string dds(128 + 4 * 4 * 4, '\0');
  dds.replace(0, 4, "DDS ");
  const auto put = [&](std::size_t at, std::uint32_t value) {
    for (std::size_t k = 0; k < 4; ++k) dds[at + k] = static_cast<char>(value >> 8 * k & 0xff);
  };
  put(4, 124);
  put(8, 0x1007);
  put(12, 4);
  put(16, 4);
  put(76, 32);
  put(80, 0x40);
  put(88, 32);
  put(92, 0xff0000);
  put(100, 0xff);
  put(108, 0x1000);
  write_text(folder / "a.dds", dds);
  EXPECT_THAT(refusal(folder / "a.dds").sentence, HasSubstr("does not say where its channels are"));
  put(96, 0xff00);
  dds[128] = 1;
  write_text(folder / "a.dds", dds);
  EXPECT_EQ(read(folder / "a.dds").map.width(), 4);
}

TEST(BrokenFiles, AnExrHeaderThatAsksForMoreThanTheFileIsRefused) {
  const TemporaryFolder folder;
  write_image(folder / "a.exr", 4, 4, {"R", "G", "B"}, std::vector<float>(48, 0.25F));
  const std::string exr = text_of(folder / "a.exr");
  std::string long_attribute = exr;
  const std::size_t compression = exr.find("compression\0compression\0"sv);
  ASSERT_NE(compression, std::string::npos);
  long_attribute.replace(compression + 24, 4, "\xff\xff\xff\x6f");
  write_text(folder / "b.exr", long_attribute);
  EXPECT_THAT(refusal(folder / "b.exr").sentence, HasSubstr("header is damaged"));
  std::string wide = exr;
  const std::size_t window = exr.find("dataWindow\0box2i\0"sv);
  ASSERT_NE(window, std::string::npos);
  wide.replace(window + 17 + 4 + 8, 4, "\xff\xff\xff\x3f"sv);
  write_text(folder / "b.exr", wide);
  EXPECT_THAT(refusal(folder / "b.exr").sentence, HasSubstr("too large"));
}

TEST(BrokenFiles, CancellingEndsTheReading) {
  const TemporaryFolder folder;
  write_png(folder / "a.png");
  JobControl control;
  control.cancel();
  const Result<ReadNormalMap> result = read_normal_map(folder / "a.png", {}, control);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().sentence, "cancelled");
}

TEST(BrokenFiles, ProgressReachesTheEnd) {
  const TemporaryFolder folder;
  write_png(folder / "a.png");
  JobControl control;
  ASSERT_TRUE(read_normal_map(folder / "a.png", {}, control));
  EXPECT_EQ(control.progress(), 1);
}

// Either way is right for random pixels behind a sound header: a map, or a sentence. Neither may take long.
void expect_map_or_sentence(const std::filesystem::path& path) {
  const auto start = std::chrono::steady_clock::now();
  JobControl control;
  const Result<ReadNormalMap> result = read_normal_map(path, {}, control);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5)) << path;
  if (result) {
    for (const glm::vec2 normal : result->map.normals()) ASSERT_LE(std::hypot(normal.x, normal.y), 1.000001F);
    return;
  }
  EXPECT_EQ(result.error().kind, ErrorKind::content);
  EXPECT_EQ(result.error().subject, path);
  EXPECT_FALSE(result.error().sentence.empty());
  EXPECT_THAT(result.error().sentence, Not(AnyOf(HasSubstr("\n"), testing::EndsWith("."))));
}

TEST(BrokenFiles, RandomBytesUnderAnyNameAreRefused) {
  const TemporaryFolder folder;
  std::mt19937 generator(11);
  constexpr std::array k_names{"a.png", "a.jpg", "a.exr", "a.tif",  "a.hdr", "a.pfm", "a.ppm",
                               "a.bmp", "a.dds", "a.tga", "a.webp", "a.psd", "a.avi", "a"};
  testing::internal::CaptureStderr();
  for (int k = 0; k < 200; ++k) {
    std::string bytes(generator() % 4000, '\0');
    std::ranges::generate(bytes, [&] { return static_cast<char>(generator()); });
    const std::filesystem::path path = folder / k_names[static_cast<std::size_t>(k) % k_names.size()];
    write_text(path, bytes);
    expect_map_or_sentence(path);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(BrokenFiles, GarbageBehindAnySignatureDoesNoHarm) {
  const TemporaryFolder folder;
  std::mt19937 generator(12);
  constexpr std::array k_signatures{"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x40\0\0\0\x40\x08\x02\0\0\0"sv,
                                    "\x89PNG\r\n\x1a\n"sv,
                                    "\xff\xd8\xff\xe0"sv,
                                    "\x76\x2f\x31\x01\x02\0\0\0"sv,
                                    "II*\0\x08\0\0\0"sv,
                                    "MM\0*\0\0\0\x08"sv,
                                    "II+\0"sv,
                                    "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 64 +X 64\n"sv,
                                    "P6\n64 64\n255\n"sv,
                                    "PF\n64 64\n-1.0\n"sv,
                                    "P3\n64 64\n255\n"sv,
                                    "DDS \x7c\0\0\0"sv,
                                    "BM"sv,
                                    "RIFF\0\x10\0\0WEBPVP8 "sv,
                                    "\0\0\x02\0\0\0\0\0\0\0\0\0\x40\0\x10\0\x18\0"sv,
                                    "\0\0\x0a\0\0\0\0\0\0\0\0\0\x40\0\x40\0\x20\0"sv};
  testing::internal::CaptureStderr();
  for (int k = 0; k < 200; ++k) {
    std::string bytes(k_signatures[static_cast<std::size_t>(k) % k_signatures.size()]);
    std::string garbage(generator() % 6000, '\0');
    std::ranges::generate(garbage, [&] { return static_cast<char>(generator()); });
    write_text(folder / "a.tga", bytes + garbage);
    expect_map_or_sentence(folder / "a.tga");
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

// Sound files with a few bytes changed get further into the decoders than random ones.
TEST(BrokenFiles, ChangedBytesInSoundFilesDoNoHarm) {
  const TemporaryFolder folder;
  std::mt19937 generator(13);
  std::vector<std::uint8_t> codes(4 * 32 * 32);
  std::ranges::generate(codes, [&] { return static_cast<std::uint8_t>(generator() % 256); });
  testing::internal::CaptureStderr();
  for (const char* name : {"a.png", "a.exr", "a.tif", "a.tga", "a.webp", "a.bmp", "a.jpg", "a.hdr", "a.ppm"}) {
    const bool alpha = std::string(name) != "a.jpg" && std::string(name) != "a.hdr" && std::string(name) != "a.ppm";
    std::vector<std::string> channels{"R", "G", "B"};
    if (alpha) channels.emplace_back("A");
    const std::vector<std::uint8_t> values(codes.begin(),
                                           codes.begin() + static_cast<std::ptrdiff_t>(channels.size() * 32 * 32));
    write_image(folder / name, 32, 32, channels, values);
    const std::string whole = text_of(folder / name);
    for (int k = 0; k < 60; ++k) {
      std::string changed = whole;
      const std::size_t range = k % 2 == 0 ? std::min<std::size_t>(whole.size(), 128) : whole.size();
      for (int change = 0; change < 3; ++change) changed[generator() % range] = static_cast<char>(generator());
      write_text(folder / name, changed);
      expect_map_or_sentence(folder / name);
    }
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(QuietStderr, DropsWhatIsWrittenAndGivesStandardErrorBack) {
  testing::internal::CaptureStderr();
  {
    const QuietStderr quiet;
    ASSERT_EQ(::write(STDERR_FILENO, "dropped", 7), 7);
  }
  ASSERT_EQ(::write(STDERR_FILENO, "kept", 4), 4);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "kept");
}

TEST(BrokenFiles, NothingOfTheLibrariesReachesStandardError) {
  GLINT_NEEDS_DATA();
  testing::internal::CaptureStderr();
  for (const auto& entry : std::filesystem::directory_iterator(data_directory() / "hard")) {
    JobControl control;
    const Result<ReadNormalMap> result = read_normal_map(entry.path(), {}, control);
    EXPECT_TRUE(result || result.error().subject == entry.path());
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace glint::test
