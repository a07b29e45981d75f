#include "gui/window/panels.h"

#include <utility>

#include "viewers/map/map_elements.h"

namespace glint::gui {
namespace {

const view::Rectangle& area_of(const Layout& layout, Panel panel) {
  return layout.panels[static_cast<std::size_t>(panel)];
}

template <class Events>
void take_common(const Events& events, Panel panel, PanelWishes& wishes, Panel& focused) {
  if (events.clicked) focused = panel;
  if (events.maximise_pressed) wishes.maximise = panel;
  if (events.export_pressed) wishes.export_of = panel;
}

// Why there is no picture and none is coming.
std::string nothing_because(const DocumentJobs& jobs) {
  if (jobs.cancelled()) return "Cancelled. Nothing is computed until the document changes.";
  if (!jobs.surface() && jobs.surface_error()) return "Without a map there is no P-NDF.";
  return {};
}

}  // namespace

PanelWishes Panels::draw(view::Ui& ui, const Layout& layout, Workbench& workbench, bool flipped) {
  PanelWishes wishes;
  const auto drawn = [&](Panel panel, auto&& body) {
    const std::size_t first = ui.widgets.order().size();
    if (area_of(layout, panel).width() > 0) body();
    ranges_[static_cast<std::size_t>(panel)] = {first, ui.widgets.order().size()};
  };
  map_drawn_ = area_of(layout, Panel::map).width() > 0;
  drawn(Panel::map, [&] { draw_map(ui, layout, workbench, wishes); });
  drawn(Panel::pndf, [&] { draw_pndf(ui, layout, workbench, flipped, wishes); });
  drawn(Panel::inspector, [&] { draw_inspector(ui, layout, workbench, wishes); });
  return wishes;
}

bool Panels::incomplete(const Document& document) const {
  if (!map_drawn_) return false;
  const auto& reading = pndf_.reading();
  const std::optional<glm::dvec2> crosshair = reading ? std::optional(reading->s) : std::nullopt;
  const bool elements = document.view.elements && view::reason_without_elements(document).empty();
  return map_.incomplete() || (elements && crosshair != crosshair_on_map_);
}

std::optional<Panel> Panels::panel_of(std::size_t widget_index) const {
  for (std::size_t k = 0; k < ranges_.size(); ++k) {
    if (widget_index >= ranges_[k].first && widget_index < ranges_[k].second) return static_cast<Panel>(k);
  }
  return std::nullopt;
}

void Panels::draw_map(view::Ui& ui, const Layout& layout, Workbench& workbench, PanelWishes& wishes) {
  const DocumentJobs& jobs = workbench.jobs();
  const JobStatus status = jobs.status();
  view::NormalMapInput input{.document = workbench.document(), .surface = jobs.surface()};
  input.surface_error = jobs.surface_error() ? jobs.surface_error()->message() : std::string();
  input.loading = status.busy && !status.method && (jobs.opening() || jobs.loading_surface());
  input.progress = status.progress;
  input.focused = focused_ == Panel::map;
  input.maximised = workbench.settings().maximised_panel == panel_name(Panel::map);
  if (const auto& reading = pndf_.reading()) input.crosshair = reading->s;
  crosshair_on_map_ = input.crosshair;
  view::NormalMapEvents events = map_.draw(ui, area_of(layout, Panel::map), input);
  take_common(events, Panel::map, wishes, focused_);
  if (events.open_pressed) wishes.open = true;
  if (events.edit) workbench.apply(*std::move(events.edit));
}

void Panels::draw_pndf(view::Ui& ui, const Layout& layout, Workbench& workbench, bool flipped, PanelWishes& wishes) {
  const DocumentJobs& jobs = workbench.jobs();
  view::PndfInput input{.document = workbench.document()};
  input.revision = workbench.editor().revision();
  input.results = jobs.results();
  input.nothing_because = nothing_because(jobs);
  input.cancelled = jobs.cancelled();
  const JobStatus status = jobs.status();
  input.busy = status.busy;
  input.computing = status.method;
  input.progress = status.progress;
  input.flipped = flipped;
  input.flip_chord = "R";
  input.focused = focused_ == Panel::pndf;
  input.maximised = workbench.settings().maximised_panel == panel_name(Panel::pndf);
  view::PndfEvents events = pndf_.draw(ui, area_of(layout, Panel::pndf), input);
  take_common(events, Panel::pndf, wishes, focused_);
  if (events.restart_pressed) wishes.restart = true;
  if (events.edit) workbench.apply(*std::move(events.edit));
}

void Panels::draw_inspector(view::Ui& ui, const Layout& layout, Workbench& workbench, PanelWishes& wishes) {
  const DocumentJobs& jobs = workbench.jobs();
  std::vector<std::string> names;
  names.reserve(workbench.presets().size());
  for (const PresetEntry& entry : workbench.presets()) names.push_back(entry.name);
  view::InspectorInput input{.document = workbench.document(), .saved = workbench.editor().saved()};
  input.is_saved = workbench.editor().is_saved();
  input.surface = jobs.surface();
  input.surface_error = jobs.surface_error() ? jobs.surface_error()->message() : std::string();
  input.presets = std::move(names);
  input.reading = &pndf_.reading();
  input.results = jobs.results();
  if (const auto& shown = pndf_.shown()) input.fitted = {shown->window, shown->densities, shown->difference};
  input.open_sections = &workbench.settings().open_sections;
  input.focused = focused_ == Panel::inspector;
  input.maximised = workbench.settings().maximised_panel == panel_name(Panel::inspector);
  view::InspectorEvents events = inspector_.draw(ui, area_of(layout, Panel::inspector), input);
  take_common(events, Panel::inspector, wishes, focused_);
  wishes.preset = std::move(events.preset);
  wishes.browse_map = events.browse_pressed;
  wishes.save = events.save_pressed;
  wishes.save_as = events.save_as_pressed;
  wishes.revert = events.revert_pressed;
  wishes.reload = events.reload_pressed;
  if (events.section) workbench.settings().open_sections[events.section->first] = events.section->second;
  if (events.edit) workbench.apply(*std::move(events.edit));
}

}  // namespace glint::gui
