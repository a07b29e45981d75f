#include "core/image/image_file.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <string_view>
#include <utility>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "core/image/quiet_stderr.h"

namespace glint {
namespace {

using InputPointer = std::unique_ptr<OIIO::ImageInput>;

constexpr std::size_t k_block_bytes = std::size_t{64} << 20;
constexpr std::size_t k_largest_tile_row_bytes = std::size_t{512} << 20;
constexpr int k_block_rows = 256;  // the tallest chunk of scanlines that OpenEXR compresses as one

// The densest JPEG spends two bits on a block of 8 x 8 texels; a file far below that holds next to nothing of its
// image.
constexpr std::uintmax_t k_most_jpeg_texels_a_byte = 2048;

const char* plugin_name(ImageFormat format) {
  switch (format) {
    case ImageFormat::png:
      return "png";
    case ImageFormat::jpeg:
      return "jpeg";
    case ImageFormat::openexr:
      return "openexr";
    case ImageFormat::tiff:
      return "tiff";
    case ImageFormat::radiance:
      return "hdr";
    case ImageFormat::pnm:
      return "pnm";
    case ImageFormat::bmp:
      return "bmp";
    case ImageFormat::dds:
      return "dds";
    case ImageFormat::webp:
      return "webp";
    case ImageFormat::targa:
      break;
  }
  return "targa";
}

// The most telling line of a decoder's complaint, fit for the middle of a sentence.
std::string tidy(std::string_view complaint) {
  std::string_view longest;
  while (!complaint.empty()) {
    const std::size_t end = std::min(complaint.find('\n'), complaint.size());
    if (end > longest.size()) longest = complaint.substr(0, end);
    complaint.remove_prefix(std::min(end + 1, complaint.size()));
  }
  std::string line(longest.substr(0, 300));
  std::ranges::replace_if(
      line, [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; }, ' ');
  while (!line.empty() && (line.back() == '.' || line.back() == ' ')) line.pop_back();
  return line;
}

Error decoding_error(const std::filesystem::path& path, const std::string& complaint) {
  const std::string cause = tidy(complaint);
  return content_error(path.string(), cause.empty() ? "cannot be decoded: it is damaged or cut short"
                                                    : fmt::format("cannot be decoded: {}", cause));
}

// Runs `work`, which calls a decoder, with its prints dropped and its exceptions turned into an Error.
template <class Work>
auto guarded(const std::filesystem::path& path, Work work) -> decltype(work()) {
  const QuietStderr quiet;
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return content_error(path.string(), "cannot be decoded: not enough memory");
  } catch (const std::exception& failure) {
    return decoding_error(path, failure.what());
  } catch (...) {
    return decoding_error(path, {});
  }
}

// Closes inside the guard too: decoders print when an unfinished file is closed.
void close_quietly(InputPointer& input) {
  const QuietStderr quiet;
  try {
    input.reset();
  } catch (...) {  // NOLINT: nothing is left to be done for a file that was only read
  }
}

Result<InputPointer> open_input(const std::filesystem::path& path, ImageFormat format) {
  return guarded(path, [&]() -> Result<InputPointer> {
    // Repeated on every file because it is a setting of the library, not of the file.
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1);
    InputPointer input = OIIO::ImageInput::create(plugin_name(format));
    if (!input) {
      const std::string complaint = OIIO::geterror();
      return decoding_error(path, complaint);
    }
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::ImageSpec spec;
    if (!input->open(path.string(), spec, wishes)) {
      const std::string complaint = input->geterror();
      return decoding_error(path, complaint);
    }
    (void)input->geterror();  // a complaint of a header that could be read all the same
    return input;
  });
}

SampleKind sample_kind(const OIIO::TypeDesc& type) {
  switch (type.basetype) {
    case OIIO::TypeDesc::HALF:
    case OIIO::TypeDesc::FLOAT:
    case OIIO::TypeDesc::DOUBLE:
      return SampleKind::floating;
    case OIIO::TypeDesc::INT8:
    case OIIO::TypeDesc::INT16:
    case OIIO::TypeDesc::INT32:
    case OIIO::TypeDesc::INT64:
      return SampleKind::signed_integer;
    default:
      break;
  }
  return SampleKind::unsigned_integer;
}

int rows_per_block(const OIIO::ImageSpec& spec) {
  const std::size_t row_bytes =
      static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.nchannels) * sizeof(float);
  const int rows = static_cast<int>(std::clamp<std::size_t>(k_block_bytes / row_bytes, 1, k_block_rows));
  if (spec.tile_width <= 0) return rows;
  return std::max(1, rows / spec.tile_height) * spec.tile_height;
}

std::optional<Error> spec_fault(const RecognisedFile& file, const std::filesystem::path& path,
                                const OIIO::ImageSpec& spec) {
  if (const Status fits = check_map_size(path, spec.width, spec.height); !fits) return fits.error();
  if (spec.deep) return content_error(path.string(), "is a deep image; a normal map has one sample a texel");
  if (spec.depth > 1) return content_error(path.string(), "is a volume; a normal map has one layer");
  if (spec.nchannels < 1 || spec.nchannels > 1024) {
    return content_error(path.string(), fmt::format("has {} channels; 1 to 1024 are read", spec.nchannels));
  }
  if (spec.tile_width > 0) {
    const std::size_t tile_rows =
        std::min(static_cast<std::size_t>(std::max(spec.tile_height, 1)), static_cast<std::size_t>(spec.height));
    const std::size_t bytes = tile_rows * static_cast<std::size_t>(std::max(spec.tile_width, spec.width)) *
                              static_cast<std::size_t>(spec.nchannels) * sizeof(float);
    if (spec.tile_height < 1 || bytes > k_largest_tile_row_bytes) {
      return content_error(path.string(), fmt::format("its tiles of {} x {} with {} channels are too large",
                                                      spec.tile_width, spec.tile_height, spec.nchannels));
    }
  }
  const auto texels = static_cast<std::uintmax_t>(spec.width) * static_cast<std::uintmax_t>(spec.height);
  if (file.format == ImageFormat::jpeg && texels / k_most_jpeg_texels_a_byte > file.bytes) {
    return content_error(path.string(), fmt::format("is cut short: {} bytes cannot hold a JPEG image of {} x {}",
                                                    file.bytes, spec.width, spec.height));
  }
  return std::nullopt;
}

ImageInfo describe(const std::filesystem::path& path, ImageFormat format, const OIIO::ImageSpec& spec) {
  ImageInfo info;
  info.path = path;
  info.format = format;
  info.width = spec.width;
  info.height = spec.height;
  info.kind = sample_kind(spec.channelformat(0));
  const int type_bits = static_cast<int>(spec.channelformat(0).size() * 8);
  info.bits = spec.get_int_attribute("oiio:BitsPerSample", type_bits);
  if (info.bits < 1 || info.bits > type_bits) info.bits = type_bits;  // DDS states the bits of a texel
  info.channels = spec.channelnames;
  info.channels.resize(static_cast<std::size_t>(spec.nchannels));
  info.alpha_channel = spec.alpha_channel;
  info.images = std::max(1, spec.get_int_attribute("oiio:subimages", 1));
  info.block_rows = rows_per_block(spec);
  return info;
}

// Rows [first, first + count) with channels [channel_begin, channel_end), interleaved. Some readers (TIFF) report
// success for rows that they could not read and leave only a complaint: that counts as failure. JPEG's decoder
// complains of damage that it repairs: that stays with the input as a remark.
Status read_block(OIIO::ImageInput& input, const ImageInfo& info, int first, int count, int channel_begin,
                  int channel_end, std::vector<float>& samples) {
  return guarded(info.path, [&]() -> Status {
    const OIIO::ImageSpec& spec = input.spec();
    const int top = spec.y + first;
    const bool done = spec.tile_width > 0
                          ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, top, top + count, 0, 1, channel_begin,
                                             channel_end, OIIO::TypeDesc::FLOAT, samples.data())
                          : input.read_scanlines(0, 0, top, top + count, 0, channel_begin, channel_end,
                                                 OIIO::TypeDesc::FLOAT, samples.data());
    if (done && info.format == ImageFormat::jpeg) return success();
    const std::string complaint = input.geterror();
    if (done && complaint.empty()) return success();
    return decoding_error(info.path, complaint);
  });
}

// Moves the channels asked for to the front of the samples, in the order asked for.
void pick_channels(std::vector<float>& samples, std::size_t texels, int begin, int end, std::span<const int> channels) {
  const auto stride = static_cast<std::size_t>(end - begin);
  std::vector<float> texel(stride);
  for (std::size_t k = 0; k < texels; ++k) {
    std::copy_n(samples.begin() + static_cast<std::ptrdiff_t>(k * stride), stride, texel.begin());
    for (std::size_t c = 0; c < channels.size(); ++c) {
      samples[k * channels.size() + c] = texel[static_cast<std::size_t>(channels[c] - begin)];
    }
  }
}

bool is_same_image(const OIIO::ImageSpec& spec, const ImageInfo& info) {
  return spec.width == info.width && spec.height == info.height &&
         static_cast<std::size_t>(spec.nchannels) == info.channels.size() &&
         sample_kind(spec.channelformat(0)) == info.kind && rows_per_block(spec) == info.block_rows;
}

Status deliver_blocks(OIIO::ImageInput& input, const ImageInfo& info, std::span<const int> channels,
                      JobControl& control, const std::function<void(const RowBlock&)>& body) {
  const auto [least, greatest] = std::ranges::minmax(channels);
  const int begin = least;
  const int end = greatest + 1;
  const bool in_file_order =
      channels.size() == static_cast<std::size_t>(end - begin) && std::ranges::is_sorted(channels);
  const int block_rows = info.block_rows;
  std::vector<float> samples;
  for (int row = 0; row < info.height; row += block_rows) {
    if (control.cancelled()) return content_error(info.path.string(), "cancelled");
    const int rows = std::min(block_rows, info.height - row);
    const auto texels = static_cast<std::size_t>(rows) * static_cast<std::size_t>(info.width);
    samples.resize(texels * static_cast<std::size_t>(end - begin));
    if (const Status read = read_block(input, info, row, rows, begin, end, samples); !read) return read.error();
    if (!in_file_order) pick_channels(samples, texels, begin, end, channels);
    body({row, rows, std::span(samples).first(texels * channels.size())});
    control.finish_step();
  }
  return success();
}

}  // namespace

Result<ImageInfo> inspect_image(const std::filesystem::path& path) {
  const Result<RecognisedFile> file = recognise_file(path);
  if (!file) return file.error();
  Result<InputPointer> input = open_input(path, file->format);
  if (!input) return input.error();
  const OIIO::ImageSpec spec = (*input)->spec();
  close_quietly(*input);
  if (const std::optional<Error> fault = spec_fault(*file, path, spec)) return *fault;
  return describe(path, file->format, spec);
}

std::size_t row_block_count(const ImageInfo& info) {
  return static_cast<std::size_t>(info.height + info.block_rows - 1) / static_cast<std::size_t>(info.block_rows);
}

Result<std::string> read_rows(const ImageInfo& info, std::span<const int> channels, JobControl& control,
                              const std::function<void(const RowBlock&)>& body) {
  assert(!channels.empty());
  Result<InputPointer> input = open_input(info.path, info.format);
  if (!input) return input.error();
  if (!is_same_image((*input)->spec(), info)) {
    close_quietly(*input);
    return content_error(info.path.string(), "was changed by another program while it was being read");
  }
  const Status delivered = deliver_blocks(**input, info, channels, control, body);
  const std::string remark = (*input)->geterror();
  close_quietly(*input);
  if (!delivered) return delivered.error();
  return tidy(remark);
}

}  // namespace glint
