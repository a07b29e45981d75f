#include "core/image/normal_map_writer.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "core/image/atomic_file.h"
#include "core/image/quiet_stderr.h"

namespace glint {

Status write_normal_map(const std::filesystem::path& path, const NormalMap& map) {
  const bool png = path.extension() == ".png";
  if (!png && path.extension() != ".exr") {
    return request_error(path.string(), "normal maps are written as .exr or .png");
  }
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  const OIIO::TypeDesc type = png ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::FLOAT;
  OIIO::ImageSpec spec(map.width(), map.height(), 3, type);
  spec.attribute("Software", "Glintscope");
  spec.attribute("DateTime", "1970:01:01 00:00:00");  // equal maps give equal bytes
  spec.attribute("compression", "zip");

  std::vector<float> pixels;
  pixels.reserve(map.normals().size() * 3);
  for (const glm::vec2& normal : map.normals()) {
    const double s = static_cast<double>(normal.x);
    const double t = static_cast<double>(normal.y);
    const double z = std::sqrt(std::max(0.0, 1 - s * s - t * t));
    for (const double component : {s, t, z}) {
      pixels.push_back(static_cast<float>(png ? 0.5 * component + 0.5 : component));
    }
  }
  {
    const QuietStderr quiet;
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(png ? "png" : "openexr");
    if (!output || !output->open(file->temporary().string(), spec) ||
        !output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) || !output->close()) {
      const std::string cause = output ? output->geterror() : OIIO::geterror();
      return content_error(path.string(), "cannot be written: " + cause);
    }
  }
  return file->commit();
}

}  // namespace glint
