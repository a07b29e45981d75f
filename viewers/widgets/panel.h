#pragma once
// The frame of a panel: border, header with title, hint and icons, and the room that is left for its content.

#include <string>
#include <string_view>

#include "viewers/widgets/ui.h"

namespace glint::view {

struct PanelHeader {
  std::string_view name;  ///< "map": widgets are recorded as map.export, map.maximise, map.help
  std::string_view title;
  std::string_view hint;  ///< one line: which question the panel answers; left out where it does not fit
  std::string_view help;  ///< sentences for the tooltip of the question mark
  bool focused = false;
  bool maximised = false;
  bool can_export = true;
  bool busy = false;  ///< 3 px bar under the header's edge
  double progress = 0;
};

struct PanelEvents {
  bool export_pressed = false;
  bool maximise_pressed = false;
  bool clicked = false;  ///< anywhere inside: the panel wants the focus
};

/// Draws frame and header into `area`, opens a child window for the content and returns its area in `content`.
/// Every begin has its end.
PanelEvents begin_panel(Ui& ui, const PanelHeader& header, const Rectangle& area, Rectangle& content,
                        bool scrolls = false);
void end_panel();

}  // namespace glint::view
