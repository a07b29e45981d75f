#include "gui/input/keyboard.h"

#include <vector>

namespace glint::gui {

std::string next_stop(const view::WidgetRecord& widgets, std::size_t first, const std::string& name, bool backwards) {
  std::vector<std::string> stops;
  std::optional<std::size_t> current;
  for (std::size_t k = first; k < widgets.order().size(); ++k) {
    const std::string& candidate = widgets.order()[k];
    const view::WidgetRecord::Entry* entry = widgets.find(candidate);
    if (entry == nullptr || !entry->focusable) continue;
    if (candidate == name) current = stops.size();
    stops.push_back(candidate);
  }
  if (stops.empty()) return {};
  if (!current) return backwards ? stops.back() : stops.front();
  const std::size_t count = stops.size();
  return stops[(*current + (backwards ? count - 1 : 1)) % count];
}

bool feed_focus(view::KeyboardFocus& focus, const Chord& chord) {
  if (chord.ctrl || chord.alt) return false;
  const int step = chord.shift ? 10 : 1;
  switch (chord.key) {
    case Key::space:
    case Key::enter:
      focus.activate = true;
      return true;
    case Key::left:
      focus.right -= step;
      return true;
    case Key::right:
      focus.right += step;
      return true;
    case Key::up:
      focus.down -= step;
      return true;
    case Key::down:
      focus.down += step;
      return true;
    default:
      return false;
  }
}

}  // namespace glint::gui
