#include "tests/gui/golden.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "core/image/png_file.h"

namespace glint::test {
namespace {

constexpr int k_noticed = 24;              // of 255, after the blur
constexpr double k_most_differing = 2e-4;  // share of the pixels: a word that is missing at 1280 x 720 is more

std::size_t at(const Picture& p, int x, int y, int channel) {
  return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(p.size.x) + static_cast<std::size_t>(x)) +
         static_cast<std::size_t>(channel);
}

// The mean of the 3 x 3 pixels round (x, y).
int blurred(const Picture& p, int x, int y, int channel) {
  int sum = 0;
  int count = 0;
  for (int b = std::max(0, y - 1); b <= std::min(p.size.y - 1, y + 1); ++b) {
    for (int a = std::max(0, x - 1); a <= std::min(p.size.x - 1, x + 1); ++a) {
      sum += p.rgb[at(p, a, b, channel)];
      ++count;
    }
  }
  return sum / count;
}

std::filesystem::path golden_file(const std::string& name) {
  return std::filesystem::path(GLINTSCOPE_SOURCE_DIR) / "tests" / "golden" / (name + ".png");
}

Picture load(const std::filesystem::path& file) {
  Picture picture;
  const auto input = OIIO::ImageInput::open(file.string());
  if (!input) return picture;
  picture.size = {input->spec().width, input->spec().height};
  picture.rgb.resize(3 * static_cast<std::size_t>(picture.size.x) * static_cast<std::size_t>(picture.size.y));
  input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, picture.rgb.data());
  return picture;
}

void save(const std::filesystem::path& file, const Picture& picture) {
  std::filesystem::create_directories(file.parent_path());
  const Status written = write_png_8(file, picture.size.x, picture.size.y, picture.rgb);
  ASSERT_TRUE(written) << written.error().message();
}

}  // namespace

PictureDifference compare_pictures(const Picture& a, const Picture& b) {
  PictureDifference difference;
  difference.map = a;
  std::size_t differing = 0;
  for (int y = 0; y < a.size.y; ++y) {
    for (int x = 0; x < a.size.x; ++x) {
      int apart = 0;
      for (int c = 0; c < 3; ++c) apart = std::max(apart, std::abs(blurred(a, x, y, c) - blurred(b, x, y, c)));
      difference.largest = std::max(difference.largest, apart);
      const bool seen = apart > k_noticed;
      differing += seen ? 1 : 0;
      constexpr std::array<std::uint8_t, 3> k_magenta = {255, 0, 255};
      for (int c = 0; c < 3; ++c) {
        std::uint8_t& value = difference.map.rgb[at(a, x, y, c)];
        value = seen ? k_magenta[static_cast<std::size_t>(c)] : static_cast<std::uint8_t>(value / 3);
      }
    }
  }
  difference.differing = static_cast<double>(differing) / (static_cast<double>(a.size.x) * a.size.y);
  return difference;
}

void cover_what_varies(Picture& picture, const view::WidgetRecord& widgets) {
  for (const auto& [name, entry] : widgets.entries()) {
    if (!entry.varies) continue;
    const int x0 = std::clamp(static_cast<int>(entry.area.min.x), 0, picture.size.x);
    const int x1 = std::clamp(static_cast<int>(entry.area.max.x) + 1, 0, picture.size.x);
    const int y0 = std::clamp(static_cast<int>(entry.area.min.y), 0, picture.size.y);
    const int y1 = std::clamp(static_cast<int>(entry.area.max.y) + 1, 0, picture.size.y);
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        for (int c = 0; c < 3; ++c) picture.rgb[at(picture, x, y, c)] = 64;
      }
    }
  }
}

void expect_golden(const std::string& name, const Picture& picture) {
  const std::filesystem::path file = golden_file(name);
  if (const char* renew = std::getenv("GLINTSCOPE_RENEW_GOLDEN"); renew && *renew != '\0' && *renew != '0') {
    save(file, picture);
    return;
  }
  const Picture golden = load(file);
  const std::filesystem::path folder = std::filesystem::path(GLINTSCOPE_BINARY_DIR) / "golden";
  if (golden.size != picture.size) {
    save(folder / (name + ".png"), picture);
    FAIL() << name << ": there is no golden picture of this size; look at " << folder / (name + ".png")
           << " and renew with GLINTSCOPE_RENEW_GOLDEN=1";
  }
  const PictureDifference difference = compare_pictures(golden, picture);
  if (difference.differing <= k_most_differing) return;
  save(folder / (name + ".png"), picture);
  save(folder / (name + ".difference.png"), difference.map);
  ADD_FAILURE() << name << ": " << 100 * difference.differing << " % of the pixels differ (at most "
                << 100 * k_most_differing << " %), by up to " << difference.largest << " of 255; look at "
                << folder / (name + ".png") << " and " << folder / (name + ".difference.png")
                << ". If it is right so: GLINTSCOPE_RENEW_GOLDEN=1 scripts/test -R Golden";
}

}  // namespace glint::test
