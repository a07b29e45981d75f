#include "viewers/map/map_gesture.h"

#include <cmath>

#include <fmt/format.h>

namespace glint::view {
namespace {

constexpr double k_zoom_per_notch = 1.25;
constexpr float k_click_tremor = 3;  // pixels at scale 1 that a click may wander
constexpr float k_handle_reach = 7;
constexpr float k_center_reach = 6;

bool near(ImVec2 a, ImVec2 b, float reach) {
  return std::hypot(a.x - b.x, a.y - b.y) <= reach;
}

ImVec2 minus(ImVec2 a, ImVec2 b) {
  return {a.x - b.x, a.y - b.y};
}

glm::dvec2 texel_center(glm::dvec2 u) {
  return {std::floor(u.x) + 0.5, std::floor(u.y) + 0.5};
}

// On a map that clamps, the centre of the last texel is the last one there is.
glm::dvec2 footprint_center(const MapScene& scene, glm::dvec2 u, bool snap) {
  glm::dvec2 stored = stored_position(u, scene.map_size, scene.wrap);
  if (!snap) return stored;
  for (int axis = 0; axis < 2; ++axis) {
    if (stored[axis] >= scene.map_size[axis]) stored[axis] = scene.map_size[axis] - 0.5;
  }
  return texel_center(stored);
}

}  // namespace

glm::dvec2 texel_of_minimap(const Rectangle& minimap, glm::ivec2 map_size, ImVec2 pixel) {
  return glm::dvec2(map_size) *
         glm::dvec2((pixel.x - minimap.min.x) / minimap.width(), (pixel.y - minimap.min.y) / minimap.height());
}

ImVec2 minimap_of_texel(const Rectangle& minimap, glm::ivec2 map_size, glm::dvec2 u) {
  return {minimap.min.x + static_cast<float>(u.x / map_size.x) * minimap.width(),
          minimap.min.y + static_cast<float>(u.y / map_size.y) * minimap.height()};
}

MapTarget target_at(const MapScene& scene, ImVec2 mouse) {
  if (!scene.camera.picture.contains(mouse)) return {};
  if (scene.minimap && scene.minimap->contains(mouse)) return {MapTarget::Kind::minimap, 0};
  if (const std::optional<int> handle = handle_at(scene.handles, mouse, k_handle_reach * scene.scale)) {
    return {MapTarget::Kind::handle, *handle};
  }
  const ImVec2 center = screen_of_texel(scene.camera, scene.footprint.center);
  if (near(center, mouse, k_center_reach * scene.scale)) return {MapTarget::Kind::center, 0};
  const bool has_ground = on_map(texel_of_screen(scene.camera, mouse), scene.map_size, scene.wrap);
  return {has_ground ? MapTarget::Kind::ground : MapTarget::Kind::nothing, 0};
}

MapGesture::Step MapGesture::step(const MapScene& scene, const MapMouse& mouse) {
  Step result{scene.camera, std::nullopt};
  if (held_ == Held::nothing && mouse.pressed && mouse.over) press(scene, mouse);
  if (held_ != Held::nothing) {
    if (!near(mouse.at, pressed_at_, k_click_tremor * scene.scale)) moved_ = true;
    if (held_ == Held::view || held_ == Held::minimap) {
      move_view(scene, mouse, result.camera);
    } else {
      result.edit = drag(scene, mouse);
    }
    last_ = mouse.at;
    last_shift_ = mouse.shift;
    last_ctrl_ = mouse.ctrl;
    if (!mouse.held) held_ = Held::nothing;
  }
  if (mouse.over && mouse.wheel != 0 && held_ != Held::minimap) {
    const double factor = std::pow(k_zoom_per_notch, static_cast<double>(mouse.wheel));
    result.camera = zoomed_about(result.camera, mouse.at, factor, scene.zooms);
  }
  result.camera = kept_on_map(result.camera, scene.map_size, scene.zooms);
  return result;
}

void MapGesture::press(const MapScene& scene, const MapMouse& mouse) {
  const MapTarget target = target_at(scene, mouse.at);
  moved_ = false;
  pressed_at_ = last_ = mouse.at;
  last_shift_ = mouse.shift;
  last_ctrl_ = mouse.ctrl;
  const ImVec2 center = screen_of_texel(scene.camera, scene.footprint.center);
  if (target.kind == MapTarget::Kind::minimap) {
    held_ = Held::minimap;
  } else if (mouse.pans) {
    held_ = Held::view;
  } else if (target.kind == MapTarget::Kind::handle) {
    held_ = Held::handle;
    handle_ = target.handle;
    start_ = shape_ = shape_of(scene.footprint.covariance);
    // A handle of a small ellipse stands further out than its axis ends: what is dragged is the end of the axis.
    const ScreenEllipse ellipse = ring(start_, glm::dvec2(center.x, center.y), scene.camera.pixels_per_texel, 1);
    grab_ = minus(mouse.at, handle_positions(ellipse, 0)[static_cast<std::size_t>(handle_)]);
  } else if (target.kind == MapTarget::Kind::center) {
    held_ = Held::center;
    grab_ = minus(mouse.at, center);
  } else if (target.kind == MapTarget::Kind::ground) {
    held_ = Held::ground;
    grab_ = {0, 0};
  }
}

void MapGesture::move_view(const MapScene& scene, const MapMouse& mouse, MapCamera& camera) {
  if (held_ == Held::minimap) {
    if (scene.minimap) camera.center = texel_of_minimap(*scene.minimap, scene.map_size, mouse.at);
  } else {
    camera = panned(camera, minus(mouse.at, last_));
  }
}

Footprint MapGesture::dragged_footprint(const MapScene& scene, const MapMouse& mouse) {
  Footprint footprint = scene.footprint;
  const glm::dvec2 u = texel_of_screen(scene.camera, minus(mouse.at, grab_));
  if (held_ == Held::handle) {
    const AxisEnd end = k_axis_ends[static_cast<std::size_t>(handle_)];
    shape_ = with_axis_end(start_, end, u - footprint.center, {mouse.shift, mouse.ctrl});
    footprint.covariance = covariance_of(shape_);
  } else {
    footprint.center = footprint_center(scene, u, mouse.shift);
  }
  return footprint;
}

std::optional<FootprintEdit> MapGesture::drag(const MapScene& scene, const MapMouse& mouse) {
  if (!moved_) {
    if (mouse.held || held_ != Held::ground) return std::nullopt;
    FootprintEdit edit{scene.footprint, {}, true};
    edit.footprint.center = footprint_center(scene, texel_of_screen(scene.camera, pressed_at_), mouse.shift);
    edit.label = fmt::format("Footprint to {:.1f}, {:.1f}", edit.footprint.center.x, edit.footprint.center.y);
    return edit;
  }
  const bool same =
      mouse.at.x == last_.x && mouse.at.y == last_.y && mouse.shift == last_shift_ && mouse.ctrl == last_ctrl_;
  if (same && mouse.held) return std::nullopt;
  const char* label = held_ == Held::handle ? "Shape the footprint" : "Move the footprint";
  return FootprintEdit{dragged_footprint(scene, mouse), label, !mouse.held};
}

std::string MapGesture::dragged() const {
  switch (held_) {
    case Held::view:
      return "map.pan";
    case Held::ground:
      return "map.picture";
    case Held::center:
      return "map.center";
    case Held::handle:
      return fmt::format("map.handle.{}", handle_ + 1);
    case Held::minimap:
      return "map.minimap";
    case Held::nothing:
      break;
  }
  return {};
}

std::optional<FootprintShape> MapGesture::shape() const {
  if (held_ != Held::handle) return std::nullopt;
  return shape_;
}

MapTarget MapGesture::target() const {
  switch (held_) {
    case Held::handle:
      return {MapTarget::Kind::handle, handle_};
    case Held::minimap:
      return {MapTarget::Kind::minimap, 0};
    case Held::center:
    case Held::ground:
      return {MapTarget::Kind::center, 0};
    case Held::view:
    case Held::nothing:
      break;
  }
  return {};
}

}  // namespace glint::view
