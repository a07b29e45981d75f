#include "gui/dialogs/file_preview.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/document/preset.h"
#include "core/image/png_file.h"
#include "tests/temporary_folder.h"

namespace glint::gui {
namespace {

namespace fs = std::filesystem;

FilePreview preview_now(const fs::path& file) {
  JobControl control;
  return preview_of(file, 200, control);
}

std::string fact(const FilePreview& preview, std::string_view caption) {
  for (const FilePreview::Fact& one : preview.facts) {
    if (one.caption == caption) return one.value;
  }
  return {};
}

TEST(FilePreview, IsNoLargerThanAskedForAndKeepsTheColours) {
  const test::TemporaryFolder folder;
  std::vector<std::uint8_t> pixels;
  for (int k = 0; k < 1000 * 300; ++k) {
    for (const int value : {200, 100, 50}) pixels.push_back(static_cast<std::uint8_t>(value));
  }
  ASSERT_TRUE(write_png_8(folder / "a.png", 1000, 300, pixels));
  const FilePreview preview = preview_now(folder / "a.png");
  EXPECT_EQ(preview.size, glm::ivec2(200, 60));
  ASSERT_EQ(preview.rgba.size(), 200U * 60 * 4);
  EXPECT_EQ((std::vector<std::uint8_t>(preview.rgba.end() - 4, preview.rgba.end())),
            (std::vector<std::uint8_t>{200, 100, 50, 255}));
  EXPECT_EQ(fact(preview, "Size"), "1000 × 300");
  EXPECT_EQ(fact(preview, "Stored as"), "8 bit, PNG");
}

TEST(FilePreview, SaysWhyThereIsNone) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.png", "no picture");
  const FilePreview preview = preview_now(folder / "a.png");
  EXPECT_TRUE(preview.rgba.empty());
  EXPECT_TRUE(preview.reason.starts_with("No preview: ")) << preview.reason;
}

TEST(FilePreview, OfAPresetTellsItsFields) {
  const test::TemporaryFolder folder;
  Document document;
  document.name = "brushed";
  ASSERT_TRUE(save_preset(folder / "a.json", document));
  const FilePreview preview = preview_now(folder / "a.json");
  EXPECT_EQ(fact(preview, "Name"), "brushed");
  EXPECT_EQ(fact(preview, "Surface"), "generated scratches");
  EXPECT_EQ(preview.reason, "");
  test::write_text(folder / "b.json", "{\"glintscope\": 3}");
  EXPECT_TRUE(preview_now(folder / "b.json").reason.starts_with("This preset cannot be opened: b.json:1:"));
}

TEST(FilePreview, TheNewestSelectionWins) {
  const test::TemporaryFolder folder;
  const std::vector<std::uint8_t> pixels(std::size_t{16} * 16 * 3, 255);
  ASSERT_TRUE(write_png_8(folder / "a.png", 16, 16, pixels));
  ASSERT_TRUE(write_png_8(folder / "b.png", 8, 8, pixels));
  FilePreviews previews({});
  for (int k = 0; k < 50; ++k) previews.want(folder / (k % 2 == 0 ? "a.png" : "b.png"), 200);
  while (!previews.idle()) std::this_thread::yield();
  ASSERT_TRUE(previews.current());
  EXPECT_EQ(previews.current()->size, glm::ivec2(8, 8));
  previews.forget();
  EXPECT_FALSE(previews.current());
}

}  // namespace
}  // namespace glint::gui
