#pragma once
// What the tests of reading share: small files written through OpenImageIO, and a map or a sentence read back.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "core/image/normal_map_reader.h"

namespace glint::test {

/// Writes `values`, width x height texels of as many values as there are names, in the file's own type (that of Value).
template <class Value>
void write_image(const std::filesystem::path& path, int width, int height, const std::vector<std::string>& names,
                 const std::vector<Value>& values, OIIO::ImageSpec extra = {}) {
  OIIO::ImageSpec spec = extra;
  spec.width = spec.full_width = width;
  spec.height = spec.full_height = height;
  spec.nchannels = static_cast<int>(names.size());
  spec.channelnames = names;
  spec.alpha_channel = -1;
  for (std::size_t c = 0; c < names.size(); ++c) {
    if (names[c] == "A") spec.alpha_channel = static_cast<int>(c);
  }
  spec.set_format(OIIO::BaseTypeFromC<Value>::value);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  const auto output = OIIO::ImageOutput::create(path.string());
  ASSERT_TRUE(output) << path;
  ASSERT_EQ(values.size(), names.size() * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  ASSERT_TRUE(output->open(path.string(), spec)) << output->geterror();
  ASSERT_TRUE(output->write_image(OIIO::BaseTypeFromC<Value>::value, values.data())) << output->geterror();
  ASSERT_TRUE(output->close());
}

/// The file as a map; where it is refused the test fails and a map of a single (9, 9) stands in.
inline ReadNormalMap read(const std::filesystem::path& path, const ReadOptions& options = {}) {
  JobControl control;
  Result<ReadNormalMap> result = read_normal_map(path, options, control);
  if (result) return std::move(result).value();
  ADD_FAILURE() << result.error().message();
  return {NormalMap(1, 1, {{9, 9}}, Wrap::repeat), {}};
}

/// Why the file is refused; the test fails if it is read.
inline Error refusal(const std::filesystem::path& path, const ReadOptions& options = {}) {
  JobControl control;
  const Result<ReadNormalMap> result = read_normal_map(path, options, control);
  if (!result) return result.error();
  ADD_FAILURE() << path << " was read";
  return {};
}

inline ReadOptions as_height(double scale) {
  ReadOptions options;
  options.height_scale = scale;
  return options;
}

inline ReadOptions with_green(GreenDirection green) {
  ReadOptions options;
  options.green = green;
  return options;
}

/// All sentences of a report, one a line.
inline std::string text_of(const ReadReport& report) {
  std::string text;
  for (const ReadReport::Note& note : report.notes) text += note.sentence + "\n";
  return text;
}

inline bool warns_of(const ReadReport& report, std::string_view what) {
  for (const ReadReport::Note& note : report.notes) {
    const bool found = note.sentence.find(what) != std::string::npos;
    if (found && note.severity == ReadReport::Severity::warning) return true;
  }
  return false;
}

inline int warning_count(const ReadReport& report) {
  int count = 0;
  for (const ReadReport::Note& note : report.notes) count += note.severity == ReadReport::Severity::warning;
  return count;
}

/// The largest difference between two maps in s or t; infinite where their sizes differ.
inline double largest_difference(const NormalMap& a, const NormalMap& b) {
  if (a.width() != b.width() || a.height() != b.height()) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t k = 0; k < a.normals().size(); ++k) {
    const glm::dvec2 d = glm::dvec2(a.normals()[k]) - glm::dvec2(b.normals()[k]);
    largest = std::max({largest, std::abs(d.x), std::abs(d.y)});
  }
  return largest;
}

}  // namespace glint::test
