#pragma once
// Which channels of a file mean what. Names settle the order; what the values do (constant, equal, varying) settles the
// layout, so it takes a first look at every pixel.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/image/image_file.h"

namespace glint {

/// The channels to look at, as indices into ImageInfo::channels.
struct ChannelChoice {
  std::vector<int> colors;   ///< one (a luminance), two (x, y) or three (x, y, z)
  std::optional<int> alpha;  ///< the alpha channel, or an unnamed fourth
  bool by_name = false;      ///< found by a known set of names, not by order

  /// colors, then alpha: what is read.
  [[nodiscard]] std::vector<int> all() const;
};

/// By name in any case (N.X N.Y N.Z, nx ny nz, X Y Z, R G B; then the same sets without their third), else by order.
/// Sets that can only mean a normal come first, so a render with colours and normals gives its normals.
ChannelChoice choose_channels(const ImageInfo& info);

/// What one channel holds. Only finite values count for the range.
struct ChannelStatistics {
  double least = 0;
  double greatest = 0;
  std::size_t finite = 0;
  std::size_t not_finite = 0;

  [[nodiscard]] bool varies() const { return least < greatest; }
};

/// What the first look at every pixel found; `channels` in the order of ChannelChoice::all().
struct ImageStatistics {
  std::vector<ChannelStatistics> channels;
  bool colors_equal = true;      ///< all colour channels of every texel hold the same value
  double level_step = 0;         ///< smallest difference between two values that occur in x or y; integers only
  std::array<double, 2> median;  ///< of the first two colour channels, to 1/1024; values outside [0, 1] count as 0 or 1
  double signed_length_error = 0;    ///< mean | |v| - 1 | of three channels taken as they stand, finite ones
  double unsigned_length_error = 0;  ///< likewise taken as 2c - 1
};

/// Reads the file once. The second value is what the decoder remarked although it went on.
struct SurveyedImage {
  ImageStatistics statistics;
  std::string remark;
};
Result<SurveyedImage> survey_image(const ImageInfo& info, const ChannelChoice& choice, JobControl& control);

enum class Layout {
  vector,           ///< three channels, normalised
  two_channel,      ///< (s, t) in two channels, z rebuilt
  luminance_alpha,  ///< the same in luminance and alpha
  blue_constant,    ///< three channels of which the third says nothing: z rebuilt
  dxt5nm,           ///< x in alpha, y in green, z rebuilt
  height,           ///< one varying channel, or all equal
  constant_grey,    ///< one value everywhere
};

/// The row of the conventions' table that this file falls under.
Layout settle_layout(const ChannelChoice& choice, const ImageStatistics& statistics);

}  // namespace glint
