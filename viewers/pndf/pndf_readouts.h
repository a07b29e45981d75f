#pragma once
// The figures under the pictures of the P-NDF panel.

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "viewers/pndf/pndf_pictures.h"
#include "viewers/pndf/pndf_results.h"
#include "viewers/widgets/number_text.h"
#include "viewers/widgets/ui.h"
#include "viewers/widgets/widgets.h"

namespace glint::view {

/// One figure: its caption stands above it, or, where room is short, the brief one beside it.
struct Figure {
  std::string name;  ///< in the record
  std::string_view caption;
  std::string_view brief;         ///< may be empty
  std::optional<Quantity> value;  ///< none: not known yet
  std::string brief_value;        ///< instead of brief caption and value, where that reads better: "no noise"
  Explained help;
  bool varies = false;  ///< from run to run
};

Figure time_figure(PndfMethod method, const MethodPicture* picture);
/// `surface` names what the reference was computed on: "smooth".
Figure error_figure(PndfMethod method, const MethodPicture* picture, std::string_view surface);
Figure density_figure(PndfMethod method, const MethodPicture* picture, std::optional<glm::dvec2> cursor);
Figure noise_figure(PndfMethod method, const MethodPicture* picture);
Figure difference_figure(const DifferenceImage* difference, std::optional<glm::dvec2> cursor);
Figure largest_difference_figure(const DifferenceImage* difference);

/// Caption over value, at the top left.
void draw_figure(Ui& ui, ImVec2 at, const Figure& figure);
/// Both in one line between `left` and `right`; the second is right-aligned and loses its brief caption where they
/// meet.
void draw_figure_line(Ui& ui, ImVec2 left, float right, const Figure& first, const Figure& second);
/// One figure in a line of its own, its brief caption left out where the room of the longest number does not hold both.
void draw_figure_at(Ui& ui, ImVec2 at, float right, const Figure& figure);
/// What a figure of three digits can need in such a line.
float longest_figure_width(const Ui& ui, std::string_view brief);

}  // namespace glint::view
