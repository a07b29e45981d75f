#include "viewers/inspector/inspector_sections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/document/names.h"
#include "viewers/inspector/field_edits.h"
#include "viewers/inspector/footprint_fields.h"
#include "viewers/inspector/method_rows.h"
#include "viewers/inspector/read_report_rows.h"
#include "viewers/inspector/reading_rows.h"
#include "viewers/map/map_elements.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/number_text.h"
#include "viewers/widgets/theme.h"

namespace glint::view {
namespace {

const Parameter& field(std::string_view path) {
  return *find_parameter(path);
}

bool is_file(const Document& document) {
  return document.surface.source == SurfaceSource::file;
}

// What was reported of the document's file; null where another map is in use.
const ReadReport* report_of(const InspectorInput& input) {
  if (!is_file(input.document) || !input.surface || !input.surface->loaded.report) return nullptr;
  return input.surface->description.path == input.document.surface.path ? &*input.surface->loaded.report : nullptr;
}
const NormalMap* map_of(const InspectorInput& input) {
  return input.surface ? &input.surface->loaded.surface.map() : nullptr;
}

// --- surface

void source_row(const SectionScene& scene) {
  FieldPage& page = scene.page;
  const Parameter& parameter = field("surface.source");
  const Rectangle row = take_row(page);
  row_label(page, row, narrow_label(parameter));
  reset_control(page, parameter, row);
  const auto now = std::get<std::string>(parameter.get(page.document));
  const auto chosen = std::find(parameter.choices.begin(), parameter.choices.end(), now) - parameter.choices.begin();
  const auto picked = combo(page.ui, parameter.path, control_area(page, row), parameter.choices,
                            static_cast<int>(chosen), explain_parameter(parameter));
  if (!picked) return;
  const std::string source(parameter.choices[static_cast<std::size_t>(*picked)]);
  if (Result<Edit> edit = proposed_choice(page.document, parameter, source)) {
    page.edit = std::move(*edit);
  } else {
    scene.events.browse_pressed = true;  // a file, but none is named yet
  }
}

void file_rows(const SectionScene& scene) {
  FieldPage& page = scene.page;
  field_row(page, field("surface.path"));
  const Rectangle area = control_area(page, take_row(page));
  scene.events.browse_pressed |= button(page.ui, "surface.browse", part_of(page.ui, area, 0, 2), "Browse…",
                                        {"Choose a file", "A normal map, or a height field with its scale.", {}});
  scene.events.reload_pressed |= button(page.ui, "surface.reload", part_of(page.ui, area, 1, 2), "Reload",
                                        {"Read the file again", "After it was changed by another program.", {}});
}

void draw_surface(const SectionScene& scene) {
  FieldPage& page = scene.page;
  source_row(scene);
  if (is_file(page.document)) file_rows(scene);
  if (!scene.input.surface_error.empty()) sentence_row(page, sentence_text(scene.input.surface_error), true);
  if (const ReadReport* const report = report_of(scene.input)) read_report_rows(page, *report, *map_of(scene.input));
  field_row(page, field("intrinsic_roughness"));
  field_row(page, field("surface.interpolation"), {.label = "Interpolation"});
}

std::string surface_summary(const InspectorInput& input, bool open) {
  if (open) return {};
  const SurfaceDescription& surface = input.document.surface;
  const std::string map =
      is_file(input.document) ? surface.path.filename().string() : std::string(choice_name(surface.source));
  return fmt::format("{}, σ {}", map, short_number_text(input.document.intrinsic_roughness, 3));
}

float surface_height(const InspectorInput& input, bool compact) {
  const float rows = is_file(input.document) ? 5 : 3;
  return rows * size::k_row_pitch + (is_file(input.document) && !compact ? 24.0F : 0.0F);
}

// --- reading of a file, or its generator

constexpr std::array<std::string_view, 3> k_reading{"surface.range", "surface.green", "surface.height_scale"};

bool of_map_section(const Parameter& parameter) {
  return parameter.path.starts_with("surface.generator.") || parameter.path == "surface.wrap" ||
         std::find(k_reading.begin(), k_reading.end(), parameter.path) != k_reading.end();
}

void draw_map(const SectionScene& scene) {
  const auto is_wrap = [](const Parameter& parameter) { return parameter.path == "surface.wrap"; };
  for (const Parameter& parameter : parameters()) {
    if (!of_map_section(parameter) || is_wrap(parameter) || !parameter.matters(scene.page.document)) continue;
    field_row(scene.page, parameter);
  }
  field_row(scene.page, field("surface.wrap"));
}

std::string_view map_title(const Document& document) {
  return is_file(document) ? "Reading" : "Generator";
}

std::string map_summary(const InspectorInput& input, bool open) {
  if (open) return {};
  const SurfaceDescription& surface = input.document.surface;
  if (is_file(input.document)) {
    return fmt::format("green {}, {}", choice_name(surface.reading.green), choice_name(surface.reading.wrap));
  }
  return fmt::format("{} texels, seed {}", value_text(field("surface.generator.size").get(input.document)),
                     value_text(field("surface.generator.seed").get(input.document)));
}

float map_height(const InspectorInput& input, bool /*compact*/) {
  const auto all = parameters();
  const auto rows = std::count_if(all.begin(), all.end(), [&](const Parameter& parameter) {
    return of_map_section(parameter) && parameter.matters(input.document);
  });
  return static_cast<float>(rows) * size::k_row_pitch;
}

// --- footprint

void draw_footprint(const SectionScene& scene) {
  footprint_rows(scene.page, map_of(scene.input));
}

std::string footprint_summary(const InspectorInput& input, bool open) {
  if (open) return "texels";
  const Footprint& footprint = input.document.footprint;
  return fmt::format("{}, {}", short_number_text(footprint.center.x), short_number_text(footprint.center.y));
}

// --- methods

void draw_methods(const SectionScene& scene) {
  method_rows(scene.page, scene.header, map_of(scene.input), scene.input.results.get());
}

std::string methods_summary(const InspectorInput& input, bool open) {
  return open ? std::string() : edit_text(field("methods").get(input.document));
}

// --- pictures

void draw_pictures(const SectionScene& scene) {
  FieldPage& page = scene.page;
  const FittedRanges& fitted = scene.input.fitted;
  FieldLook window{.begin_with = {-1, 1, -1, 1}, .units = {"s", "s", "t", "t"}};
  if (const auto& w = fitted.window) window.meanwhile = {w->x, w->y, w->z, w->w};
  FieldLook densities{.begin_with = {0.01, 100}};
  if (const auto& d = fitted.densities) densities.meanwhile = {d->x, d->y};
  FieldLook difference{.begin_with = {1}};
  if (fitted.difference) difference.meanwhile = {*fitted.difference};
  field_row(page, field("grid.size"));
  field_row(page, field("grid.window"), window);
  field_row(page, field("view.density_scale"));
  field_row(page, field("view.density_range"), densities);
  field_row(page, field("view.difference_range"), difference);
  field_row(page, field("view.map_colors"));
  field_row(page, field("view.elements"), {.reason = sentence_text(reason_without_elements(page.document))});
}

std::string pictures_summary(const InspectorInput& input, bool open) {
  if (open) return {};
  return fmt::format("{}² cells, {}", input.document.grid.size, choice_name(input.document.view.density_scale));
}

// --- under the cursor

void draw_cursor(const SectionScene& scene) {
  const std::optional<PndfReading>* const reading = scene.input.reading;
  reading_rows(scene.page, reading && *reading ? &**reading : nullptr);
}

std::string cursor_summary(const InspectorInput& /*input*/, bool /*open*/) {
  return "P-NDF";
}

float cursor_height(const InspectorInput& input, bool compact) {
  return (static_cast<float>(input.document.methods.size()) + (compact ? 1.0F : 3.0F)) * k_reading_pitch;
}

template <int rows>
float rows_height(const InspectorInput& /*input*/, bool /*compact*/) {
  return rows * size::k_row_pitch;
}

constexpr std::array k_sections{
    InspectorSection{"section.surface", [](const Document&) { return std::string_view("Surface"); }, surface_summary,
                     surface_height, draw_surface},
    InspectorSection{"section.map", map_title, map_summary, map_height, draw_map},
    InspectorSection{"section.footprint", [](const Document&) { return std::string_view("Footprint"); },
                     footprint_summary, rows_height<4>, draw_footprint},
    InspectorSection{"section.methods", [](const Document&) { return std::string_view("Methods"); }, methods_summary,
                     rows_height<4>, draw_methods},
    InspectorSection{"section.picture", [](const Document&) { return std::string_view("Pictures"); }, pictures_summary,
                     rows_height<10>, draw_pictures},
    InspectorSection{"section.cursor", [](const Document&) { return std::string_view("Under the cursor"); },
                     cursor_summary, cursor_height, draw_cursor},
};

// Where names that begin so stand; the first that fits counts.
constexpr std::array k_places{
    std::pair{std::string_view("surface.generator."), std::string_view("section.map")},
    std::pair{std::string_view("surface.range"), std::string_view("section.map")},
    std::pair{std::string_view("surface.green"), std::string_view("section.map")},
    std::pair{std::string_view("surface.height_scale"), std::string_view("section.map")},
    std::pair{std::string_view("surface.wrap"), std::string_view("section.map")},
    std::pair{std::string_view("surface."), std::string_view("section.surface")},
    std::pair{std::string_view("intrinsic_roughness"), std::string_view("section.surface")},
    std::pair{std::string_view("footprint."), std::string_view("section.footprint")},
    std::pair{std::string_view("methods"), std::string_view("section.methods")},
    std::pair{std::string_view("exact."), std::string_view("section.methods")},
    std::pair{std::string_view("mixture."), std::string_view("section.methods")},
    std::pair{std::string_view("auto."), std::string_view("section.methods")},
    std::pair{std::string_view("binning."), std::string_view("section.methods")},
    std::pair{std::string_view("seed"), std::string_view("section.methods")},
    std::pair{std::string_view("grid."), std::string_view("section.picture")},
    std::pair{std::string_view("view."), std::string_view("section.picture")},
    std::pair{std::string_view("cursor."), std::string_view("section.cursor")},
    std::pair{std::string_view("preset"), std::string_view()},
    std::pair{std::string_view("name"), std::string_view()},
    std::pair{std::string_view("section."), std::string_view()},
};

// Whether its rows are drawn for this document: those of another source or generator are not.
bool is_shown(std::string_view control, const Document& document) {
  if (control == "surface.browse" || control == "surface.reload" || control == "surface.use_suggested_green") {
    return is_file(document);
  }
  for (const Parameter& parameter : parameters()) {
    const bool of_it = control == parameter.path || control.starts_with(std::string(parameter.path) + ".");
    if (of_it && control.starts_with("surface.")) return parameter.matters(document);
  }
  return true;
}

}  // namespace

std::span<const InspectorSection> inspector_sections() {
  return k_sections;
}

std::optional<std::string_view> section_of(std::string_view control, const Document& document) {
  if (!is_shown(control, document)) return std::nullopt;
  for (const auto& [begin, section] : k_places) {
    if (control.starts_with(begin)) return section;
  }
  return std::nullopt;
}

}  // namespace glint::view
