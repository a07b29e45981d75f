#include "viewers/map/map_camera.h"

#include <algorithm>
#include <cmath>

namespace glint::view {
namespace {

constexpr double k_share_of_picture = 0.96;  // that the whole map fills

double wrapped(double x, double size) {
  const double inside = x - size * std::floor(x / size);
  return inside < size ? inside : 0;  // rounding may reach the size itself
}

}  // namespace

ImVec2 screen_of_texel(const MapCamera& camera, glm::dvec2 u) {
  const ImVec2 middle = camera.picture.center();
  return {static_cast<float>(static_cast<double>(middle.x) + (u.x - camera.center.x) * camera.pixels_per_texel),
          static_cast<float>(static_cast<double>(middle.y) + (u.y - camera.center.y) * camera.pixels_per_texel)};
}

glm::dvec2 texel_of_screen(const MapCamera& camera, ImVec2 pixel) {
  const ImVec2 middle = camera.picture.center();
  return camera.center + glm::dvec2(pixel.x - middle.x, pixel.y - middle.y) / camera.pixels_per_texel;
}

TexelRange visible_texels(const MapCamera& camera) {
  return {texel_of_screen(camera, camera.picture.min), texel_of_screen(camera, camera.picture.max)};
}

ZoomRange zoom_range(glm::ivec2 map_size, const Rectangle& picture, double nearest) {
  const double fit = k_share_of_picture * std::min(static_cast<double>(std::max(picture.width(), 1.0F)) / map_size.x,
                                                   static_cast<double>(std::max(picture.height(), 1.0F)) / map_size.y);
  return {std::min(fit, nearest), nearest};
}

MapCamera zoomed_about(const MapCamera& camera, ImVec2 fixed, double factor, const ZoomRange& range) {
  const glm::dvec2 anchor = texel_of_screen(camera, fixed);
  MapCamera result = camera;
  result.pixels_per_texel = std::clamp(camera.pixels_per_texel * factor, range.lowest, range.highest);
  result.center = anchor + (camera.center - anchor) * (camera.pixels_per_texel / result.pixels_per_texel);
  return result;
}

MapCamera panned(const MapCamera& camera, ImVec2 by) {
  MapCamera result = camera;
  result.center -= glm::dvec2(by.x, by.y) / camera.pixels_per_texel;
  return result;
}

MapCamera kept_on_map(const MapCamera& camera, glm::ivec2 map_size, const ZoomRange& range) {
  MapCamera result = camera;
  result.pixels_per_texel = std::clamp(camera.pixels_per_texel, range.lowest, range.highest);
  result.center = {std::clamp(camera.center.x, 0.0, static_cast<double>(map_size.x)),
                   std::clamp(camera.center.y, 0.0, static_cast<double>(map_size.y))};
  return result;
}

MapCamera whole_map(const Rectangle& picture, glm::ivec2 map_size, const ZoomRange& range) {
  return {picture, 0.5 * glm::dvec2(map_size), range.lowest};
}

glm::dvec2 stored_position(glm::dvec2 u, glm::ivec2 map_size, Wrap wrap) {
  const glm::dvec2 size(map_size);
  if (wrap == Wrap::repeat) return {wrapped(u.x, size.x), wrapped(u.y, size.y)};
  return {std::clamp(u.x, 0.0, size.x), std::clamp(u.y, 0.0, size.y)};
}

bool on_map(glm::dvec2 u, glm::ivec2 map_size, Wrap wrap) {
  return wrap == Wrap::repeat || (u.x >= 0 && u.y >= 0 && u.x <= map_size.x && u.y <= map_size.y);
}

double rounded_down_step(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  const double lead = most / power;
  return power * (lead < 2 ? 1 : lead < 5 ? 2 : 5);
}

}  // namespace glint::view
