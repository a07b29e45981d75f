#pragma once
// What a header must not say, looked at before a decoder sees it: some decoders hang on a header that contradicts
// itself, some allocate what it asks for before they find the file too short.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "core/image/file_format.h"
#include "core/math/result.h"

namespace glint {

/// The longest head that check_header asks for, in bytes.
inline constexpr std::size_t k_header_bytes = 128;

/// Checks the header of a file of `bytes` bytes that begins with `head` (shorter only where the file is). Size limits
/// are those of check_map_size. A success promises nothing about formats and fields that make no trouble.
Status check_header(const std::filesystem::path& path, ImageFormat format, std::string_view head, std::uintmax_t bytes);

}  // namespace glint
