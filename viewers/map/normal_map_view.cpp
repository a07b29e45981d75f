#include "viewers/map/normal_map_view.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "viewers/map/element_overlay.h"
#include "viewers/map/footprint_overlay.h"
#include "viewers/map/map_controls.h"
#include "viewers/map/map_elements.h"
#include "viewers/map/map_gesture.h"
#include "viewers/map/map_inset.h"
#include "viewers/map/map_picture.h"
#include "viewers/map/map_readouts.h"
#include "viewers/map/map_tiles.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/panel.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::view {
namespace {

constexpr double k_nearest_zoom = 64;  // pixels a texel, at scale 1
constexpr double k_first_zoom = 2.5;   // where 5 sigma fit
constexpr double k_texel_zoom = 32;    // where single texels are looked at
constexpr double k_seen_width = 14;    // pixels that sigma has at least in the first view, at scale 1
constexpr float k_narrow = 300;        // a panel below that is compact
constexpr float k_low = 340;
constexpr auto k_tile_budget = std::chrono::microseconds(1500);  // a frame; one more tile may end beyond it

constexpr PanelHeader k_header{
    .name = "map",
    .title = "Normal map",
    .hint = "click places the footprint",
    .help =
        "Drag moves it, its handles shape it (Shift keeps the angle, Ctrl the ratio of its widths). The wheel zooms, "
        "the middle button or Space and the left one pan. Rings are 1, 3 and 5 σ of the pixel's footprint."};

enum class Wish { none, first_view, all, footprint, texels };

// Where the parts of the panel stand.
struct Layout {
  Rectangle toolbar;
  Rectangle picture;
  Rectangle readouts;
  bool compact = false;
};

Layout layout_of(const Ui& ui, const Rectangle& panel, const Rectangle& content, const SurfaceInUse* surface) {
  Layout layout;
  layout.compact = panel.width() < ui.px(k_narrow) || panel.height() < ui.px(k_low);
  const float left = content.min.x + ui.px(size::k_padding) - ui.px(1);
  const float right = content.max.x - ui.px(size::k_padding) + ui.px(1);
  const float top = content.min.y + ui.px(8);
  layout.toolbar = {{left, top}, {right, top + ui.px(size::k_row)}};
  const float bottom = content.max.y - ui.px(8);
  const float height = readouts_height(ui, surface, right - left, layout.compact);
  layout.readouts = {{left, std::floor(bottom - height)}, {right, bottom}};
  const float picture_top = layout.toolbar.max.y + ui.px(8);
  layout.picture = {{left, picture_top}, {right, std::max(picture_top + 1, layout.readouts.min.y - ui.px(6))}};
  return layout;
}

// A map that repeats may be given a centre in any period; the one with handles is that in the first.
Footprint shown_footprint(Footprint footprint, const NormalMap& map) {
  if (map.wrap() == Wrap::clamp) return footprint;
  footprint.center = stored_position(footprint.center, {map.width(), map.height()}, map.wrap());
  return footprint;
}

}  // namespace

struct NormalMapView::State {
  std::optional<MapTiles> tiles;
  MapInset inset;
  MapElements elements;
  ElementOverlay element_overlay;
  MapGesture gesture;
  MapCamera camera;
  ZoomRange zooms{1, 1};
  glm::ivec2 map_size{0, 0};
  Wish wish = Wish::first_view;
  std::optional<glm::dvec2> last_center;  // of the footprint in the last frame
  std::optional<MapReading> reading;
  std::optional<glm::dvec2> hovered;  // texel position under the mouse, where the map is
  MapTarget hot;

  void follow(const Ui& ui, const Rectangle& picture, const NormalMap& map, const Footprint& footprint);
  void grant(const Ui& ui, const Footprint& footprint);
  [[nodiscard]] MapScene scene(const Ui& ui, const NormalMap& map, const Footprint& footprint, bool compact) const;
  [[nodiscard]] FootprintPicture footprint_picture(const NormalMap& map, const Footprint& footprint) const;
  std::optional<FootprintEdit> navigate(Ui& ui, const NormalMapInput& input, const MapScene& scene);
  void read(const NormalMapInput& input, const MapScene& scene, const MapMouse& mouse);
  const ShownElements* shown_elements(const Ui& ui, const NormalMapInput& input, const MapScene& scene);
  void draw_picture(Ui& ui, const NormalMapInput& input, const MapScene& scene);
  void draw_chips(Ui& ui, const NormalMapInput& input, const MapScene& scene, const ShownElements* shown,
                  std::vector<Rectangle>& taken);
};

NormalMapView::NormalMapView() : state_(std::make_unique<State>()) {}
NormalMapView::~NormalMapView() = default;

// Keeps up with a panel of another size, with another map, and with a footprint that went elsewhere.
void NormalMapView::State::follow(const Ui& ui, const Rectangle& picture, const NormalMap& map,
                                  const Footprint& footprint) {
  const glm::ivec2 size(map.width(), map.height());
  if (size != map_size) wish = Wish::first_view;
  map_size = size;
  camera.picture = picture;
  zooms = zoom_range(size, picture, k_nearest_zoom * static_cast<double>(ui.scale));
  camera = kept_on_map(camera, size, zooms);
  if (wish != Wish::none) grant(ui, footprint);
  const bool went = last_center && *last_center != footprint.center && gesture.dragged().empty();
  if (went && !picture.contains(screen_of_texel(camera, footprint.center))) camera.center = footprint.center;
  camera = kept_on_map(camera, size, zooms);
  last_center = footprint.center;
}

void NormalMapView::State::grant(const Ui& ui, const Footprint& footprint) {
  const auto scale = static_cast<double>(ui.scale);
  const FootprintShape shape = shape_of(footprint.covariance);
  const glm::dvec2 extent = half_extent(ring(shape, {0, 0}, 1, 5));
  const Rectangle& picture = camera.picture;
  const double fits = 0.46 * std::min(static_cast<double>(picture.width()) / extent.x,
                                      static_cast<double>(picture.height()) / extent.y);
  double zoom = fits;
  if (wish == Wish::texels) zoom = k_texel_zoom * scale;
  if (wish == Wish::first_view) zoom = std::min(fits, std::max(k_first_zoom, k_seen_width / shape.widths.y) * scale);
  if (wish == Wish::all) {
    camera = whole_map(picture, map_size, zooms);
  } else {
    camera.center = footprint.center;
    camera.pixels_per_texel = zoom;
  }
  wish = Wish::none;
}

MapScene NormalMapView::State::scene(const Ui& ui, const NormalMap& map, const Footprint& footprint,
                                     bool compact) const {
  MapScene scene;
  scene.camera = camera;
  scene.map_size = map_size;
  scene.wrap = map.wrap();
  scene.zooms = zooms;
  scene.footprint = footprint;
  scene.handles = footprint_handles(ui, footprint_picture(map, footprint));
  scene.minimap = MapInset::area(ui, camera, map, ui.px(compact ? 46 : 62));
  scene.scale = ui.scale;
  return scene;
}

FootprintPicture NormalMapView::State::footprint_picture(const NormalMap& map, const Footprint& footprint) const {
  FootprintPicture picture;
  picture.camera = camera;
  picture.map_size = map_size;
  picture.wrap = map.wrap();
  picture.center = footprint.center;
  picture.shape = gesture.shape().value_or(shape_of(footprint.covariance));
  picture.hot = hot;
  return picture;
}

std::optional<FootprintEdit> NormalMapView::State::navigate(Ui& ui, const NormalMapInput& input,
                                                            const MapScene& scene) {
  const std::string before = gesture.dragged();
  if (!before.empty() && ui.state.dragging != before) gesture.abandon();  // somebody took the drag back
  const MapMouse mouse = mouse_over(ui, scene.camera.picture);
  const MapGesture::Step step = gesture.step(scene, mouse);
  camera = step.camera;
  const std::string after = gesture.dragged();
  if (!after.empty()) {
    ui.state.dragging = after;
  } else if (!before.empty() && ui.state.dragging == before) {
    ui.state.dragging.clear();
  }
  hot = gesture.target();
  if (after.empty() && mouse.over) hot = target_at(scene, mouse.at);
  read(input, scene, mouse);
  return step.edit;
}

void NormalMapView::State::read(const NormalMapInput& input, const MapScene& scene, const MapMouse& mouse) {
  reading.reset();
  hovered.reset();
  const bool on_picture = camera.picture.contains(mouse.at) && !(scene.minimap && scene.minimap->contains(mouse.at));
  if (!on_picture || !(mouse.over || mouse.held)) return;
  const glm::dvec2 u = texel_of_screen(camera, mouse.at);
  const int level = level_shown(*input.surface->pyramid, camera.pixels_per_texel);
  reading = reading_at(*input.surface, input.document.view.map_colors, level, u);
  if (reading) hovered = u;
}

// Null while they are not to be shown.
const ShownElements* NormalMapView::State::shown_elements(const Ui& ui, const NormalMapInput& input,
                                                          const MapScene& scene) {
  const Document& document = input.document;
  if (!document.view.elements || !reason_without_elements(document).empty()) return nullptr;
  const TexelRange range = visible_texels(camera);
  return &elements.at({input.surface,
                       document.mixture,
                       document.intrinsic_roughness,
                       scene.footprint,
                       input.crosshair,
                       {range.min, range.max},
                       camera.pixels_per_texel / static_cast<double>(ui.scale)});
}

void NormalMapView::State::draw_picture(Ui& ui, const NormalMapInput& input, const MapScene& scene) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Rectangle& picture = camera.picture;
  const NormalPyramid& pyramid = *input.surface->pyramid;
  const NormalMap& map = *pyramid.map();
  const MapColors colors = input.document.view.map_colors;
  if (!tiles) tiles.emplace(ui.gl);
  const auto budget = ui.headless ? std::chrono::steady_clock::duration::max() : k_tile_budget;
  tiles->begin_frame(input.surface->pyramid, colors, budget);
  list.AddRectFilled(picture.min, picture.max, color::k_picture);
  list.PushClipRect(picture.min, picture.max, true);
  draw_map(ui, list, camera, pyramid, *tiles);
  draw_texel_grid(ui, list, camera, map);
  const ShownElements* shown = shown_elements(ui, input, scene);
  if (shown != nullptr) element_overlay.draw(ui, list, camera, *shown);
  draw_normal_arrows(ui, list, camera, map);
  draw_map_border(ui, list, camera, map);
  if (hovered && hot.kind != MapTarget::Kind::handle) draw_texel_outline(ui, list, camera, *hovered);
  const FootprintPicture footprint = footprint_picture(map, scene.footprint);
  draw_footprint_rings(ui, list, footprint);
  std::vector<Rectangle> taken;
  if (scene.minimap) taken.push_back(*scene.minimap);
  draw_chips(ui, input, scene, shown, taken);
  draw_scale_bar(ui, list, camera, taken);
  draw_rulers(ui, list, camera, map, taken);
  draw_footprint_handles(ui, list, footprint, taken);
  if (scene.minimap) {
    inset.draw(ui, list, *scene.minimap, camera, input.surface->pyramid, colors, scene.footprint.center);
  }
  list.PopClipRect();
  list.AddRect(picture.min, picture.max, color::k_border);
}

void NormalMapView::State::draw_chips(Ui& ui, const NormalMapInput& input, const MapScene& scene,
                                      const ShownElements* shown, std::vector<Rectangle>& taken) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImVec2 at{camera.picture.min.x + ui.px(6), camera.picture.min.y + ui.px(6)};
  const float right = scene.minimap ? scene.minimap->min.x - ui.px(8) : camera.picture.max.x - ui.px(6);
  if (!input.surface_error.empty()) {
    const std::string sentence = "not the document's map: " + input.surface_error;
    const Rectangle chip = draw_chip(ui, list, at, fitted_text(ui.fonts.small, sentence, right - at.x - ui.px(12)));
    ui.widgets.record("map.error", {chip, {}, false, false});
    explain(ui, "map.error", chip, {"Not the document's map", input.surface_error, {}});
    taken.push_back(chip);
    at.y = chip.max.y + ui.px(4);
  }
  const MapColors colors = input.document.view.map_colors;
  if (const auto legend = inset.draw_legend(ui, list, at, right - at.x, colors)) {
    ui.widgets.record("map.legend", {*legend, {}, false, false});
    taken.push_back(*legend);
    at.y = legend->max.y + ui.px(4);
  }
  if (shown != nullptr) element_overlay.draw_legend(ui, list, at, right - at.x, *shown, taken);
}

NormalMapEvents NormalMapView::draw(Ui& ui, const Rectangle& area, const NormalMapInput& input) {
  State& state = *state_;
  PanelHeader header = k_header;
  header.focused = input.focused;
  header.maximised = input.maximised;
  header.busy = input.loading;
  header.progress = input.progress;
  Rectangle content;
  const PanelEvents panel = begin_panel(ui, header, area, content);
  NormalMapEvents events;
  events.export_pressed = panel.export_pressed;
  events.maximise_pressed = panel.maximise_pressed;
  events.clicked = panel.clicked;
  const Layout layout = layout_of(ui, area, content, input.surface.get());
  state.camera.picture = layout.picture;
  if (!input.surface) {
    state.reading.reset();
    events.open_pressed = draw_empty_map(ui, {layout.toolbar.min, {layout.toolbar.max.x, content.max.y - ui.px(9)}},
                                         input.surface_error, input.loading);
    end_panel();
    return events;
  }
  const NormalMap& map = input.surface->loaded.surface.map();
  Footprint footprint = shown_footprint(input.document.footprint, map);
  state.follow(ui, layout.picture, map, footprint);
  events.edit = draw_map_toolbar(ui, layout.toolbar, input.document, state.camera.pixels_per_texel);
  const MapScene before = state.scene(ui, map, footprint, layout.compact);
  if (const std::optional<FootprintEdit> edit = state.navigate(ui, input, before)) {
    Document document = input.document;
    document.footprint.covariance = edit->footprint.covariance;
    if (edit->footprint.center != footprint.center) document.footprint.center = edit->footprint.center;
    events.edit = Edit{std::move(document), edit->label, edit->finished};
    footprint = edit->footprint;  // shown at once, not a frame later
    state.last_center = footprint.center;
  }
  const MapScene scene = state.scene(ui, map, footprint, layout.compact);
  state.draw_picture(ui, input, scene);
  record_map_places(ui, scene);
  explain_map_target(ui, scene, state.hot);
  draw_readouts(ui, layout.readouts, input.surface.get(), input.document.view.map_colors, state.reading,
                layout.compact);
  end_panel();
  return events;
}

std::optional<ImVec2> NormalMapView::screen_of(glm::dvec2 u) const {
  if (state_->map_size.x == 0) return std::nullopt;
  return screen_of_texel(state_->camera, u);
}

const Rectangle& NormalMapView::picture() const {
  return state_->camera.picture;
}

double NormalMapView::zoom() const {
  return state_->camera.pixels_per_texel;
}

bool NormalMapView::incomplete() const {
  return state_->tiles && state_->tiles->incomplete();
}

void NormalMapView::zoom_by(double factor) {
  if (state_->map_size.x == 0) return;
  state_->camera = zoomed_about(state_->camera, state_->camera.picture.center(), factor, state_->zooms);
}

void NormalMapView::show_all() {
  state_->wish = Wish::all;
}

void NormalMapView::show_footprint() {
  state_->wish = Wish::footprint;
}

void NormalMapView::show_texels() {
  state_->wish = Wish::texels;
}

std::string NormalMapView::values_at_cursor() const {
  return state_->reading ? clipboard_text(*state_->reading) : std::string();
}

}  // namespace glint::view
