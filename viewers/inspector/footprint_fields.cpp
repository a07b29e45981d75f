#include "viewers/inspector/footprint_fields.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/document/parameter.h"
#include "core/document/workspace.h"
#include "viewers/inspector/field_edits.h"
#include "viewers/map/footprint_shape.h"
#include "viewers/widgets/number_text.h"

namespace glint::view {
namespace {

constexpr double k_degrees = 180 / std::numbers::pi;
constexpr double k_steepest = 89;       // of the slider: at 90 it would jump to its other end
constexpr double k_angle_noise = 1e-9;  // degrees, of the conversion
constexpr std::string_view k_circle = "The footprint is round: it has no direction.";

const Parameter& center_parameter() {
  return *find_parameter("footprint.center");
}
const Parameter& covariance_parameter() {
  return *find_parameter("footprint.covariance");
}

// Without the last digits, which are those of the conversion: 12, not 11.999999999999998.
double without_noise(double value) {
  const std::string text = fmt::format("{:.12g}", value);
  return parsed_number(text).value_or(value);
}

bool is_circle(const FootprintShape& shape) {
  return shape.widths.x - shape.widths.y <= 1e-9 * shape.widths.x;
}

// Texture space has v downwards, so an angle towards the top of the picture has the other sign.
Result<Edit> shaped(const Document& document, const FootprintShape& shape, std::string label) {
  const SymmetricMatrix2 covariance = covariance_of(shape);
  Result<Edit> edit =
      proposed(document, covariance_parameter(), std::vector<double>{covariance.xx, covariance.xy, covariance.yy});
  if (edit) edit->label = std::move(label);
  return edit;
}

// The number in front of the unit, if there is one; `unit` is how it begins.
std::optional<double> typed_number(std::string_view text, std::string_view unit) {
  return parsed_number(text.substr(0, text.find(unit)));
}

Error not_a_number(std::string_view what, std::string_view text) {
  return request_error("footprint.covariance", fmt::format("{} is \"{}\"; allowed: a number", what, text));
}

void center_row(FieldPage& page, const NormalMap* map) {
  const Parameter& parameter = center_parameter();
  const Rectangle row = take_row(page);
  row_label(page, row, "Centre u, v");
  const glm::dvec2 center = page.document.footprint.center;
  const std::array<std::string_view, 2> units{"u", "v"};
  for (int k = 0; k < 2; ++k) {
    const auto index = static_cast<std::size_t>(k);
    const std::string name = fmt::format("{}.{}", parameter.path, parameter.components[index]);
    const Rectangle area = part_of(page.ui, control_area(page, row), index, 2);
    const auto typed = number_entry(page, name, area, center[k], units[index], explain_parameter(parameter));
    if (!typed) continue;
    take_typed(page, name, *typed,
               placed_on(map, typed_edit(page.document, parameter, {center.x, center.y}, index, *typed)));
  }
  reset_control(page, parameter, row);
}

void width_row(FieldPage& page, const FootprintShape& shape) {
  const Rectangle row = take_row(page);
  row_label(page, row, "Width σ1, σ2");
  for (int axis = 0; axis < 2; ++axis) {
    const Explained explained{
        axis == 0 ? "Larger width  σ1" : "Smaller width  σ2",
        "The standard deviation of the footprint's Gaussian along one axis of its ellipse, in texels; the map draws 1, "
        "3 and 5 of them.\nAllowed: from 1e-6 to 100000 texels.\nYan et al. 2014, eq. 3.",
        {}};
    const std::string name = fmt::format("footprint.width.{}", axis + 1);
    const double width = without_noise(shape.widths[axis]);
    const Rectangle area = part_of(page.ui, control_area(page, row), static_cast<std::size_t>(axis), 2);
    const auto typed = number_entry(page, name, area, width, {}, explained);
    if (!typed || *typed == copy_text(width)) continue;
    const std::optional<double> number = typed_number(*typed, "t");
    take_typed(page, name, *typed,
               number ? widened_footprint(page.document, axis, *number) : not_a_number("The width", *typed));
  }
}

void angle_row(FieldPage& page, const FootprintShape& shape) {
  const Rectangle row = take_row(page);
  const std::string reason(is_circle(shape) ? k_circle : std::string_view());
  row_label(page, row, "Angle", reason.empty());
  const double angle = without_noise(footprint_angle(page.document.footprint));
  const Explained explained{"Angle of the footprint",
                            "The direction of its larger width, from the u axis towards the top of the picture.\n"
                            "Allowed: any number, in degrees.\nYan et al. 2014, eq. 3.",
                            reason};
  const Rectangle area = control_area(page, row);
  const Rectangle typing{{area.max.x - entry_width(page), area.min.y}, area.max};
  const Rectangle track{area.min, {typing.min.x - page.ui.px(12), area.max.y}};
  if (const auto slide =
          slider(page.ui, "footprint.angle.slider", track, angle, -k_steepest, k_steepest, false, explained)) {
    const bool released = slide->finished && slide->value == angle;
    Result<Edit> edit = released ? Result<Edit>(Edit{page.document, {}, true})
                                 : turned_footprint(page.document, std::round(slide->value));
    if (edit) {
      edit->label = "Footprint angle";
      edit->finished = slide->finished;
      page.edit = std::move(*edit);
    }
  }
  const auto typed = number_entry(page, "footprint.angle", typing, angle, "°", explained);
  if (!typed || *typed == copy_text(angle)) return;
  const std::optional<double> number = typed_number(*typed, "°");
  take_typed(page, "footprint.angle", *typed,
             number ? turned_footprint(page.document, *number) : not_a_number("The angle", *typed));
}

}  // namespace

double footprint_angle(const Footprint& footprint) {
  const double degrees = -shape_of(footprint.covariance).angle * k_degrees;
  return degrees < -90 + k_angle_noise ? degrees + 180 : degrees + 0.0;
}

Result<Edit> turned_footprint(const Document& document, double degrees) {
  FootprintShape shape = shape_of(document.footprint.covariance);
  if (is_circle(shape)) return request_error("footprint.covariance", std::string(k_circle));
  shape.angle = -degrees / k_degrees;
  return shaped(document, shape, fmt::format("Footprint angle to {}°", short_number_text(degrees)));
}

Result<Edit> widened_footprint(const Document& document, int axis, double width) {
  if (!(width > 0)) {
    return request_error("footprint.covariance", fmt::format("The width is {}; allowed: a number above 0", width));
  }
  FootprintShape shape = shape_of(document.footprint.covariance);
  shape.widths[axis] = width;
  return shaped(document, shape, fmt::format("Width σ{} to {}", axis + 1, short_number_text(width)));
}

Result<Edit> placed_on(const NormalMap* map, Result<Edit> edit) {
  if (!edit || !map) return edit;
  std::optional<Error> fault = footprint_position_fault(edit->document.footprint, *map);
  if (!fault) return edit;
  fault->sentence = "The centre " + fault->sentence;
  return *std::move(fault);
}

void footprint_rows(FieldPage& page, const NormalMap* map) {
  const FootprintShape shape = shape_of(page.document.footprint.covariance);
  center_row(page, map);
  width_row(page, shape);
  angle_row(page, shape);
  field_row(page, covariance_parameter(), {.units = {"", "", ""}});
}

}  // namespace glint::view
