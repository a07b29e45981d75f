#include "gui/dialogs/file_preview.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/document/document.h"
#include "core/document/names.h"
#include "core/document/preset.h"
#include "core/image/channel_layout.h"
#include "core/image/image_file.h"
#include "core/image/pndf_exr.h"
#include "gui/dialogs/file_listing.h"
#include "viewers/map/footprint_shape.h"
#include "viewers/widgets/number_text.h"

namespace glint::gui {
namespace {

namespace fs = std::filesystem;

constexpr int k_samples_a_side = 4;    // at most that many rows and columns are averaged to one pixel
constexpr double k_shown_decades = 4;  // of values above one

std::string no_preview(const Error& error) {
  return "No preview: " + error.sentence + ".";
}

// The message of an error whose subject begins with the path of the file ("file:line:column").
std::string without_folder(const Error& error, const fs::path& file) {
  const std::string path = file.string();
  if (!error.subject.starts_with(path)) return error.message();
  const std::string name = shown_path(file.filename());
  return name + error.subject.substr(path.size()) + ": " + error.sentence;
}

// Means of the samples that fall to each pixel of the small picture.
class Shrunk {
 public:
  Shrunk(const ImageInfo& info, std::size_t channels, int most_side) : image_(info.width, info.height), c_(channels) {
    const double factor = std::min(1.0, static_cast<double>(most_side) / std::max(info.width, info.height));
    size_ = {std::max(1, static_cast<int>(factor * info.width)), std::max(1, static_cast<int>(factor * info.height))};
    step_ = {std::max(1, image_.x / size_.x / k_samples_a_side), std::max(1, image_.y / size_.y / k_samples_a_side)};
    const std::size_t pixels = static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y);
    sums_.resize(pixels * c_);
    counts_.resize(pixels * c_);
  }

  void add(const RowBlock& block) {
    for (int row = 0; row < block.row_count; ++row) {
      const int y = block.first_row + row;
      if (y % step_.y != 0) continue;
      const auto line = block.samples.subspan(static_cast<std::size_t>(row) * static_cast<std::size_t>(image_.x) * c_);
      const std::int64_t pixel_row = std::int64_t{y} * size_.y / image_.y * size_.x;
      for (int x = 0; x < image_.x; x += step_.x) {
        const std::int64_t pixel = pixel_row + std::int64_t{x} * size_.x / image_.x;
        add(static_cast<std::size_t>(pixel) * c_, line.subspan(static_cast<std::size_t>(x) * c_, c_));
      }
    }
  }

  [[nodiscard]] glm::ivec2 size() const { return size_; }
  [[nodiscard]] std::vector<float> means() const {
    std::vector<float> means(sums_.size());
    for (std::size_t k = 0; k < means.size(); ++k) means[k] = counts_[k] > 0 ? sums_[k] / counts_[k] : 0;
    return means;
  }

 private:
  void add(std::size_t at, std::span<const float> sample) {
    for (std::size_t k = 0; k < c_; ++k) {
      if (!std::isfinite(sample[k])) continue;
      sums_[at + k] += sample[k];
      counts_[at + k] += 1;
    }
  }

  glm::ivec2 image_;
  glm::ivec2 size_{1, 1};
  glm::ivec2 step_{1, 1};
  std::size_t c_;
  std::vector<float> sums_;
  std::vector<float> counts_;
};

// Into [0, 1]: signed values with zero in the middle, values far above one by their logarithm.
void bring_into_range(std::vector<float>& values) {
  const auto [least, greatest] = std::ranges::minmax(values);
  if (least < -1e-3F) {
    const float reach = std::max({1.0F, -least, greatest});
    for (float& v : values) v = 0.5F + 0.5F * v / reach;
  } else if (greatest > 1.01F) {
    for (float& v : values) {
      v = static_cast<float>(1 + std::log10(std::max(v, 1e-30F) / greatest) / k_shown_decades);
    }
  }
  for (float& v : values) v = std::clamp(v, 0.0F, 1.0F);
}

// One channel is a grey, two are the first two of a unit normal.
std::vector<std::uint8_t> as_rgba(const std::vector<float>& values, std::size_t channels) {
  std::vector<std::uint8_t> rgba;
  rgba.reserve(values.size() / channels * 4);
  const auto byte = [](float v) { return static_cast<std::uint8_t>(std::lround(255 * v)); };
  for (std::size_t at = 0; at + channels <= values.size(); at += channels) {
    const float r = values[at];
    const float g = channels > 1 ? values[at + 1] : r;
    float b = channels > 2 ? values[at + 2] : r;
    if (channels == 2) {
      const float x = 2 * r - 1;
      const float y = 2 * g - 1;
      b = 0.5F + 0.5F * std::sqrt(std::max(0.0F, 1 - x * x - y * y));
    }
    rgba.insert(rgba.end(), {byte(r), byte(g), byte(b), 255});
  }
  return rgba;
}

std::string channels_text(const ImageInfo& info) {
  std::string text;
  for (const std::string& channel : info.channels) text += (text.empty() ? "" : ", ") + channel;
  return text;
}

std::string stored_text(const ImageInfo& info) {
  const char* kind = info.kind == SampleKind::floating         ? " float"
                     : info.kind == SampleKind::signed_integer ? " signed"
                                                               : "";
  return fmt::format("{} bit{}, {}", info.bits, kind, format_title(info.format));
}

void read_picture(const ImageInfo& info, int most_side, JobControl& control, FilePreview& preview) {
  if (std::int64_t{info.width} * info.height > k_most_preview_pixels) {
    preview.reason = "No preview: the picture has more than 64 million pixels. It can be opened all the same.";
    return;
  }
  const ChannelChoice choice = choose_channels(info);
  Shrunk shrunk(info, choice.colors.size(), most_side);
  const Result<std::string> remark =
      read_rows(info, choice.colors, control, [&](const RowBlock& block) { shrunk.add(block); });
  if (!remark) {
    preview.reason = no_preview(remark.error());
    return;
  }
  std::vector<float> values = shrunk.means();
  bring_into_range(values);
  preview.size = shrunk.size();
  preview.rgba = as_rgba(values, choice.colors.size());
  preview.remark = *remark;
}

void add_picture(const fs::path& file, int most_side, JobControl& control, FilePreview& preview) {
  const Result<ImageInfo> info = inspect_image(file);
  if (!info) {
    preview.reason = no_preview(info.error());
    return;
  }
  preview.facts.push_back({"Size", fmt::format("{} × {}", info->width, info->height)});
  preview.facts.push_back({info->channels.size() == 1 ? "Channel" : "Channels", channels_text(*info)});
  preview.facts.push_back({"Stored as", stored_text(*info)});
  if (info->images > 1) preview.facts.push_back({"Images", fmt::format("{}, the first is read", info->images)});
  read_picture(*info, most_side, control, preview);
}

std::string source_text(const SurfaceDescription& surface) {
  if (surface.source == SurfaceSource::file) return shown_path(surface.path.filename());
  return fmt::format("generated {}", choice_name(surface.source));
}

void add_document(const Document& document, FilePreview& preview) {
  const view::FootprintShape shape = view::shape_of(document.footprint.covariance);
  const double degrees = shape.angle * 180 / std::numbers::pi;
  preview.facts.push_back({"Name", document.name});
  preview.facts.push_back({"Surface", source_text(document.surface)});
  preview.facts.push_back({"Roughness σ", view::number_text(document.intrinsic_roughness)});
  preview.facts.push_back({"Footprint", fmt::format("{} × {} texels, {}°", view::number_text(shape.widths.x),
                                                    view::number_text(shape.widths.y), view::number_text(degrees))});
}

FilePreview preview_of_preset(const fs::path& file, int most_side, JobControl& control) {
  FilePreview preview;
  const Result<Document> document = load_preset(file);
  if (!document) {
    preview.reason = "This preset cannot be opened: " + without_folder(document.error(), file) + ".";
    return preview;
  }
  add_document(*document, preview);
  if (document->surface.source != SurfaceSource::file) return preview;
  FilePreview map;
  add_picture(document->surface.path, most_side, control, map);
  preview.size = map.size;
  preview.rgba = std::move(map.rgba);
  preview.reason = std::move(map.reason);
  return preview;
}

}  // namespace

FilePreview preview_of(const fs::path& file, int most_side, JobControl& control) {
  const std::string extension = file.extension().string();
  if (extension == ".json") return preview_of_preset(file, most_side, control);
  FilePreview preview;
  add_picture(file, most_side, control, preview);
  if (extension == ".exr" && read_recipe(file)) {
    preview.remark = "It was made by this program: opening it restores all its settings.";
  }
  return preview;
}

FilePreviews::FilePreviews(std::function<void()> wake) : wake_(wake ? std::move(wake) : [] {}), job_(wake_, errors_) {}

void FilePreviews::want(const fs::path& file, int most_side) {
  if (file == wanted_) return;
  forget();
  wanted_ = file;
  job_.start([this, file, most_side](JobSteps& steps) {
    JobControl& control = steps.begin("looking at " + shown_path(file.filename()));
    auto preview = std::make_shared<FilePreview>();
    try {
      *preview = preview_of(file, most_side, control);
    } catch (const std::exception& failure) {
      preview->reason = no_preview(exception_error({}, failure));
    }
    const std::lock_guard lock(mutex_);
    if (!steps.cancelled()) current_ = std::move(preview);
  });
}

void FilePreviews::forget() {
  job_.cancel();
  wanted_.clear();
  const std::lock_guard lock(mutex_);
  current_.reset();
}

std::shared_ptr<const FilePreview> FilePreviews::current() const {
  const std::lock_guard lock(mutex_);
  return current_;
}

}  // namespace glint::gui
