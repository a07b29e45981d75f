#pragma once
// Where everything in the P-NDF panel stands. Follows from the panel's size and the number of pictures alone, never
// from a figure in it: nothing jumps.

#include <array>
#include <optional>
#include <vector>

#include "viewers/widgets/ui.h"

namespace glint::view {

/// How the four figures under a picture stand.
enum class ReadOuts {
  two_rows,  ///< captions over values, two and two
  one_row,   ///< captions over values, all four side by side: where the height is what limits the pictures
  compact,   ///< two lines, without most captions: where pictures are small
};

struct PndfLayout {
  ReadOuts read_outs = ReadOuts::two_rows;
  Rectangle toolbar;                    ///< one row high
  Rectangle body;                       ///< titles, pictures and read-outs, all columns
  float title_height = 0;               ///< above a picture: its title
  float title_top = 0;                  ///< upper edge of the letters of the first row's titles
  std::vector<Rectangle> pictures;      ///< squares of the methods, whole pixels
  Rectangle bar;                        ///< column of the colour bar, as high as the pictures
  std::optional<Rectangle> difference;  ///< square
  float axis_height = 0;                ///< under a picture: ticks and numbers
  float row_height = 0;                 ///< of the read-outs under that

  [[nodiscard]] float title_top_of(const Rectangle& picture) const { return picture.min.y - title_height; }
  [[nodiscard]] bool compact() const { return read_outs == ReadOuts::compact; }
};

/// Left ends of the four figures in one row, from the picture's.
std::array<float, 4> one_row_offsets(const Ui& ui);

/// Pictures stand in one row, or in two where that makes them clearly larger: in a panel that is high.
PndfLayout pndf_layout(const Ui& ui, const Rectangle& content, std::size_t methods);

}  // namespace glint::view
