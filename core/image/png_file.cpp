#include "core/image/png_file.h"

#include <string_view>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "core/image/atomic_file.h"
#include "core/image/quiet_stderr.h"

namespace glint {
namespace {

Status write_png(const std::filesystem::path& path, int width, int height, const OIIO::TypeDesc& stored,
                 const OIIO::TypeDesc& given, const void* pixels) {
  OIIO::ImageSpec spec(width, height, 3, stored);
  spec.attribute("Software", "Glintscope");
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  {
    const QuietStderr quiet;
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("png");
    if (!output || !output->set_ioproxy(&memory) || !output->open("picture.png", spec) ||
        !output->write_image(given, pixels) || !output->close()) {
      const std::string cause = output ? output->geterror() : OIIO::geterror();
      return content_error(path.string(), "cannot be written: " + cause);
    }
  }
  return write_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace

Status write_png_8(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> rgb) {
  return write_png(path, width, height, OIIO::TypeDesc::UINT8, OIIO::TypeDesc::UINT8, rgb.data());
}

Status write_png_16(const std::filesystem::path& path, int width, int height, std::span<const float> rgb) {
  return write_png(path, width, height, OIIO::TypeDesc::UINT16, OIIO::TypeDesc::FLOAT, rgb.data());
}

}  // namespace glint
