#include "gui/window/exporter.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/document/names.h"
#include "core/document/preset.h"
#include "core/image/atomic_file.h"
#include "core/image/normal_map_writer.h"
#include "core/image/pndf_exr.h"
#include "core/image/png_file.h"
#include "gui/commandline/false_color.h"

namespace glint::gui {
namespace {

const ExportKind& kind_of(ExportWhat what) {
  const auto kinds = export_kinds();
  return *std::find_if(kinds.begin(), kinds.end(), [&](const ExportKind& kind) { return kind.what == what; });
}

std::optional<Panel> panel_of(ExportWhat what) {
  switch (what) {
    case ExportWhat::map_panel:
      return Panel::map;
    case ExportWhat::pndf_panel:
      return Panel::pndf;
    case ExportWhat::inspector:
      return Panel::inspector;
    default:
      return std::nullopt;
  }
}

// The part of the frame that an area covers.
Status write_cut(const std::filesystem::path& path, const ExportSource& source, const view::Rectangle& area) {
  const int x0 = std::clamp(static_cast<int>(area.min.x), 0, source.size.x);
  const int y0 = std::clamp(static_cast<int>(area.min.y), 0, source.size.y);
  const int x1 = std::clamp(static_cast<int>(area.max.x), x0, source.size.x);
  const int y1 = std::clamp(static_cast<int>(area.max.y), y0, source.size.y);
  std::vector<std::uint8_t> cut;
  cut.reserve(3 * static_cast<std::size_t>(x1 - x0) * static_cast<std::size_t>(y1 - y0));
  const auto stride = 3 * static_cast<std::ptrdiff_t>(source.size.x);
  for (int y = y0; y < y1; ++y) {
    const auto row = source.rgb.begin() + y * stride;
    cut.insert(cut.end(), row + 3 * static_cast<std::ptrdiff_t>(x0), row + 3 * static_cast<std::ptrdiff_t>(x1));
  }
  return write_png_8(path, x1 - x0, y1 - y0, cut);
}

// Why the pictures are not those of the document.
std::string pictures_reason(const Workbench& workbench) {
  const auto results = workbench.jobs().results();
  if (!results || results->methods.empty()) return "There is no P-NDF yet.";
  for (const view::MethodPicture& picture : results->methods) {
    const bool full = picture.image && !picture.coarse && picture.image->grid == results->grid;
    if (!full || picture.revision != results->revision) return "The P-NDF is still being computed.";
  }
  if (results->revision != workbench.editor().revision()) return "The P-NDF is still being computed.";
  return {};
}

Status write_images(const std::filesystem::path& path, const view::PndfResults& results) {
  std::vector<NamedPndfImage> images;
  images.reserve(results.methods.size());
  for (const view::MethodPicture& picture : results.methods) {
    images.push_back({std::string(choice_name(picture.method)), picture.image.get()});
  }
  return write_pndf_exr(path, images, recipe_of(results.document));
}

Status write_false_color(const std::filesystem::path& path, const view::PndfResults& results) {
  std::vector<MethodImage> images;
  images.reserve(results.methods.size());
  for (const view::MethodPicture& picture : results.methods) {
    images.push_back({picture.method, results.surface->loaded.surface.interpolation(), picture.image.get()});
  }
  return false_color_picture(results.document, images).write_png(path);
}

std::string csv_of(const view::PndfReading& reading) {
  std::string text = "method,s,t,density,standard_error\n";
  const auto line = [&](std::string_view name, std::optional<double> density, std::optional<double> error) {
    text += fmt::format("{},{},{},{},{}\n", name, reading.s.x, reading.s.y, density ? fmt::format("{}", *density) : "",
                        error ? fmt::format("{}", *error) : "");
  };
  for (const view::PndfReading::Value& value : reading.values) {
    line(choice_name(value.method), value.density, value.standard_error);
  }
  if (reading.reference) line("reference", reading.reference, std::nullopt);
  return text;
}

Status write_data(const ExportOrder& order, const ExportSource& source) {
  switch (order.what) {
    case ExportWhat::pndf_images:
      return write_images(order.path, *source.workbench.jobs().results());
    case ExportWhat::pndf_picture:
      return write_false_color(order.path, *source.workbench.jobs().results());
    case ExportWhat::normal_map:
      return write_normal_map(order.path, source.workbench.jobs().surface()->loaded.surface.map());
    default:
      return write_file(order.path, csv_of(*source.reading));
  }
}

}  // namespace

Result<ExportWhat> export_named(std::string_view key) {
  std::string known;
  for (const ExportKind& kind : export_kinds()) {
    if (kind.key == key) return kind.what;
    known += (known.empty() ? "" : ", ") + std::string(kind.key);
  }
  return request_error(std::string(key), "is nothing that can be exported; known: " + known);
}

std::string export_reason(ExportWhat what, const ExportSource& source) {
  if (const std::optional<Panel> panel = panel_of(what)) {
    return source.layout.panels[static_cast<std::size_t>(*panel)].width() > 0 ? "" : "The panel is not on screen.";
  }
  switch (what) {
    case ExportWhat::pndf_images:
    case ExportWhat::pndf_picture:
      return pictures_reason(source.workbench);
    case ExportWhat::normal_map:
      return source.workbench.jobs().surface() ? "" : "There is no map yet.";
    case ExportWhat::values:
      return source.reading ? "" : "There is no crosshair: click in a P-NDF first.";
    default:
      return {};
  }
}

Status write_export(const ExportOrder& order, const ExportSource& source) {
  const ExportKind& kind = kind_of(order.what);
  const std::string extension = order.path.extension().string();
  if (std::find(kind.extensions.begin(), kind.extensions.end(), extension) == kind.extensions.end()) {
    return request_error(order.path.string(), fmt::format("must end in {}", fmt::join(kind.extensions, " or ")));
  }
  if (const std::string reason = export_reason(order.what, source); !reason.empty()) {
    return content_error(order.path.string(), "cannot be written: " + reason.substr(0, reason.size() - 1));
  }
  if (const std::optional<Panel> panel = panel_of(order.what)) {
    return write_cut(order.path, source, source.layout.panels[static_cast<std::size_t>(*panel)]);
  }
  if (order.what == ExportWhat::window) {
    return write_cut(order.path, source,
                     {{0, 0}, {static_cast<float>(source.size.x), static_cast<float>(source.size.y)}});
  }
  return write_data(order, source);
}

}  // namespace glint::gui
