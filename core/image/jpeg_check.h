#pragma once
// A JPEG that was cut short decodes without an error: the decoder fills what is missing with grey. The end-of-image
// marker tells.

#include <filesystem>

namespace glint {

/// Walks the marker segments and the entropy-coded data of a JPEG file; true when the end-of-image marker is reached.
/// False as well for a file that cannot be opened. Does not decode, and does not judge damage before the end.
bool jpeg_reaches_its_end(const std::filesystem::path& path);

}  // namespace glint
