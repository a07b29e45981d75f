#pragma once
// Screens held against pictures in tests/golden. A difference fails with a picture of both and of where they differ;
// GLINTSCOPE_RENEW_GOLDEN=1 in the environment writes the pictures anew instead.

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "viewers/widgets/ui.h"

namespace glint::test {

struct Picture {
  glm::ivec2 size{0, 0};
  std::vector<std::uint8_t> rgb;  ///< rows from the top
};

/// How far two pictures of one size are apart, as an eye sees it: both are blurred by 3 x 3 pixels, so that the edge of
/// a letter may stand a fraction of a pixel elsewhere, and compared per pixel.
struct PictureDifference {
  double differing = 0;  ///< share of the pixels that differ by more than a person would notice
  int largest = 0;       ///< of a channel after the blur, 0 to 255
  Picture map;           ///< the differing pixels in magenta over the first picture, dimmed
};
PictureDifference compare_pictures(const Picture& a, const Picture& b);

/// Paints over what differs from run to run: the widgets that say so.
void cover_what_varies(Picture& picture, const view::WidgetRecord& widgets);

/// Fails the running test unless the picture equals tests/golden/<name>.png within the tolerance.
void expect_golden(const std::string& name, const Picture& picture);

}  // namespace glint::test
