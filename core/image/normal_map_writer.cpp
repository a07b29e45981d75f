#include "core/image/normal_map_writer.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "core/image/atomic_file.h"
#include "core/image/png_file.h"
#include "core/image/quiet_stderr.h"

namespace glint {
namespace {

// Unit normals as three channels, each times `scale` plus `offset`.
std::vector<float> channels_of(const NormalMap& map, double scale, double offset) {
  std::vector<float> channels;
  channels.reserve(map.normals().size() * 3);
  for (const glm::vec2& normal : map.normals()) {
    const auto s = static_cast<double>(normal.x);
    const auto t = static_cast<double>(normal.y);
    const double z = std::sqrt(std::max(0.0, 1 - s * s - t * t));
    for (const double component : {s, t, z}) channels.push_back(static_cast<float>(scale * component + offset));
  }
  return channels;
}

Status write_exr(const std::filesystem::path& path, const NormalMap& map) {
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  OIIO::ImageSpec spec(map.width(), map.height(), 3, OIIO::TypeDesc::FLOAT);
  spec.attribute("Software", "Glintscope");
  spec.attribute("DateTime", "1970:01:01 00:00:00");  // equal maps give equal bytes
  spec.attribute("compression", "zip");
  const std::vector<float> channels = channels_of(map, 1, 0);
  {
    const QuietStderr quiet;
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("openexr");
    if (!output || !output->open(file->temporary().string(), spec) ||
        !output->write_image(OIIO::TypeDesc::FLOAT, channels.data()) || !output->close()) {
      const std::string cause = output ? output->geterror() : OIIO::geterror();
      return content_error(path.string(), "cannot be written: " + cause);
    }
  }
  return file->commit();
}

}  // namespace

Status write_normal_map(const std::filesystem::path& path, const NormalMap& map) {
  if (path.extension() == ".exr") return write_exr(path, map);
  if (path.extension() == ".png") return write_png_16(path, map.width(), map.height(), channels_of(map, 0.5, 0.5));
  return request_error(path.string(), "normal maps are written as .exr or .png");
}

}  // namespace glint
