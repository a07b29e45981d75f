#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "core/math/result.h"

namespace glint {

/// Writes three channels of display values, rows from the top; all or nothing. The picture is encoded in memory first:
/// libpng reports success for a file that a full disk cut short. Equal pixels give equal bytes.
Status write_png_8(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> rgb);

/// Writes three channels in [0, 1] with 16 bits each; otherwise the same.
Status write_png_16(const std::filesystem::path& path, int width, int height, std::span<const float> rgb);

}  // namespace glint
