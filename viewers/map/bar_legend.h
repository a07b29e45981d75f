#pragma once
// The legend of colours over a picture: a bar of viridis with the values at its ends, on a chip of its own.

#include <imgui.h>
#include <span>
#include <string_view>

#include "viewers/gl/texture.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

struct LegendText {
  std::span<const std::string_view> names;  ///< of what is shown, longest first: the first that fits, if one does
  std::string_view low;
  std::string_view high;
  bool has_under = false;  ///< values below the bar have a colour of their own
  bool has_over = false;
};

class BarLegend {
 public:
  /// Top left at `at`, at most `width` wide. Returns the area it covers.
  Rectangle draw(Ui& ui, ImDrawList& list, ImVec2 at, float width, const LegendText& text);

 private:
  Texture bar_;
};

}  // namespace glint::view
