#include "core/image/file_format.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "core/image/header_check.h"
#include "core/surface/normal_map.h"

namespace glint {
namespace {

using namespace std::string_view_literals;

// A texel of the map, and its share of the min-max pyramid built over it.
constexpr double k_bytes_per_texel = 8 * 1.14;
constexpr double k_largest_map_bytes = 2.0 * 1024 * 1024 * 1024;

std::optional<ImageFormat> format_by_signature(std::string_view head) {
  struct Signature {
    std::string_view bytes;
    ImageFormat format;
  };
  constexpr std::array k_signatures{
      Signature{"\x89PNG\r\n\x1a\n"sv, ImageFormat::png},
      Signature{"\xff\xd8\xff"sv, ImageFormat::jpeg},
      Signature{"\x76\x2f\x31\x01"sv, ImageFormat::openexr},
      Signature{"II*\0"sv, ImageFormat::tiff},
      Signature{"MM\0*"sv, ImageFormat::tiff},
      Signature{"II+\0"sv, ImageFormat::tiff},
      Signature{"MM\0+"sv, ImageFormat::tiff},
      Signature{"#?"sv, ImageFormat::radiance},
      Signature{"DDS "sv, ImageFormat::dds},
      Signature{"BM"sv, ImageFormat::bmp},
  };
  for (const Signature& signature : k_signatures) {
    if (head.starts_with(signature.bytes)) return signature.format;
  }
  if (head.size() >= 12 && head.starts_with("RIFF") && head.substr(8, 4) == "WEBP") return ImageFormat::webp;
  const bool pnm = head.size() >= 3 && head[0] == 'P' && "123456Ff"sv.find(head[1]) != std::string_view::npos &&
                   std::isspace(static_cast<unsigned char>(head[2])) != 0;
  if (pnm) return ImageFormat::pnm;
  return std::nullopt;
}

bool has_targa_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return extension == ".tga" || extension == ".tpic";
}

bool has_targa_footer(std::ifstream& file, std::uintmax_t bytes) {
  constexpr std::string_view k_footer = "TRUEVISION-XFILE.\0"sv;
  if (bytes < 18 + k_footer.size()) return false;
  std::array<char, k_footer.size()> tail{};
  file.clear();
  file.seekg(-static_cast<std::streamoff>(tail.size()), std::ios::end);
  return file.read(tail.data(), tail.size()) && std::string_view(tail.data(), tail.size()) == k_footer;
}

Result<std::uintmax_t> size_of_regular_file(const std::filesystem::path& path) {
  std::error_code failure;
  const std::filesystem::file_status status = std::filesystem::status(path, failure);
  if (status.type() == std::filesystem::file_type::not_found) return content_error(path.string(), "no such file");
  if (failure) return content_error(path.string(), fmt::format("cannot be opened: {}", failure.message()));
  if (std::filesystem::is_directory(status)) return content_error(path.string(), "is a directory, not an image file");
  if (!std::filesystem::is_regular_file(status)) return content_error(path.string(), "is not a regular file");
  const std::uintmax_t bytes = std::filesystem::file_size(path, failure);
  if (failure) return content_error(path.string(), fmt::format("cannot be opened: {}", failure.message()));
  if (bytes == 0) return content_error(path.string(), "is empty (0 bytes)");
  return bytes;
}

}  // namespace

Result<RecognisedFile> recognise_file(const std::filesystem::path& path) {
  const Result<std::uintmax_t> bytes = size_of_regular_file(path);
  if (!bytes) return bytes.error();
  std::ifstream file(path, std::ios::binary);
  if (!file) return content_error(path.string(), "cannot be opened for reading");
  std::array<char, k_header_bytes> buffer{};
  file.read(buffer.data(), buffer.size());
  const std::string_view head(buffer.data(), static_cast<std::size_t>(file.gcount()));

  std::optional<ImageFormat> format = format_by_signature(head);
  if (!format && (has_targa_extension(path) || has_targa_footer(file, *bytes))) format = ImageFormat::targa;
  if (format) {
    if (const Status sound = check_header(path, *format, head, *bytes); !sound) return sound.error();
    return RecognisedFile{*format, *bytes};
  }
  return content_error(path.string(),
                       "is none of the image formats read here (PNG, JPEG, OpenEXR, TIFF, Radiance HDR, PNM and PFM, "
                       "BMP, DDS, WebP, TGA)");
}

std::string format_title(ImageFormat format) {
  switch (format) {
    case ImageFormat::png:
      return "PNG";
    case ImageFormat::jpeg:
      return "JPEG";
    case ImageFormat::openexr:
      return "OpenEXR";
    case ImageFormat::tiff:
      return "TIFF";
    case ImageFormat::radiance:
      return "Radiance HDR";
    case ImageFormat::pnm:
      return "PNM";
    case ImageFormat::bmp:
      return "BMP";
    case ImageFormat::dds:
      return "DDS";
    case ImageFormat::webp:
      return "WebP";
    case ImageFormat::targa:
      break;
  }
  return "TGA";
}

Status check_map_size(const std::filesystem::path& path, std::int64_t width, std::int64_t height) {
  const std::string size = fmt::format("{} x {}", width, height);
  if (width <= 0 || height <= 0) return content_error(path.string(), fmt::format("its size of {} is zero", size));
  if (width > k_largest_map_side || height > k_largest_map_side) {
    return content_error(path.string(), fmt::format("its size of {} is too large: at most {} texels a side are read",
                                                    size, k_largest_map_side));
  }
  const double bytes = k_bytes_per_texel * static_cast<double>(width) * static_cast<double>(height);
  if (bytes > k_largest_map_bytes) {
    return content_error(path.string(),
                         fmt::format("its size of {} is too large: the map would need {:.1f} GiB, more than the 2 GiB "
                                     "allowed",
                                     size, bytes / (1024.0 * 1024 * 1024)));
  }
  return success();
}

}  // namespace glint
