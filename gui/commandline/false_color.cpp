#include "gui/commandline/false_color.h"

#include <vector>

#include <fmt/format.h>

#include "core/document/names.h"
#include "core/image/pndf_picture.h"
#include "gui/commandline/document_options.h"

namespace glint::gui {
namespace {

// 1500000 is "1.5 M".
std::string short_count(std::uint64_t count) {
  const auto value = static_cast<double>(count);
  if (count >= 1'000'000'000) return fmt::format("{:.4g} G", value / 1e9);
  if (count >= 1'000'000) return fmt::format("{:.4g} M", value / 1e6);
  if (count >= 1'000) return fmt::format("{:.4g} k", value / 1e3);
  return fmt::format("{}", count);
}

PictureEntry entry_of(const Document& document, const MethodImage& m) {
  PictureEntry entry;
  entry.title = choice_name(m.method);
  entry.detail = std::string(choice_name(m.surface)) + " surface";
  entry.caption = fmt::format("integral {:.5f}", integral(*m.image));
  if (m.method == PndfMethod::mixture) {
    entry.detail = fmt::format("h {:.4g}, {}", document.mixture.step, choice_name(document.mixture.elements));
  }
  if (!m.image->answer.text.empty()) entry.detail = m.image->answer.text;
  if (m.method == PndfMethod::binning) {
    entry.detail = fmt::format("{} samples", short_count(document.binning_samples));
    entry.caption += "   own noise " + noise_text(*m.image);
  }
  entry.image = m.image;
  return entry;
}

}  // namespace

std::string noise_text(const PndfImage& image) {
  if (image.standard_error.empty()) return "none";
  if (!image.error.estimated) return "unknown";  // without a sample in the window
  return fmt::format("{:.2g} %", 100 * *image.error.estimated);
}

Canvas false_color_picture(const Document& document, std::span<const MethodImage> images) {
  std::vector<PictureEntry> entries;
  entries.reserve(images.size());
  for (const MethodImage& m : images) entries.push_back(entry_of(document, m));
  const SymmetricMatrix2& c = document.footprint.covariance;
  std::string footer = fmt::format(
      "footprint at {:.6g}, {:.6g} texels, covariance {:.4g}, {:.4g}, {:.4g}   sigma_r {:.4g}",
      document.footprint.center.x, document.footprint.center.y, c.xx, c.xy, c.yy, document.intrinsic_roughness);
  for (const MethodImage& m : images) {
    const glm::dvec2 widening = m.image->widening;
    if (widening == glm::dvec2(0)) continue;
    footer += fmt::format("   {}: its square widened by {:.2g}, {:.2g}", choice_name(m.method), widening.x, widening.y);
  }
  footer += "   " + std::filesystem::path(map_name(document)).filename().string();
  return draw_pndf_picture(entries, footer);
}

}  // namespace glint::gui
