#pragma once
// P-NDF images as OpenEXR: one part, float channels D.<method> (and D.<method>.error where a method gives one), the
// recipe of the document in the metadata. Row 0 holds the largest t, column 0 the smallest s.

#include <filesystem>
#include <span>
#include <string>

#include "core/math/result.h"
#include "core/pndf/pndf_grid.h"

namespace glint {

struct NamedPndfImage {
  std::string method;
  const PndfImage* image;
};

/// Writes images of one grid, in the order given; all or nothing. Equal inputs give equal bytes.
Status write_pndf_exr(const std::filesystem::path& path, std::span<const NamedPndfImage> images,
                      const std::string& recipe);

/// The text of the attribute glintscope:recipe of an EXR.
Result<std::string> read_recipe(const std::filesystem::path& path);

}  // namespace glint
