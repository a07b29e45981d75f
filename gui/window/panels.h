#pragma once
// The panels of the window: draws each where the layout puts it and hands on what a person did in it.

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include <glm/vec2.hpp>

#include "gui/memory/workbench.h"
#include "gui/window/layout.h"
#include "viewers/inspector/inspector.h"
#include "viewers/map/normal_map_view.h"
#include "viewers/pndf/pndf_view.h"

namespace glint::gui {

/// What a person asked for in a panel that is not an edit of the document.
struct PanelWishes {
  std::optional<Panel> maximise;  ///< or back
  std::optional<Panel> export_of;
  std::optional<std::string> preset;  ///< to be opened, by name
  bool open = false;                  ///< a map or preset to be chosen
  bool browse_map = false;            ///< another file for the map of this document
  bool save = false;
  bool save_as = false;
  bool revert = false;
  bool reload = false;
  bool restart = false;
};

class Panels {
 public:
  /// Draws the panels and applies their edits to the workbench.
  PanelWishes draw(view::Ui& ui, const Layout& layout, Workbench& workbench, bool flipped);

  [[nodiscard]] view::NormalMapView& map() { return map_; }
  [[nodiscard]] const view::NormalMapView& map() const { return map_; }
  [[nodiscard]] const view::PndfView& pndf() const { return pndf_; }
  [[nodiscard]] view::Inspector& inspector() { return inspector_; }

  /// Whether another frame will show more of the map, or its elements by a crosshair that has moved since it was drawn.
  [[nodiscard]] bool incomplete(const Document& document) const;

  [[nodiscard]] Panel focused() const { return focused_; }
  void focus(Panel panel) { focused_ = panel; }
  /// The panel in which the widget that was drawn as the n-th of the last frame stands; none for bars and dialogs.
  [[nodiscard]] std::optional<Panel> panel_of(std::size_t widget_index) const;
  /// The first widget of a panel, as an index into WidgetRecord::order().
  [[nodiscard]] std::size_t first_widget(Panel panel) const { return ranges_[static_cast<std::size_t>(panel)].first; }

 private:
  void draw_map(view::Ui& ui, const Layout& layout, Workbench& workbench, PanelWishes& wishes);
  void draw_pndf(view::Ui& ui, const Layout& layout, Workbench& workbench, bool flipped, PanelWishes& wishes);
  void draw_inspector(view::Ui& ui, const Layout& layout, Workbench& workbench, PanelWishes& wishes);

  view::NormalMapView map_;
  view::PndfView pndf_;
  view::Inspector inspector_;
  Panel focused_ = Panel::pndf;
  bool map_drawn_ = false;                                                   // in the last frame
  std::optional<glm::dvec2> crosshair_on_map_;                               // when it was drawn last
  std::array<std::pair<std::size_t, std::size_t>, k_panel_count> ranges_{};  // of widgets in the record
};

}  // namespace glint::gui
