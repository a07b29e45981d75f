#include "viewers/map/map_picture.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "viewers/map/footprint_overlay.h"
#include "viewers/pndf/axis_ticks.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/theme.h"

namespace glint::view {
namespace {

constexpr double k_pixels_for_squares = 4;  // a texel of at least that size is a square: nothing is invented between
constexpr float k_least_period = 24;        // pixels at scale 1: a map shown smaller than that is not repeated
constexpr float k_pixels_for_grid = 8;
constexpr float k_pixels_for_arrows = 20;
constexpr float k_pixels_for_outline = 4;

struct Periods {
  glm::ivec2 first{0, 0};
  glm::ivec2 last{0, 0};
};

Periods visible_periods(const Ui& ui, const MapCamera& camera, const NormalMap& map) {
  Periods periods;
  if (map.wrap() == Wrap::clamp) return periods;
  const TexelRange range = visible_texels(camera);
  const glm::ivec2 size(map.width(), map.height());
  for (int axis = 0; axis < 2; ++axis) {
    if (size[axis] * camera.pixels_per_texel < static_cast<double>(k_least_period * ui.scale)) continue;
    periods.first[axis] = static_cast<int>(std::floor(range.min[axis] / size[axis]));
    periods.last[axis] = static_cast<int>(std::ceil(range.max[axis] / size[axis])) - 1;
  }
  return periods;
}

// The part [from, to] of the map, texels of the first period, drawn at `origin` of a period from the tile found for it.
void draw_tile(Ui& ui, ImDrawList& list, const MapCamera& camera, glm::dvec2 origin, glm::dvec2 from, glm::dvec2 to,
               const MapTiles::Found& found) {
  const double texel = std::ldexp(1.0, found.key.level);
  const glm::dvec2 first = glm::dvec2(found.key.x, found.key.y) * static_cast<double>(k_tile_texels) - 1.0;
  const auto coordinate = [&](glm::dvec2 u) {
    const glm::dvec2 at = (u / texel - first) / glm::dvec2(found.texture->size());
    return ImVec2(static_cast<float>(at.x), static_cast<float>(at.y));
  };
  const bool nearest = found.key.level == 0 && camera.pixels_per_texel >= k_pixels_for_squares;
  list.AddImage(ui.pictures.add(*found.texture, {.nearest = nearest}), screen_of_texel(camera, origin + from),
                screen_of_texel(camera, origin + to), coordinate(from), coordinate(to));
}

void draw_period(Ui& ui, ImDrawList& list, const MapCamera& camera, glm::dvec2 origin, const NormalPyramid& pyramid,
                 MapTiles& tiles, int level) {
  const double side = std::ldexp(static_cast<double>(k_tile_texels), level);  // of a tile, in texels of the map
  const glm::dvec2 size(pyramid.width(0), pyramid.height(0));
  const TexelRange range = visible_texels(camera);
  const glm::ivec2 count = tile_count(pyramid, level);
  glm::ivec2 first;
  glm::ivec2 last;
  for (int axis = 0; axis < 2; ++axis) {
    first[axis] = static_cast<int>(std::clamp(std::floor((range.min[axis] - origin[axis]) / side), 0.0, 1e6));
    last[axis] = static_cast<int>(std::clamp(std::floor((range.max[axis] - origin[axis]) / side), -1.0, 1e6));
    last[axis] = std::min(last[axis], count[axis] - 1);
  }
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      const glm::dvec2 from = glm::dvec2(x, y) * side;
      const glm::dvec2 to(std::min(from.x + side, size.x), std::min(from.y + side, size.y));
      draw_tile(ui, list, camera, origin, from, to, tiles.find({level, x, y}));
    }
  }
}

ImVec2 whole(ImVec2 p) {
  return {std::floor(p.x + 0.5F), std::floor(p.y + 0.5F)};
}

struct TexelBlock {
  int i0;
  int j0;
  int i1;  // one beyond the last
  int j1;
};
TexelBlock visible_block(const MapCamera& camera, const NormalMap& map) {
  const TexelRange range = visible_texels(camera);
  TexelBlock block{static_cast<int>(std::floor(range.min.x)), static_cast<int>(std::floor(range.min.y)),
                   static_cast<int>(std::ceil(range.max.x)), static_cast<int>(std::ceil(range.max.y))};
  if (map.wrap() == Wrap::clamp) {
    block = {std::max(block.i0, 0), std::max(block.j0, 0), std::min(block.i1, map.width()),
             std::min(block.j1, map.height())};
  }
  return block;
}

// Shaft and head; `grow` makes the under-stroke of the same arrow, wider all round.
void draw_arrow(ImDrawList& list, ImVec2 from, ImVec2 by, float thickness, float head, float grow, ImU32 ink) {
  const float length = std::hypot(by.x, by.y);
  const ImVec2 along{by.x / length, by.y / length};
  const float size = std::min(head, 0.5F * length);  // short arrows keep a shaft
  const ImVec2 neck{from.x + by.x - along.x * size, from.y + by.y - along.y * size};
  const float reach = size + 1.8F * grow;
  const float half = 0.45F * size + 1.2F * grow;
  const ImVec2 tip{neck.x + along.x * reach, neck.y + along.y * reach};
  const ImVec2 base{neck.x - along.x * grow, neck.y - along.y * grow};
  list.AddLine(from, neck, ink, thickness + 2 * grow);
  list.AddTriangleFilled(tip, {base.x - half * along.y, base.y + half * along.x},
                         {base.x + half * along.y, base.y - half * along.x}, ink);
}

}  // namespace

int level_shown(const NormalPyramid& pyramid, double pixels_per_texel) {
  const auto level = static_cast<int>(std::floor(std::log2(1 / pixels_per_texel)));
  return std::clamp(level, 0, pyramid.levels() - 1);
}

void draw_map(Ui& ui, ImDrawList& list, const MapCamera& camera, const NormalPyramid& pyramid, MapTiles& tiles) {
  const int level = level_shown(pyramid, camera.pixels_per_texel);
  const Periods periods = visible_periods(ui, camera, *pyramid.map());
  for (int ky = periods.first.y; ky <= periods.last.y; ++ky) {
    for (int kx = periods.first.x; kx <= periods.last.x; ++kx) {
      const glm::dvec2 origin(static_cast<double>(kx) * pyramid.width(0), static_cast<double>(ky) * pyramid.height(0));
      draw_period(ui, list, camera, origin, pyramid, tiles, level);
    }
  }
}

void draw_map_border(const Ui& ui, ImDrawList& list, const MapCamera& camera, const NormalMap& map) {
  const Rectangle& picture = camera.picture;
  const ImVec2 low = whole(screen_of_texel(camera, {0, 0}));
  const ImVec2 high = whole(screen_of_texel(camera, {map.width(), map.height()}));
  const float left = std::clamp(low.x, picture.min.x, picture.max.x);
  const float right = std::clamp(high.x, picture.min.x, picture.max.x);
  const float top = std::clamp(low.y, picture.min.y, picture.max.y);
  const float bottom = std::clamp(high.y, picture.min.y, picture.max.y);
  constexpr ImU32 k_shade = rgb(0x000000, 115);
  if (map.wrap() == Wrap::repeat) {
    list.AddRectFilled(picture.min, {picture.max.x, top}, k_shade);
    list.AddRectFilled({picture.min.x, bottom}, picture.max, k_shade);
    list.AddRectFilled({picture.min.x, top}, {left, bottom}, k_shade);
    list.AddRectFilled({right, top}, {picture.max.x, bottom}, k_shade);
  }
  const float line = ui.px(1);
  const auto edge = [&](ImVec2 a, ImVec2 b) { list.AddRectFilled(a, b, rgb(0xFFFFFF, 130)); };
  if (low.x > picture.min.x) edge({low.x - line, top}, {low.x, bottom});
  if (high.x < picture.max.x) edge({high.x, top}, {high.x + line, bottom});
  if (low.y > picture.min.y) edge({left, low.y - line}, {right, low.y});
  if (high.y < picture.max.y) edge({left, high.y}, {right, high.y + line});
}

void draw_texel_grid(const Ui& ui, ImDrawList& list, const MapCamera& camera, const NormalMap& map) {
  const double size = camera.pixels_per_texel / static_cast<double>(ui.scale);
  if (size < static_cast<double>(k_pixels_for_grid)) return;
  // Fades in over an octave, so that zooming has no jump.
  const double strength = std::clamp(size / static_cast<double>(k_pixels_for_grid) - 1, 0.35, 1.0);
  const ImU32 ink = rgb(0x000000, static_cast<unsigned>(60 * strength));
  const TexelBlock block = visible_block(camera, map);
  const ImVec2 low = screen_of_texel(camera, {block.i0, block.j0});
  const ImVec2 high = screen_of_texel(camera, {block.i1, block.j1});
  const float line = ui.px(1);
  for (int i = block.i0; i <= block.i1; ++i) {
    const float x = std::floor(screen_of_texel(camera, {i, 0}).x + 0.5F);
    list.AddRectFilled({x, low.y}, {x + line, high.y}, ink);
  }
  for (int j = block.j0; j <= block.j1; ++j) {
    const float y = std::floor(screen_of_texel(camera, {0, j}).y + 0.5F);
    list.AddRectFilled({low.x, y}, {high.x, y + line}, ink);
  }
}

void draw_normal_arrows(const Ui& ui, ImDrawList& list, const MapCamera& camera, const NormalMap& map) {
  if (camera.pixels_per_texel < static_cast<double>(k_pixels_for_arrows * ui.scale)) return;
  const TexelBlock block = visible_block(camera, map);
  float longest = 0;
  for (int j = block.j0; j < block.j1; ++j) {
    for (int i = block.i0; i < block.i1; ++i) {
      const glm::vec2 n = map.texel(i, j);
      longest = std::max(longest, n.x * n.x + n.y * n.y);
    }
  }
  longest = std::sqrt(longest);
  if (longest < 1e-6F) return;
  const float stretch = 0.46F * static_cast<float>(camera.pixels_per_texel) / longest;
  const float head = 0.2F * static_cast<float>(camera.pixels_per_texel);
  const float dot = ui.scale;
  for (int j = block.j0; j < block.j1; ++j) {
    for (int i = block.i0; i < block.i1; ++i) {
      const glm::vec2 n = map.texel(i, j);
      const ImVec2 from = screen_of_texel(camera, {i + 0.5, j + 0.5});
      const ImVec2 by{stretch * n.x, -stretch * n.y};  // t > 0 leans up
      if (std::hypot(by.x, by.y) < 2 * ui.scale) {     // flat: a point says so
        list.AddRectFilled({from.x - dot, from.y - dot}, {from.x + dot, from.y + dot}, rgb(0xFFFFFF, 200));
        continue;
      }
      draw_arrow(list, from, by, 1.3F * ui.scale, head, ui.scale, color::k_under_stroke);
      draw_arrow(list, from, by, 1.3F * ui.scale, head, 0, rgb(0xFFFFFF));
    }
  }
}

void draw_texel_outline(const Ui& ui, ImDrawList& list, const MapCamera& camera, glm::dvec2 u) {
  if (camera.pixels_per_texel < static_cast<double>(k_pixels_for_outline * ui.scale)) return;
  const glm::dvec2 texel(std::floor(u.x), std::floor(u.y));
  const ImVec2 low = whole(screen_of_texel(camera, texel));
  const ImVec2 high = whole(screen_of_texel(camera, texel + 1.0));
  const float line = ui.px(1);
  list.AddRect({low.x - 2 * line, low.y - 2 * line}, {high.x + 2 * line, high.y + 2 * line}, color::k_under_stroke, 0,
               0, line);
  list.AddRect({low.x - line, low.y - line}, {high.x + line, high.y + line}, rgb(0xFFFFFF), 0, 0, line);
}

void draw_scale_bar(const Ui& ui, ImDrawList& list, const MapCamera& camera, std::vector<Rectangle>& taken) {
  const double texels = rounded_down_step(static_cast<double>(ui.px(90)) / camera.pixels_per_texel);
  const float length = std::floor(static_cast<float>(texels * camera.pixels_per_texel) + 0.5F);
  const std::string text = fmt::format("{:g} {}", texels, texels == 1 ? "texel" : "texels");
  const ImVec2 extent = text_size(ui.fonts.small, text);
  const ImVec2 end{camera.picture.max.x - ui.px(8), camera.picture.max.y - ui.px(8)};
  const float line = ui.px(3);
  const float top = end.y - line;
  list.AddRectFilled({end.x - length - 1, top - 1}, {end.x + 1, end.y + 1}, color::k_under_stroke);
  list.AddRectFilled({end.x - length, top}, end, rgb(0xFFFFFF));
  const ImVec2 at{end.x - extent.x, top - ui.px(2) - extent.y};
  draw_text_over(ui, list, ui.fonts.small, at, color::k_text, text);
  taken.push_back({{end.x - std::max(length, extent.x) - ui.px(6), at.y}, camera.picture.max});
}

void draw_rulers(const Ui& ui, ImDrawList& list, const MapCamera& camera, const NormalMap& map,
                 std::vector<Rectangle>& taken) {
  const Rectangle& picture = camera.picture;
  const double step = std::max(1.0, rounded_up_step(static_cast<double>(ui.px(62)) / camera.pixels_per_texel));
  const TexelRange range = visible_texels(camera);
  const float line = ui.px(1);
  const float tick = ui.px(5);
  const ImFont* font = ui.fonts.small;
  const auto mark = [&](ImVec2 a, ImVec2 b) {
    if (overlaps_any({a, b}, taken)) return;
    list.AddRectFilled({a.x - 1, a.y - 1}, {b.x + 1, b.y + 1}, color::k_under_stroke);
    list.AddRectFilled(a, b, color::k_text);
  };
  const auto label = [&](ImVec2 at, const std::string& text) {
    const ImVec2 extent = text_size(font, text);
    const Rectangle area{at, {at.x + extent.x, at.y + extent.y}};
    if (!picture.contains(area.min) || !picture.contains(area.max) || overlaps_any(area, taken)) return;
    draw_text_over(ui, list, font, at, color::k_text, text);
    taken.push_back({{area.min.x - ui.px(4), area.min.y}, {area.max.x + ui.px(4), area.max.y}});
  };
  const auto each_step = [&](double low, double high, const auto& body) {
    for (double k = std::ceil(low / step); k * step <= high; k += 1) body(k * step);
  };
  each_step(std::max(range.min.x, 0.0), std::min(range.max.x, static_cast<double>(map.width())), [&](double u) {
    const float x = std::floor(screen_of_texel(camera, {u, 0}).x);
    mark({x, picture.max.y - tick}, {x + line, picture.max.y});
    const std::string text = fmt::format("{:g}", u);
    const ImVec2 extent = text_size(font, text);
    label({x - 0.5F * extent.x, picture.max.y - tick - ui.px(2) - extent.y}, text);
  });
  each_step(std::max(range.min.y, 0.0), std::min(range.max.y, static_cast<double>(map.height())), [&](double v) {
    const float y = std::floor(screen_of_texel(camera, {0, v}).y);
    mark({picture.min.x, y}, {picture.min.x + tick, y + line});
    const std::string text = fmt::format("{:g}", v);
    label({picture.min.x + tick + ui.px(3), y - 0.5F * text_size(font, text).y}, text);
  });
}

}  // namespace glint::view
