#include "core/image/header_check.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <string>

namespace glint {
namespace {

using namespace std::string_view_literals;

std::uint32_t byte_at(std::string_view head, std::size_t k) {
  return static_cast<unsigned char>(head[k]);
}

std::uint32_t little_endian_16(std::string_view head, std::size_t k) {
  return byte_at(head, k) | byte_at(head, k + 1) << 8;
}

std::uint32_t little_endian_32(std::string_view head, std::size_t k) {
  return little_endian_16(head, k) | little_endian_16(head, k + 2) << 16;
}

std::uint32_t big_endian_32(std::string_view head, std::size_t k) {
  return byte_at(head, k) << 24 | byte_at(head, k + 1) << 16 | byte_at(head, k + 2) << 8 | byte_at(head, k + 3);
}

// Walks the chunks of a PNG; false where the file ends inside one. (When it meets the end of the file itself,
// OpenImageIO 2.4 loses some memory: libpng jumps out of the callback that reports it.)
bool png_chunks_are_whole(const std::filesystem::path& path, std::uintmax_t bytes) {
  std::ifstream file(path, std::ios::binary);
  std::uintmax_t position = 8;
  std::array<char, 8> start{};
  while (position < bytes) {
    file.seekg(static_cast<std::streamoff>(position));
    if (!file.read(start.data(), start.size())) return false;
    const std::string_view chunk(start.data(), start.size());
    position += 12 + std::uintmax_t{big_endian_32(chunk, 0)};
    if (chunk.substr(4) == "IEND") break;
  }
  return position <= bytes;
}

// libpng refuses some headers without naming the size, so the size is taken from the IHDR chunk directly.
Status check_png(const std::filesystem::path& path, std::string_view head, std::uintmax_t bytes) {
  if (head.size() < 33 || head.substr(12, 4) != "IHDR") {
    return content_error(path.string(), "is a PNG file whose header is damaged or cut short");
  }
  if (Status fits = check_map_size(path, big_endian_32(head, 16), big_endian_32(head, 20)); !fits) return fits;
  if (!png_chunks_are_whole(path, bytes)) {
    return content_error(path.string(), "is a PNG file that is cut short or damaged: it ends inside a chunk");
  }
  return success();
}

// TGA has no signature, so the header must make sense. A run of the packed kind holds at most 128 texels.
Status check_targa(const std::filesystem::path& path, std::string_view head, std::uintmax_t bytes) {
  if (head.size() < 18) return content_error(path.string(), "is too short to be a TGA file");
  const std::uint32_t color_map = byte_at(head, 1);
  const std::uint32_t type = byte_at(head, 2);
  const std::uint32_t bits = byte_at(head, 16);
  const bool known_type = "\x01\x02\x03\x09\x0a\x0b"sv.find(head[2]) != std::string_view::npos;
  const bool known_bits = bits == 8 || bits == 15 || bits == 16 || bits == 24 || bits == 32;
  if (color_map > 1 || !known_type || !known_bits) {
    return content_error(path.string(), "is named like a TGA file but does not begin like one");
  }
  const std::uint64_t texels = std::uint64_t{little_endian_16(head, 12)} * little_endian_16(head, 14);
  const std::uint64_t texel_bytes = (bits + 7) / 8;
  const std::uint64_t color_map_bytes =
      color_map == 1 ? std::uint64_t{little_endian_16(head, 5)} * ((byte_at(head, 7) + 7) / 8) : 0;
  const std::uint64_t needed = type < 8 ? texels * texel_bytes : (texels + 127) / 128 * (1 + texel_bytes);
  if (bytes < 18 + byte_at(head, 0) + color_map_bytes + needed) {
    return content_error(path.string(), "is cut short: a TGA file of its size is longer");
  }
  return check_map_size(path, little_endian_16(head, 12), little_endian_16(head, 14));
}

// OpenImageIO 2.4 searches a channel mask for its lowest bit without end when there is none.
Status check_dds(const std::filesystem::path& path, std::string_view head) {
  constexpr std::uint32_t k_has_alpha = 0x1;
  constexpr std::uint32_t k_compressed = 0x4;
  constexpr std::uint32_t k_luminance = 0x20000;
  if (head.size() < 128) return content_error(path.string(), "is a DDS file whose header is cut short");
  const std::uint32_t flags = little_endian_32(head, 80);
  const auto mask_missing = [&](std::size_t channel) { return little_endian_32(head, 92 + 4 * channel) == 0; };
  const bool color_missing = mask_missing(0) || ((flags & k_luminance) == 0 && (mask_missing(1) || mask_missing(2)));
  const bool alpha_missing = (flags & k_has_alpha) != 0 && mask_missing(3);
  if ((flags & k_compressed) == 0 && (color_missing || alpha_missing)) {
    return content_error(path.string(), "is a DDS file whose header does not say where its channels are");
  }
  return check_map_size(path, little_endian_32(head, 16), little_endian_32(head, 12));
}

struct ExrAttribute {
  std::string name;
  std::string start;         // the first bytes of its value, as many as it has and are of interest
  std::uint64_t bytes = 0;   // of its value
  bool ends_header = false;  // not an attribute but the end of their list
};

// The attribute at the reading position, which moves behind it; nothing where the file ends or names run wild.
std::optional<ExrAttribute> next_exr_attribute(std::ifstream& file) {
  const auto read_name = [&]() -> std::optional<std::string> {
    std::string name;
    for (int c = file.get(); c != 0; c = file.get()) {
      if (c == std::ifstream::traits_type::eof() || name.size() > 255) return std::nullopt;
      name.push_back(static_cast<char>(c));
    }
    return name;
  };
  ExrAttribute attribute;
  const std::optional<std::string> name = read_name();
  if (!name) return std::nullopt;
  attribute.name = *name;
  if (name->empty()) return attribute.ends_header = true, attribute;
  std::array<char, 4> size{};
  if (!read_name() || !file.read(size.data(), size.size())) return std::nullopt;
  attribute.bytes = little_endian_32({size.data(), size.size()}, 0);
  attribute.start.resize(std::min<std::uint64_t>(attribute.bytes, 16));
  if (!file.read(attribute.start.data(), static_cast<std::streamsize>(attribute.start.size()))) return std::nullopt;
  file.seekg(static_cast<std::streamoff>(attribute.bytes - attribute.start.size()), std::ios::cur);
  return attribute;
}

// OpenEXR allocates what an attribute's size or a table of tiles asks for before it meets the end of the file.
Status check_openexr(const std::filesystem::path& path, std::uintmax_t bytes) {
  const Error damaged = content_error(path.string(), "is an OpenEXR file whose header is damaged or cut short");
  std::ifstream file(path, std::ios::binary);
  file.seekg(8);
  std::int64_t width = 0;
  std::int64_t height = 0;
  std::int64_t tile_width = 0;
  std::int64_t tile_height = 0;
  while (true) {  // ends with the header or the file, whose attributes each take some bytes
    const std::optional<ExrAttribute> attribute = next_exr_attribute(file);
    if (!attribute || attribute->bytes > bytes) return damaged;
    if (attribute->ends_header) break;
    if (attribute->name == "dataWindow" && attribute->start.size() == 16) {
      const auto corner = [&](std::size_t k) {
        return std::int64_t{static_cast<std::int32_t>(little_endian_32(attribute->start, 4 * k))};
      };
      width = corner(2) - corner(0) + 1;
      height = corner(3) - corner(1) + 1;
    }
    if (attribute->name == "tiles" && attribute->start.size() >= 8) {
      tile_width = little_endian_32(attribute->start, 0);
      tile_height = little_endian_32(attribute->start, 4);
    }
  }
  if (const Status fits = check_map_size(path, width, height); !fits) return fits.error();
  if (tile_width > 0 && tile_height > 0) {
    const std::int64_t tiles = ((width + tile_width - 1) / tile_width) * ((height + tile_height - 1) / tile_height);
    if (static_cast<std::uint64_t>(tiles) > bytes / 8) return damaged;  // the table of tiles has 8 bytes each
  }
  return success();
}

}  // namespace

Status check_header(const std::filesystem::path& path, ImageFormat format, std::string_view head,
                    std::uintmax_t bytes) {
  switch (format) {
    case ImageFormat::png:
      return check_png(path, head, bytes);
    case ImageFormat::openexr:
      return check_openexr(path, bytes);
    case ImageFormat::dds:
      return check_dds(path, head);
    case ImageFormat::targa:
      return check_targa(path, head, bytes);
    case ImageFormat::jpeg:
    case ImageFormat::tiff:
    case ImageFormat::radiance:
    case ImageFormat::pnm:
    case ImageFormat::bmp:
    case ImageFormat::webp:
      break;
  }
  return success();
}

}  // namespace glint
