#pragma once

#include <filesystem>

#include "core/math/result.h"
#include "core/surface/normal_map.h"

namespace glint {

/// Writes unit normals: signed float R G B in .exr, 2c - 1 encoded in 16 bits a channel in .png (any other extension is
/// a request error). All or nothing; equal maps give equal bytes. Reading the file back gives the same floats (.exr: to
/// an ulp, for the reader normalises; .png: to the 16-bit step).
Status write_normal_map(const std::filesystem::path& path, const NormalMap& map);

}  // namespace glint
