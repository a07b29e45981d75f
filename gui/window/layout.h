#pragma once
// Where the panels stand: pure geometry from the window's size and the splitters' ratios, in pixels.

#include <array>
#include <map>
#include <string>

#include "viewers/widgets/ui.h"

namespace glint::gui {

/// The panels of this build, in the order in which the keyboard visits them.
enum class Panel { map, pndf, inspector };
inline constexpr int k_panel_count = 3;
/// "map", "pndf", "inspector": as in widget names and settings.
std::string_view panel_name(Panel panel);

/// A gap between two panels that can be dragged.
struct Splitter {
  std::string name;      ///< "splitter.map": as in the settings
  view::Rectangle area;  ///< the gap
  double ratio = 0;      ///< where it stands, as a share of the room's width
  double lowest = 0;     ///< how far it can be dragged
  double highest = 1;
};

struct Layout {
  view::Rectangle menu_bar;
  view::Rectangle messages;
  view::Rectangle status_bar;
  std::array<view::Rectangle, k_panel_count> panels;  ///< empty: not shown
  std::array<Splitter, 2> splitters;                  ///< between map and P-NDF, and left of the Inspector
  int splitter_count = 0;
};

/// `ratios` holds remembered splitters by name; `maximised` names the one panel that fills the room, or is empty.
/// `message_height` is what the messages need, 0 for none.
Layout compute_layout(ImVec2 window, float scale, float message_height, const std::map<std::string, double>& ratios,
                      std::string_view maximised);

/// The smallest window in which nothing is cut, at scale 1; below it the window's content is drawn at this size.
inline constexpr float k_least_width = 1280;
inline constexpr float k_least_height = 720;

}  // namespace glint::gui
