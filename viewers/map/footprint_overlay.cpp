#include "viewers/map/footprint_overlay.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"

namespace glint::view {
namespace {

constexpr float k_least_handle_distance = 15;  // from the centre, pixels at scale 1
constexpr float k_least_period = 60;           // pixels at scale 1: a map shown smaller has no copies of the footprint

glm::dvec2 as_double(ImVec2 p) {
  return {p.x, p.y};
}

Rectangle grown(const Rectangle& area, float by) {
  return {{area.min.x - by, area.min.y - by}, {area.max.x + by, area.max.y + by}};
}

ScreenEllipse ring_of(const FootprintPicture& footprint, double deviations) {
  const MapCamera& camera = footprint.camera;
  return ring(footprint.shape, as_double(screen_of_texel(camera, footprint.center)), camera.pixels_per_texel,
              deviations);
}

struct Stroke {
  ImU32 ink;
  float thickness;
  bool dashed;
};

void draw_ring(const Ui& ui, ImDrawList& list, const ScreenEllipse& ellipse, const Rectangle& picture, Stroke stroke) {
  for (const Arc& arc : visible_arcs(ellipse, grown(picture, ui.px(4)))) {
    if (stroke.dashed) {
      draw_dashed_over(list, arc.points, arc.closed, stroke.ink, stroke.thickness, ui.px(6), ui.px(4));
    } else {
      draw_polyline_over(list, arc.points, arc.closed, stroke.ink, stroke.thickness);
    }
  }
}

// Just outside the ring, first choice at its lower right.
void draw_ring_label(const Ui& ui, ImDrawList& list, const ScreenEllipse& ellipse, const Rectangle& picture,
                     std::string_view text, std::vector<Rectangle>& taken) {
  const ImVec2 extent = text_size(ui.fonts.small, text);
  const double away = 0.5 * std::hypot(static_cast<double>(extent.x), static_cast<double>(extent.y)) + ui.scale * 1.0;
  for (const double degrees : {55.0, 125.0, -125.0, -55.0, 90.0, 20.0, 160.0, -90.0, 0.0, 180.0}) {
    // The point of the ring whose outward normal has this direction.
    const glm::dvec2 n(std::cos(degrees * std::numbers::pi / 180), std::sin(degrees * std::numbers::pi / 180));
    const double along_a = ellipse.a.x * n.x + ellipse.a.y * n.y;
    const double along_b = ellipse.b.x * n.x + ellipse.b.y * n.y;
    const double reach = std::max(std::hypot(along_a, along_b), 1e-9);
    const glm::dvec2 p = ellipse.center + (along_a / reach) * ellipse.a + (along_b / reach) * ellipse.b + away * n;
    const ImVec2 at{static_cast<float>(p.x) - 0.5F * extent.x, static_cast<float>(p.y) - 0.5F * extent.y};
    const Rectangle area{at, {at.x + extent.x, at.y + extent.y}};
    const Rectangle inside = grown(picture, -ui.px(3));
    if (!inside.contains(area.min) || !inside.contains(area.max) || overlaps_any(area, taken)) continue;
    draw_text_over(ui, list, ui.fonts.small, at, color::k_text, text);
    taken.push_back(area);
    return;
  }
}

void draw_handle(const Ui& ui, ImDrawList& list, ImVec2 at, bool hot) {
  const float half = hot ? ui.px(5) : ui.px(4);
  const ImVec2 low{std::floor(at.x + 0.5F) - half, std::floor(at.y + 0.5F) - half};
  const ImVec2 high{low.x + 2 * half, low.y + 2 * half};
  list.AddRectFilled({low.x - 1, low.y - 1}, {high.x + 1, high.y + 1}, color::k_window);
  list.AddRectFilled(low, high, hot ? color::k_accent_hover : color::k_accent);
}

void draw_center(const Ui& ui, ImDrawList& list, ImVec2 at, ImU32 ink, float radius) {
  list.AddCircleFilled(at, radius * ui.scale + 1.5F, color::k_under_stroke, 16);
  list.AddCircleFilled(at, radius * ui.scale, ink, 16);
}

// The footprint acts in every period alike; only one of them has handles.
void draw_copies(const Ui& ui, ImDrawList& list, const FootprintPicture& footprint) {
  const MapCamera& camera = footprint.camera;
  const glm::dvec2 period = glm::dvec2(footprint.map_size) * camera.pixels_per_texel;
  if (footprint.wrap != Wrap::repeat || std::min(period.x, period.y) < static_cast<double>(k_least_period * ui.scale)) {
    return;
  }
  const glm::dvec2 center = as_double(screen_of_texel(camera, footprint.center));
  const Rectangle& picture = camera.picture;
  const glm::dvec2 reach = half_extent(ring(footprint.shape, center, camera.pixels_per_texel, 1));
  const auto first = [&](double low, int axis) {
    return static_cast<int>(std::max(-50.0, std::ceil((low - center[axis] - reach[axis]) / period[axis])));
  };
  const auto last = [&](double high, int axis) {
    return static_cast<int>(std::min(50.0, std::floor((high - center[axis] + reach[axis]) / period[axis])));
  };
  constexpr ImU32 k_faint = rgb(0xF2953C, 150);
  for (int ky = first(static_cast<double>(picture.min.y), 1); ky <= last(static_cast<double>(picture.max.y), 1); ++ky) {
    for (int kx = first(static_cast<double>(picture.min.x), 0); kx <= last(static_cast<double>(picture.max.x), 0);
         ++kx) {
      if (kx == 0 && ky == 0) continue;
      const glm::dvec2 there = center + glm::dvec2(kx, ky) * period;
      draw_ring(ui, list, ring(footprint.shape, there, camera.pixels_per_texel, 1), picture,
                {k_faint, ui.scale, false});
      draw_center(ui, list, {static_cast<float>(there.x), static_cast<float>(there.y)}, k_faint, 1.5F);
    }
  }
}

}  // namespace

bool overlaps_any(const Rectangle& area, const std::vector<Rectangle>& others) {
  return std::any_of(others.begin(), others.end(), [&](const Rectangle& other) { return overlap(area, other); });
}

std::array<ImVec2, 4> footprint_handles(const Ui& ui, const FootprintPicture& footprint) {
  return handle_positions(ring_of(footprint, 1), static_cast<double>(ui.px(k_least_handle_distance)));
}

void draw_footprint_rings(const Ui& ui, ImDrawList& list, const FootprintPicture& footprint) {
  draw_copies(ui, list, footprint);
  const Rectangle& picture = footprint.camera.picture;
  draw_ring(ui, list, ring_of(footprint, 5), picture, {color::k_accent, 1.4F * ui.scale, true});
  draw_ring(ui, list, ring_of(footprint, 3), picture, {color::k_accent, 1.4F * ui.scale, false});
  draw_ring(ui, list, ring_of(footprint, 1), picture, {color::k_accent, 2 * ui.scale, false});
}

void draw_footprint_handles(const Ui& ui, ImDrawList& list, const FootprintPicture& footprint,
                            std::vector<Rectangle>& taken) {
  const ScreenEllipse one_sigma = ring_of(footprint, 1);
  const ImVec2 middle = screen_of_texel(footprint.camera, footprint.center);
  const bool center_is_hot = footprint.hot.kind == MapTarget::Kind::center;
  const std::array<ImVec2, 4> ends = handle_positions(one_sigma, 0);
  const std::array<ImVec2, 4> handles = footprint_handles(ui, footprint);
  for (std::size_t k = 0; k < handles.size(); ++k) {
    // A stem where the handle stands outside its ring.
    const float out = std::hypot(handles[k].x - ends[k].x, handles[k].y - ends[k].y);
    if (out > ui.px(2)) draw_line_over(list, ends[k], handles[k], color::k_accent, ui.px(1));
  }
  draw_center(ui, list, middle, center_is_hot ? color::k_accent_hover : color::k_accent, center_is_hot ? 3.5F : 2.5F);
  for (std::size_t k = 0; k < handles.size(); ++k) {
    const bool hot = footprint.hot == MapTarget{MapTarget::Kind::handle, static_cast<int>(k)};
    draw_handle(ui, list, handles[k], hot);
    taken.push_back(grown({handles[k], handles[k]}, ui.px(6)));
  }
  const glm::dvec2 extent = half_extent(one_sigma);
  if (std::max(extent.x, extent.y) < static_cast<double>(ui.px(7))) return;  // rings too near each other to be named
  const Rectangle& picture = footprint.camera.picture;
  draw_ring_label(ui, list, ring_of(footprint, 3), picture, "3σ", taken);
  draw_ring_label(ui, list, ring_of(footprint, 5), picture, "5σ", taken);
}

}  // namespace glint::view
