#pragma once
// Which picture format a file holds, told by its first bytes and never by its name alone (TGA, which has no signature,
// needs both), and the largest size that is decoded.

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/math/result.h"

namespace glint {

enum class ImageFormat { png, jpeg, openexr, tiff, radiance, pnm, bmp, dds, webp, targa };

struct RecognisedFile {
  ImageFormat format;
  std::uintmax_t bytes;  ///< size of the file
};

/// Reads the head of `path`. Errors: no such file, not a regular file, empty, unreadable, none of the formats read
/// here, a header that contradicts the file's own length, or (PNG) a size that is zero or too large.
Result<RecognisedFile> recognise_file(const std::filesystem::path& path);

/// "PNG", "OpenEXR", …
std::string format_title(ImageFormat format);

/// Refuses sizes of zero, sides above k_largest_map_side, and maps that with their pyramid would exceed 2 GiB; the
/// sentence names the size. To be asked before anything of that size is allocated.
Status check_map_size(const std::filesystem::path& path, std::int64_t width, std::int64_t height);

}  // namespace glint
