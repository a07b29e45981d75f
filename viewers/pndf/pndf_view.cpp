#include "viewers/pndf/pndf_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/document/names.h"
#include "viewers/pndf/color_bar.h"
#include "viewers/pndf/method_setting.h"
#include "viewers/pndf/pndf_columns.h"
#include "viewers/pndf/pndf_crosshair.h"
#include "viewers/pndf/pndf_layout.h"
#include "viewers/pndf/pndf_toolbar.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/number_text.h"
#include "viewers/widgets/panel.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::view {
namespace {

constexpr double k_dims_after = 0.2;    // seconds for which a picture may be older than the document
constexpr double k_whole_lobe = 0.995;  // of the mass: less is said
constexpr std::string_view k_panel_help =
    "Every method shows the same window with the same colours. Click pins the crosshair, a click on its ring removes "
    "it; "
    "the wheel zooms, the right button drags, a double click changes between the whole disk and the lobe.";

glm::dvec4 shown_window(const PndfInput& input) {
  if (input.document.grid.window) return *input.document.grid.window;
  return input.results ? window_of(input.results->grid) : k_whole_disk;
}

bool has_picture(const PndfInput& input) {
  if (!input.results) return false;
  const auto& methods = input.results->methods;
  return std::any_of(methods.begin(), methods.end(), [](const MethodPicture& m) { return m.image != nullptr; });
}

// The first method without a picture, where a person cancelled what would have made it.
std::optional<PndfMethod> restart_offer(const PndfInput& input) {
  if (!input.cancelled || input.nothing_because.empty()) return std::nullopt;
  for (const PndfMethod method : input.document.methods) {
    const MethodPicture* picture = picture_of(input.results.get(), method);
    if (picture == nullptr || !picture->image) return method;
  }
  return std::nullopt;
}

}  // namespace

struct PndfView::State {
  // The last difference that could be made: it stays until there is a newer one.
  struct Difference {
    std::pair<PndfMethod, PndfMethod> methods;
    ImagePointer image;
    ImagePointer reference;
    std::uint64_t revision = 0;
    bool coarse = false;
  };

  PndfPictures pictures;
  DensityBar bar;
  PndfCrosshair crosshair;
  std::optional<PndfReading> reading;
  std::optional<PndfShown> shown;
  std::map<std::string, double> stale_since;  // seconds, by picture
  std::optional<Difference> difference;
  std::vector<PndfNote> notes;  // of this frame

  bool dimmed(const Ui& ui, const std::string& key, bool stale);
  void read(const PndfInput& input);
  double largest_density(Ui& ui, const PndfInput& input);
  [[nodiscard]] std::optional<double> density_at_cursor() const;
  MethodColumn method_column(Ui& ui, const PndfInput& input, const PndfLayout& layout, PndfMethod method);
  void flip(Ui& ui, const PndfInput& input, MethodColumn& column);
  const ShownDifference* newest_difference(Ui& ui, const PndfInput& input);
  DifferenceColumn difference_column(Ui& ui, const PndfInput& input, const ShownDifference* newest);
  void note(Ui& ui, const PndfInput& input);
  std::optional<Edit> handle_pictures(Ui& ui, const PndfInput& input, const PndfLayout& layout);
  void draw_columns(Ui& ui, const PndfInput& input, const PndfLayout& layout, PndfEvents& events);
};

bool PndfView::State::dimmed(const Ui& ui, const std::string& key, bool stale) {
  if (!stale) {
    stale_since.erase(key);
    return false;
  }
  const auto [since, is_new] = stale_since.try_emplace(key, ui.seconds);
  return ui.seconds - since->second > k_dims_after;
}

std::optional<Edit> PndfView::State::handle_pictures(Ui& ui, const PndfInput& input, const PndfLayout& layout) {
  const glm::dvec4 window = shown_window(input);
  crosshair.begin_frame(window, input.results ? input.results->grid.pitch() : glm::dvec2(1.0 / 128));
  std::optional<Edit> edit;
  const auto handle = [&](const std::string& key, const Rectangle& square) {
    if (auto changed = crosshair.over_picture(ui, key, disk_place(square, window), input.document)) {
      edit = std::move(changed);
    }
  };
  for (std::size_t k = 0; k < layout.pictures.size(); ++k) {
    const PndfMethod method = input.document.methods[k];
    if (method == restart_offer(input)) continue;  // the button in it is what can be pressed
    handle(method_name(method), layout.pictures[k]);
  }
  if (layout.difference) handle("difference", *layout.difference);
  if (auto ended = crosshair.end_frame(ui, input.document)) edit = std::move(ended);
  return edit;
}

void PndfView::State::read(const PndfInput& input) {
  reading.reset();
  const std::optional<glm::dvec2> s = crosshair.position();
  if (!s) return;
  reading = PndfReading{*s, {}, std::nullopt};
  for (const PndfMethod method : input.document.methods) {
    PndfReading::Value value{method, std::nullopt, std::nullopt};
    const MethodPicture* picture = picture_of(input.results.get(), method);
    if (picture != nullptr && picture->image) {
      if (const auto cell_reading = read_cell(*picture->image, *s)) {
        value.density = cell_reading->density;
        value.standard_error = cell_reading->standard_error;
      }
    }
    reading->values.push_back(value);
  }
  if (!input.results || !input.results->reference) return;
  if (const auto cell_reading = read_cell(*input.results->reference, *s)) reading->reference = cell_reading->density;
}

// Of the newest pictures, and of the full ones among them if there are any.
double PndfView::State::largest_density(Ui& ui, const PndfInput& input) {
  if (!input.results) return 0;
  std::uint64_t newest = 0;
  for (const MethodPicture& picture : input.results->methods) {
    if (picture.image) newest = std::max(newest, picture.revision);
  }
  double full = 0;
  double coarse = 0;
  for (const MethodPicture& picture : input.results->methods) {
    if (!picture.image || picture.revision < newest) continue;
    double& largest = picture.coarse ? coarse : full;
    largest = std::max(largest, pictures.shown(ui.gl, picture.image).largest);
  }
  return full > 0 ? full : coarse;
}

// Of the picture under the mouse, else of the first that has one.
std::optional<double> PndfView::State::density_at_cursor() const {
  if (!reading) return std::nullopt;
  std::optional<double> first;
  for (const PndfReading::Value& value : reading->values) {
    if (method_name(value.method) == crosshair.hovered_picture()) return value.density;
    if (!first) first = value.density;
  }
  return first;
}

void PndfView::State::flip(Ui& ui, const PndfInput& input, MethodColumn& column) {
  const MethodPicture* exact = picture_of(input.results.get(), PndfMethod::exact);
  column.state.chips.clear();
  column.state.progress = 1;  // of another picture
  const ImagePointer own = column.picture != nullptr ? column.picture->reference : nullptr;
  const ImagePointer reference = own || !input.results ? own : input.results->reference;
  if (reference) {
    column.shown = &pictures.shown(ui.gl, reference);
    column.state.chips.push_back({"reference", {}});
  } else if (exact != nullptr && exact->image) {
    column.shown = &pictures.shown(ui.gl, exact->image);
    column.state.chips.push_back({"exact, the reference is not there yet", "exact: no reference yet"});
  } else {
    column.state.chips.push_back({"there is no reference yet", "no reference yet"});
  }
}

MethodColumn PndfView::State::method_column(Ui& ui, const PndfInput& input, const PndfLayout& layout,
                                            PndfMethod method) {
  MethodColumn column;
  column.method = method;
  column.setting = setting_text(input.document, input.results.get(), method, layout.compact());
  column.picture = picture_of(input.results.get(), method);
  column.surface = choice_name(column.picture != nullptr ? column.picture->surface : Interpolation::smooth);
  column.state.nothing = input.nothing_because;
  column.state.offers_restart = method == restart_offer(input);
  column.state.first = method == input.document.methods.front();
  column.state.focused = crosshair.focused_picture() == method_name(method);
  const auto help = [&](const std::string& said) { column.help += (column.help.empty() ? "" : "\n") + said + "."; };
  for (const PndfNote& said : notes) help(said.full);
  if (column.picture != nullptr) std::for_each(column.picture->findings.begin(), column.picture->findings.end(), help);
  if (column.picture != nullptr && column.picture->image) {
    column.shown = &pictures.shown(ui.gl, column.picture->image);
    column.state.progress = column.picture->progress;
    column.state.dimmed = dimmed(ui, method_name(method), column.picture->revision < input.revision);
    if (column.state.dimmed && input.busy) {
      column.state.awaited = true;
      column.state.progress = method == input.computing ? input.progress : 0;
    }
    if (column.picture->coarse) {
      const std::string& note = column.picture->coarse_note;
      column.state.chips.push_back({"coarse: " + note, "coarse: " + note.substr(0, note.find(','))});
    }
  } else if (column.picture != nullptr) {
    column.state.progress = column.picture->progress;
  }
  if (input.results && input.results->reference) pictures.shown(ui.gl, input.results->reference);  // ready for a flip
  if (input.flipped) flip(ui, input, column);
  return column;
}

const ShownDifference* PndfView::State::newest_difference(Ui& ui, const PndfInput& input) {
  if (input.document.methods.size() < 2) return nullptr;
  const std::pair<PndfMethod, PndfMethod> methods = difference_pair(input.document.methods);
  if (difference && difference->methods != methods) difference.reset();
  const MethodPicture* image = picture_of(input.results.get(), methods.first);
  const MethodPicture* reference = picture_of(input.results.get(), methods.second);
  const bool comparable = image != nullptr && reference != nullptr && image->image && reference->image &&
                          image->coarse == reference->coarse && image->surface == reference->surface &&
                          image->revision == reference->revision && image->image->grid == reference->image->grid;
  if (comparable) difference = Difference{methods, image->image, reference->image, image->revision, image->coarse};
  return difference ? pictures.shown_difference(ui.gl, difference->image, difference->reference) : nullptr;
}

DifferenceColumn PndfView::State::difference_column(Ui& ui, const PndfInput& input, const ShownDifference* newest) {
  const auto [image, reference] = difference_pair(input.document.methods);
  DifferenceColumn column;
  column.setting = method_name(image) + " − " + method_name(reference);
  column.shown = newest;
  column.fitted = !input.document.view.difference_range;
  column.state.focused = crosshair.focused_picture() == "difference";
  if (newest == nullptr) return column;
  column.state.dimmed = dimmed(ui, "difference", difference->revision < input.revision);
  if (difference->coarse) column.state.chips.push_back({"coarse", {}});
  if (input.document.view.difference_range && newest->difference.largest > *input.document.view.difference_range) {
    column.state.chips.push_back({"clipped", {}});
  }
  return column;
}

// What the full pictures of the newest document cannot say by themselves.
void PndfView::State::note(Ui& ui, const PndfInput& input) {
  notes.clear();
  if (!input.results) return;
  for (const MethodPicture& picture : input.results->methods) {
    if (!picture.image || picture.coarse || picture.revision < input.results->revision) continue;
    const double mass = pictures.shown(ui.gl, picture.image).mass;
    if (mass < k_whole_lobe) {
      const std::string share = percent_text(mass).value;
      notes.push_back(
          {fmt::format("the window holds {} % of the lobe", share), fmt::format("{} % of the lobe", share)});
    }
    const glm::dvec2 widening = picture.image->widening;
    if (widening != glm::dvec2(0, 0)) {
      const std::string s = number_text(widening.x, 2);
      const std::string t = number_text(widening.y, 2);
      notes.push_back(
          {fmt::format("cells hold means: σ² widened by {}{}", s, s == t ? "" : ", " + t), "cells hold means"});
    }
    if (!notes.empty()) return;
  }
}

void PndfView::State::draw_columns(Ui& ui, const PndfInput& input, const PndfLayout& layout, PndfEvents& events) {
  const ShownDifference* shown_difference = newest_difference(ui, input);
  const double largest_difference = shown_difference != nullptr ? shown_difference->difference.largest : 0;
  const PndfScene scene{shown_window(input), crosshair.position(),
                        shown_density_range(input.document.view, largest_density(ui, input)),
                        shown_difference_range(input.document.view, largest_difference)};
  if (has_picture(input)) {
    shown = PndfShown{scene.window, {scene.density.lowest, scene.density.highest}, scene.difference.highest};
  }
  for (std::size_t k = 0; k < layout.pictures.size(); ++k) {
    const MethodColumn column = method_column(ui, input, layout, input.document.methods[k]);
    if (draw_method_column(ui, layout, layout.pictures[k], scene, column)) events.restart_pressed = true;
  }
  const DensityBarInput bar_input{scene.density, !input.document.view.density_range, density_at_cursor()};
  if (const auto change = bar.draw(ui, {layout.bar, layout.title_top}, bar_input)) {
    events.edit = Edit{input.document, change->label, change->finished};
    events.edit->document.view.density_range = change->range;
  }
  if (!layout.difference) return;
  const DifferenceColumn column = difference_column(ui, input, shown_difference);
  if (const auto change = draw_difference_column(ui, layout, scene, column)) {
    events.edit = Edit{input.document, "Range of the difference", true};
    events.edit->document.view.difference_range = change->highest;
  }
}

PndfView::PndfView() : state_(std::make_unique<State>()) {}
PndfView::~PndfView() = default;

PndfEvents PndfView::draw(Ui& ui, const Rectangle& area, const PndfInput& input) {
  PndfEvents events;
  Rectangle content;
  const PanelHeader header{.name = "pndf",
                           .title = "P-NDF of the footprint",
                           .hint = "density of normals over the projected hemisphere, per unit of disk area",
                           .help = k_panel_help,
                           .focused = input.focused,
                           .maximised = input.maximised};
  const PanelEvents panel = begin_panel(ui, header, area, content);
  events.export_pressed = panel.export_pressed;
  events.maximise_pressed = panel.maximise_pressed;
  events.clicked = panel.clicked;

  const PndfLayout layout = pndf_layout(ui, content, input.document.methods.size());
  state_->note(ui, input);
  const auto take = [&](std::optional<Edit> edit) {
    if (edit) events.edit = std::move(edit);
  };
  take(draw_pndf_toolbar(ui, layout.toolbar, input.document, state_->notes, input.flip_chord));
  if (!input.nothing_because.empty() && !has_picture(input)) {
    state_->reading.reset();
    events.restart_pressed = draw_empty_body(ui, layout.body, input.nothing_because, input.cancelled);
  } else {
    take(state_->handle_pictures(ui, input, layout));
    state_->read(input);
    state_->draw_columns(ui, input, layout, events);
  }
  state_->pictures.forget_unused();
  end_panel();
  return events;
}

const std::optional<PndfReading>& PndfView::reading() const {
  return state_->reading;
}

const std::optional<PndfShown>& PndfView::shown() const {
  return state_->shown;
}

std::string PndfView::reading_text() const {
  if (!state_->reading) return {};
  const PndfReading& reading = *state_->reading;
  std::string text = fmt::format("s {}\nt {}\n", copy_text(reading.s.x), copy_text(reading.s.y));
  for (const PndfReading::Value& value : reading.values) {
    if (!value.density) continue;
    text += fmt::format("D {} {}", method_name(value.method), copy_text(*value.density));
    if (value.standard_error) text += fmt::format(" standard error {}", copy_text(*value.standard_error));
    text += '\n';
  }
  if (reading.reference) text += fmt::format("D reference {}\n", copy_text(*reading.reference));
  return text;
}

Edit PndfView::zoomed(const Document& document, double notches) const {
  return state_->crosshair.zoomed(document, notches);
}

}  // namespace glint::view
