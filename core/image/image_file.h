#pragma once
// A picture file as a source of blocks of rows, so that no more than a block of undecoded pixels is ever in memory
// here. Only the first image of a file is read, in its full resolution and its data window alone. Stored values as they
// are: no gamma, no colour profile, no premultiplication; palettes are expanded.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/image/file_format.h"
#include "core/math/parallel.h"
#include "core/math/result.h"

namespace glint {

enum class SampleKind {
  unsigned_integer,  ///< delivered in [0, 1]
  signed_integer,    ///< delivered in [-1, 1]
  floating,          ///< delivered as it stands
};

struct ImageInfo {
  std::filesystem::path path;
  ImageFormat format = ImageFormat::png;
  int width = 0;
  int height = 0;
  SampleKind kind = SampleKind::unsigned_integer;
  int bits = 8;                       ///< per sample, as stored
  std::vector<std::string> channels;  ///< names, in the order of the file
  int alpha_channel = -1;             ///< -1: none is marked as such
  int images = 1;                     ///< how many images the file holds, where its format says so
  int block_rows = 1;                 ///< rows that are decoded at a time
};

/// Tells the format by content, opens the file, checks its size and closes it again. Nothing of the image's size is
/// allocated here. Errors name file and cause.
Result<ImageInfo> inspect_image(const std::filesystem::path& path);

struct RowBlock {
  int first_row;
  int row_count;
  std::span<const float> samples;  ///< rows from the top, texels from the left, the channels asked for interleaved
};

/// How many blocks read_rows will deliver.
std::size_t row_block_count(const ImageInfo& info);

/// Hands every row of the image to `body`, from the top, with the channels of those indices. Each block is one step of
/// `control`, which is asked before each. The value is what the decoder remarked although it went on; empty if nothing.
Result<std::string> read_rows(const ImageInfo& info, std::span<const int> channels, JobControl& control,
                              const std::function<void(const RowBlock&)>& body);

}  // namespace glint
