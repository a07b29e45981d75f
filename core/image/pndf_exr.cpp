#include "core/image/pndf_exr.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <glm/common.hpp>

#include "core/image/atomic_file.h"
#include "core/image/quiet_stderr.h"

namespace glint {
namespace {

struct Channel {
  std::string name;
  const std::vector<double>* values;
};

std::vector<Channel> channels_of(std::span<const NamedPndfImage> images) {
  std::vector<Channel> channels;
  for (const NamedPndfImage& named : images) {
    channels.push_back({"D." + named.method, &named.image->density});
    if (!named.image->standard_error.empty()) {
      channels.push_back({"D." + named.method + ".error", &named.image->standard_error});
    }
  }
  return channels;
}

}  // namespace

Status write_pndf_exr(const std::filesystem::path& path, std::span<const NamedPndfImage> images,
                      const std::string& recipe) {
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();

  const PndfGrid& grid = images.front().image->grid;
  glm::dvec2 widening{0, 0};  // of the methods that widen; binning counts in the cells themselves
  for (const NamedPndfImage& named : images) widening = glm::max(widening, named.image->widening);
  const std::vector<Channel> channels = channels_of(images);
  OIIO::ImageSpec spec(grid.columns, grid.rows, static_cast<int>(channels.size()), OIIO::TypeDesc::FLOAT);
  spec.channelnames.clear();
  for (const Channel& channel : channels) spec.channelnames.push_back(channel.name);
  spec.attribute("compression", "zip");
  spec.attribute("Software", "Glintscope");
  spec.attribute("DateTime", "1970:01:01 00:00:00");  // equal inputs give equal bytes
  spec.attribute("glintscope:recipe", recipe);
  // Shortest decimals that read back as the same doubles.
  spec.attribute("glintscope:window", fmt::format("{} {} {} {}", grid.s_min, grid.s_max, grid.t_min, grid.t_max));
  spec.attribute("glintscope:widening", fmt::format("{} {}", widening.x, widening.y));

  std::vector<float> pixels(grid.cells() * channels.size());
  for (std::size_t c = 0; c < channels.size(); ++c) {
    for (std::size_t k = 0; k < grid.cells(); ++k) {
      pixels[k * channels.size() + c] = static_cast<float>((*channels[c].values)[k]);
    }
  }
  {
    const QuietStderr quiet;
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("openexr");
    if (!output || !output->open(file->temporary().string(), spec) ||
        !output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) || !output->close()) {
      const std::string cause = output ? output->geterror() : OIIO::geterror();
      return content_error(path.string(), "cannot be written: " + cause);
    }
  }
  return file->commit();
}

Result<std::string> read_recipe(const std::filesystem::path& path) {
  const QuietStderr quiet;
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create("openexr");
  OIIO::ImageSpec spec;
  if (!input || !input->open(path.string(), spec)) {
    return content_error(path.string(), "is not an OpenEXR file that can be read");
  }
  const std::string recipe = spec.get_string_attribute("glintscope:recipe");
  if (recipe.empty()) return content_error(path.string(), "holds no recipe: only P-NDF images carry one");
  return recipe;
}

}  // namespace glint
