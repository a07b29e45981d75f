#pragma once
// The columns of the P-NDF panel: a title, a picture with its state, axes, and the read-outs under it.

#include <optional>
#include <string>
#include <vector>

#include "viewers/pndf/color_bar.h"
#include "viewers/pndf/disk_picture.h"
#include "viewers/pndf/pndf_layout.h"
#include "viewers/pndf/pndf_pictures.h"
#include "viewers/pndf/pndf_results.h"
#include "viewers/widgets/ui.h"

namespace glint::view {

/// What all pictures share.
struct PndfScene {
  glm::dvec4 window = k_whole_disk;  ///< of the disk, in every picture
  std::optional<glm::dvec2> cursor;  ///< the normal under the crosshair
  DensityRange density;
  DifferenceRange difference;
};

/// A note over a picture, and what is said where its width is not enough.
struct Chip {
  std::string full;
  std::string brief;
};

/// One picture: what is shown in it and over it.
struct PictureState {
  bool first = false;           ///< the one whose rings and axes are labelled
  bool dimmed = false;          ///< older than the document
  bool awaited = false;         ///< and one of the document's is on its way: old figures say nothing
  bool focused = false;         ///< by the keyboard
  double progress = 1;          ///< of a better one under way, or of the document's
  std::vector<Chip> chips;      ///< from the bottom
  std::string nothing;          ///< why it is empty and stays so; where there is neither image nor this: "…"
  bool offers_restart = false;  ///< under that: a button
};

struct MethodColumn {
  PndfMethod method = PndfMethod::exact;
  std::string setting;                     ///< "32 triangles"; left out where it does not fit
  std::string help;                        ///< sentences for the title's tooltip
  std::string surface;                     ///< that of the reference: "smooth"
  const MethodPicture* picture = nullptr;  ///< null: nothing is there yet
  const ShownImage* shown = nullptr;       ///< what is drawn: its image, or the reference while flipped
  PictureState state;
};
/// True when the button that computes again was pressed.
bool draw_method_column(Ui& ui, const PndfLayout& layout, const Rectangle& square, const PndfScene& scene,
                        const MethodColumn& column);

struct DifferenceColumn {
  std::string setting;  ///< "binning − exact"
  const ShownDifference* shown = nullptr;
  bool fitted = true;
  PictureState state;
};
std::optional<DifferenceChange> draw_difference_column(Ui& ui, const PndfLayout& layout, const PndfScene& scene,
                                                       const DifferenceColumn& column);

/// Instead of all columns: why there is nothing and, if it `offers_restart`, what can be done. True when that was
/// pressed.
bool draw_empty_body(Ui& ui, const Rectangle& area, const std::string& sentence, bool offers_restart);

/// "exact" and "Exact".
std::string method_name(PndfMethod method);

}  // namespace glint::view
