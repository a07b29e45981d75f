#pragma once
// What every panel and widget needs to draw itself: the scale, the fonts, the pictures of this frame, the keyboard's
// focus, and the record of where each widget stands, by name. One frame, one thread.

#include <cmath>
#include <cstddef>
#include <imgui.h>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "viewers/gl/frame_pictures.h"
#include "viewers/gl/gl_functions.h"
#include "viewers/widgets/fonts.h"

namespace glint::view {

struct Rectangle {
  ImVec2 min{0, 0};
  ImVec2 max{0, 0};

  [[nodiscard]] float width() const { return max.x - min.x; }
  [[nodiscard]] float height() const { return max.y - min.y; }
  [[nodiscard]] ImVec2 size() const { return {width(), height()}; }
  [[nodiscard]] ImVec2 center() const { return {0.5F * (min.x + max.x), 0.5F * (min.y + max.y)}; }
  [[nodiscard]] bool contains(ImVec2 p) const { return p.x >= min.x && p.y >= min.y && p.x < max.x && p.y < max.y; }
};

/// Whether two areas share anything.
inline bool overlap(const Rectangle& a, const Rectangle& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

/// Where the widgets of a frame stand, in the order in which they were drawn. Names are those of scripts
/// ("pndf.scale.log"); controls of a field carry the field's path ("intrinsic_roughness", "footprint.center.x").
class WidgetRecord {
 public:
  struct Entry {
    Rectangle area;
    std::string reason;      ///< why it is disabled; empty: it is not
    bool focusable = false;  ///< a stop of the Tab key
    bool varies = false;     ///< shows what differs from run to run: times, rates
  };

  void clear() {
    entries_.clear();
    order_.clear();
  }
  /// The last one of a name counts.
  void record(std::string_view name, Entry entry);
  [[nodiscard]] const Entry* find(std::string_view name) const;
  [[nodiscard]] const std::map<std::string, Entry, std::less<>>& entries() const { return entries_; }
  /// Names in the order in which they were drawn.
  [[nodiscard]] const std::vector<std::string>& order() const { return order_; }

 private:
  std::map<std::string, Entry, std::less<>> entries_;
  std::vector<std::string> order_;
};

/// What the keyboard does to the focused widget in this frame. The window fills it from its key events.
struct KeyboardFocus {
  std::string name;       ///< of the focused widget; empty: none
  bool activate = false;  ///< Space or Enter was pressed
  int right = 0;          ///< presses of Right less those of Left, ten times that with Shift
  int down = 0;           ///< presses of Down less those of Up, ten times that with Shift
  bool moved = false;     ///< the focus has just come here by the keyboard: scroll it into view
};

/// What widgets remember from frame to frame.
struct UiState {
  KeyboardFocus focus;
  std::string editing;  ///< name of the entry in which a person types; empty: none
  std::string text;     ///< what stands in it
  bool editing_began = false;
  std::string editing_error;  ///< why the last text was refused; shown as the entry's tooltip
  std::string dragging;       ///< name of the slider or handle under the mouse button
  double drag_start = 0;      ///< the slider's value when the drag began
  std::string hovered;        ///< name of what the mouse rests on, and since when
  double hovered_since = 0;
  std::string open_popup;  ///< name of the open list or menu; empty: none
  int popup_row = 0;       ///< its highlighted row
};

/// Handed to every drawing function.
struct Ui {
  const GlFunctions& gl;
  const Fonts& fonts;
  FramePictures& pictures;
  WidgetRecord& widgets;  ///< of the frame being drawn
  UiState& state;
  float scale = 1;
  double seconds = 0;     ///< since the program began; steady steps in a headless run
  bool headless = false;  ///< nothing blinks; what the mouse rests on explains itself at once
  bool blocked = false;   ///< what is drawn must ignore the mouse: a list, menu or dialog lies over it

  /// A length of the theme in whole pixels at this scale.
  [[nodiscard]] float px(float length) const { return std::floor(length * scale + 0.5F); }
};

}  // namespace glint::view
