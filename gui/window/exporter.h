#pragma once
// Files out of the window: pictures of panels as they are on screen, and the data behind them. What can be exported,
// and under which names, is listed in gui/dialogs/export_dialog.h.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "core/math/result.h"
#include "gui/dialogs/export_dialog.h"
#include "gui/memory/workbench.h"
#include "gui/window/layout.h"
#include "viewers/pndf/pndf_view.h"

namespace glint::gui {

/// A wish that is granted when the frame is drawn.
struct ExportOrder {
  ExportWhat what = ExportWhat::window;
  std::filesystem::path path;
};

/// The kind of that key ("images"), or a request error that lists them.
Result<ExportWhat> export_named(std::string_view key);

/// What exports are made of.
struct ExportSource {
  const Workbench& workbench;
  const Layout& layout;
  std::span<const std::uint8_t> rgb;  ///< the last frame, rows from the top
  glm::ivec2 size{0, 0};              ///< of the frame
  const std::optional<view::PndfReading>& reading;
};

/// Why this cannot be exported now, as a sentence; empty: it can.
std::string export_reason(ExportWhat what, const ExportSource& source);

/// Writes it, all or nothing; errors name the file.
Status write_export(const ExportOrder& order, const ExportSource& source);

}  // namespace glint::gui
