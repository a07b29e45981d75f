#include "core/image/stored_samples.h"

#include <numeric>

#include <gtest/gtest.h>

#include "tests/core/image/image_tests.h"
#include "tests/temporary_folder.h"

namespace glint::test {
namespace {

StoredSamples stored_of(const std::filesystem::path& path, const ReadOptions& options = {}) {
  JobControl control;
  StoredSamples stored;
  const Result<ReadNormalMap> read = read_normal_map(path, options, control, &stored);
  EXPECT_TRUE(read) << read.error().message();
  return stored;
}

// Every code of an unsigned type, in three channels that differ.
template <class Code>
std::vector<Code> all_codes(std::size_t texels) {
  std::vector<Code> codes;
  for (std::size_t k = 0; k < texels; ++k) {
    codes.push_back(static_cast<Code>(k));
    codes.push_back(static_cast<Code>(texels - 1 - k));
    codes.push_back(static_cast<Code>(k * 7));
  }
  return codes;
}

template <class Code>
void expect_kept(const StoredSamples& stored, int width, int height, const std::vector<Code>& codes) {
  ASSERT_EQ(stored.channels().size(), 3U);
  std::size_t at = 0;
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(stored.value(i, j, c), static_cast<double>(codes[at++]));
    }
  }
}

TEST(StoredSamples, KeepEveryCodeOf8Bits) {
  const TemporaryFolder folder;
  const auto codes = all_codes<std::uint8_t>(256);
  for (const char* name : {"a.png", "a.tif", "a.bmp", "a.tga"}) {
    write_image(folder / name, 64, 4, {"R", "G", "B"}, codes);
    const StoredSamples stored = stored_of(folder / name);
    SCOPED_TRACE(name);
    EXPECT_EQ(stored.bits(), 8);
    EXPECT_EQ(stored.bytes(), 256U * 3);
    EXPECT_EQ(stored.channels(), (std::vector<std::string>{"R", "G", "B"}));
    expect_kept(stored, 64, 4, codes);
    EXPECT_EQ(stored.text(3, 1), "67 188 213");
  }
}

TEST(StoredSamples, KeepEveryCodeOf16Bits) {
  const TemporaryFolder folder;
  const auto codes = all_codes<std::uint16_t>(65536);
  for (const char* name : {"a.png", "a.tif"}) {
    write_image(folder / name, 256, 256, {"R", "G", "B"}, codes);
    const StoredSamples stored = stored_of(folder / name);
    SCOPED_TRACE(name);
    EXPECT_EQ(stored.bits(), 16);
    EXPECT_EQ(stored.bytes(), 65536U * 6);
    expect_kept(stored, 256, 256, codes);
  }
}

TEST(StoredSamples, KeepEveryCodeOfSignedIntegers) {
  const TemporaryFolder folder;
  std::vector<std::int16_t> codes;
  for (int k = -32768; k <= 32767; ++k) {
    for (const int code : {k, -1 - k, k ^ 0x55}) codes.push_back(static_cast<std::int16_t>(code));
  }
  write_image(folder / "a.tif", 256, 256, {"R", "G", "B"}, codes);
  expect_kept(stored_of(folder / "a.tif"), 256, 256, codes);
  const std::vector<char> bytes = {-128, -127, -1, 0, 1, 127};
  write_image(folder / "b.tif", 2, 1, {"R", "G", "B"}, bytes);
  const StoredSamples stored = stored_of(folder / "b.tif");
  expect_kept(stored, 2, 1, bytes);
  EXPECT_EQ(stored.text(0, 0), "-128 -127 -1");
}

TEST(StoredSamples, KeepTheCodesOfFewerBitsThanTheirBytesHave) {
  const TemporaryFolder folder;
  std::vector<std::uint16_t> codes(3 * 1024);
  std::iota(codes.begin(), codes.end(), std::uint16_t{0});
  for (auto& code : codes) code = static_cast<std::uint16_t>(code % 1024);
  std::vector<std::uint16_t> wide = codes;
  for (auto& code : wide) code = static_cast<std::uint16_t>(code << 6U | code >> 4U);
  OIIO::ImageSpec ten_bits;
  ten_bits.attribute("oiio:BitsPerSample", 10);
  write_image(folder / "a.tif", 32, 32, {"R", "G", "B"}, wide, ten_bits);
  const StoredSamples stored = stored_of(folder / "a.tif");
  ASSERT_EQ(stored.bits(), 10);
  expect_kept(stored, 32, 32, codes);
}

TEST(StoredSamples, KeepFloatsAsTheyAre) {
  const TemporaryFolder folder;
  const std::vector<float> values = {0.125F, -0.5F, 0.99F, 0.1F, 1e-9F, 123456.0F};
  write_image(folder / "a.exr", 2, 1, {"R", "G", "B"}, values);
  const StoredSamples stored = stored_of(folder / "a.exr");
  EXPECT_EQ(stored.bits(), 32);
  expect_kept(stored, 2, 1, values);
  EXPECT_EQ(stored.text(0, 0), "0.125 -0.5 0.99");
  EXPECT_EQ(stored.text(1, 0), "0.1 1e-09 1.235e+05");
}

TEST(StoredSamples, AreOfTheFileAndNotOfWhatIsMadeOfIt) {
  const TemporaryFolder folder;
  write_image(folder / "normals.png", 2, 1, {"R", "G", "B"}, std::vector<std::uint8_t>{94, 93, 247, 128, 127, 255});
  EXPECT_EQ(stored_of(folder / "normals.png", with_green(GreenDirection::down)).text(0, 0), "94 93 247");
  write_image(folder / "heights.png", 2, 2, {"Y"}, std::vector<std::uint16_t>{0, 1, 40000, 65535});
  const StoredSamples heights = stored_of(folder / "heights.png", as_height(10));
  EXPECT_EQ(heights.channels().size(), 1U);
  EXPECT_EQ(heights.text(1, 0), "1");
  EXPECT_EQ(heights.text(0, 1), "40000");
}

TEST(StoredSamples, OfAFileThatIsTooLargeAreNotKept) {
  ImageInfo info;
  info.width = info.height = 16384;
  info.channels = {"R", "G", "B"};
  info.block_rows = 1;
  StoredSamples stored(info, std::vector{0, 1, 2});  // 768 MiB
  EXPECT_TRUE(stored.empty());
  EXPECT_TRUE(stored.too_large());
  stored.keep({0, 1, {}});
  EXPECT_EQ(stored.text(0, 0), "not kept: the file is too large");
  EXPECT_TRUE(StoredSamples(info, std::vector{0}).bytes() == StoredSamples::k_most_bytes);
  info.bits = 16;
  EXPECT_TRUE(StoredSamples(info, std::vector{0}).too_large());
  EXPECT_TRUE(StoredSamples().empty());
  EXPECT_FALSE(StoredSamples().too_large());
}

}  // namespace
}  // namespace glint::test
