#include "viewers/map/map_readouts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "viewers/map/map_camera.h"
#include "viewers/map/map_colors.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/number_text.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::view {
namespace {

constexpr std::string_view k_no_value = "–";

double z_of(glm::dvec2 n) {
  return std::sqrt(std::max(0.0, 1 - n.x * n.x - n.y * n.y));
}

std::string normal_text(glm::dvec2 n, int digits) {
  return decimal_text(n.x, digits) + ' ' + decimal_text(n.y, digits) + ' ' + decimal_text(z_of(n), digits);
}

const StoredSamples* samples_of(const SurfaceInUse* surface) {
  if (surface == nullptr || !surface->loaded.stored || surface->loaded.stored->empty()) return nullptr;
  return surface->loaded.stored.get();
}

std::string raw_text(const SurfaceInUse& surface, glm::ivec2 texel) {
  if (const StoredSamples* samples = samples_of(&surface)) return samples->text(texel.x, texel.y);
  if (surface.description.source != SurfaceSource::file) return "generated";
  return "not kept";
}

// The longest text that the stored values of this file can have.
std::string widest_raw(const SurfaceInUse* surface) {
  const StoredSamples* samples = samples_of(surface);
  if (samples == nullptr) return "generated";
  const std::string_view one = samples->bits() <= 8 ? "255" : samples->bits() <= 16 ? "65535" : "-0.1234";
  std::string text;
  for (std::size_t k = 0; k < samples->channels().size(); ++k)
    text += std::string(k == 0 ? "" : " ") + std::string(one);
  return text;
}

struct Item {
  std::string caption;
  std::string value;
  std::string unit;
  std::string widest;   // no value is wider: keeps the place of what follows
  std::string meaning;  // for the tooltip
  std::optional<DisplayColor> swatch;
};

std::string color_text(DisplayColor color) {
  return fmt::format("{} {} {}", static_cast<int>(color.x), static_cast<int>(color.y), static_cast<int>(color.z));
}

Item displayed_item(MapColors colors, const std::optional<MapReading>& reading) {
  Item item{"Displayed", std::string(k_no_value), "", "255 255 255", "The colour on the screen, red green blue.", {}};
  if (reading) {
    item.swatch = reading->color;
    item.value = color_text(reading->color);
  }
  if (colors == MapColors::slope) {
    item = {"Slope",    item.value, "", "255 255 255", "Slope of the texel, the tangent of its tilt, and its colour.",
            item.swatch};
    if (reading) item.value = number_text(reading->slope);
  } else if (colors == MapColors::curvature) {
    item = {"Curvature",
            item.value,
            "",
            "255 255 255",
            "How fast the normal turns at the texel: the norm of ∂n/∂u, per texel, and its colour.",
            item.swatch};
    if (reading) item.value = number_text(reading->curvature);
  }
  return item;
}

std::vector<Item> items(const SurfaceInUse* surface, MapColors colors, const std::optional<MapReading>& reading) {
  const StoredSamples* samples = samples_of(surface);
  const std::string none(k_no_value);
  const NormalMap* map = surface == nullptr ? nullptr : &surface->loaded.surface.map();
  const std::string widest_texel =
      map == nullptr ? "0000, 0000" : fmt::format("{}, {}", map->width() - 1, map->height() - 1);
  return {{"Texel",
           reading ? fmt::format("{}, {}", reading->texel.x, reading->texel.y) : none,
           "",
           widest_texel,
           "Column and row of the texel under the cursor, from 0.",
           {}},
          {samples == nullptr ? std::string("Raw") : fmt::format("Raw, {} bit", samples->bits()),
           reading ? reading->raw : none,
           "",
           widest_raw(surface),
           "What the file holds for the texel.",
           {}},
          displayed_item(colors, reading),
          {"Decoded s, t, z",
           reading ? normal_text(glm::dvec2(reading->decoded), 3) : none,
           "",
           "−0.000 −0.000 0.000",
           "The normal of the texel: what every method computes with.",
           {}},
          {"At cursor s, t, z",
           reading ? normal_text(reading->at_cursor, 3) : none,
           "",
           "−0.000 −0.000 0.000",
           "The normal of the surface exactly at the cursor, between the texels' centres.",
           {}}};
}

float item_width(const Ui& ui, const Item& item) {
  const float value = text_size(ui.fonts.numbers, item.widest).x;
  return std::ceil(std::max(value, text_size(ui.fonts.small, item.caption).x));
}

// Left ends of the items, and in which line: as many in a line as fit.
struct Place {
  float x;
  int line;
};
std::vector<Place> places(const Ui& ui, const std::vector<Item>& all, float width) {
  std::vector<Place> result;
  float x = 0;
  int line = 0;
  for (const Item& item : all) {
    const float needed = item_width(ui, item);
    if (x > 0 && x + needed > width) {
      x = 0;
      ++line;
    }
    result.push_back({x, line});
    x += needed + ui.px(16);
  }
  return result;
}

void draw_swatch(const Ui& ui, ImDrawList& list, ImVec2 at, DisplayColor color) {
  const float side = ui.px(9);
  list.AddRectFilled(at, {at.x + side, at.y + side}, IM_COL32(color.x, color.y, color.z, 255));
  list.AddRect(at, {at.x + side, at.y + side}, color::k_border_strong);
}

void draw_item(Ui& ui, ImVec2 at, const Item& item) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float row = ui.fonts.small->FontSize;
  draw_text(list, ui.fonts.small, at, color::k_hint, item.caption);
  if (item.swatch) {
    draw_swatch(ui, list, {at.x + text_size(ui.fonts.small, item.caption).x + ui.px(5), at.y + ui.px(3)}, *item.swatch);
  }
  const bool is_number = !item.value.empty() && item.value != "generated" && item.value != "not kept";
  const ImU32 ink = item.value == k_no_value || !is_number ? color::k_hint : color::k_text;
  draw_text(list, is_number ? ui.fonts.numbers : ui.fonts.text, {at.x, at.y + row}, ink, item.value);
  const Rectangle area{at, {at.x + item_width(ui, item), at.y + row + ui.fonts.numbers->FontSize}};
  explain(ui, "map.readout." + item.caption, area, {item.caption, item.meaning, {}});
}

// "texel 262, 750": caption and value on one line; returns its width.
float draw_pair(const Ui& ui, ImVec2 at, bool from_right, std::string_view caption, std::string_view value) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 label = text_size(ui.fonts.small, caption);
  const float gap = caption.empty() ? 0 : ui.px(5);
  const float width = label.x + gap + text_size(ui.fonts.small_numbers, value).x;
  const float x = from_right ? at.x - width : at.x;
  draw_text(list, ui.fonts.small, {x, at.y + ui.px(0.5F)}, color::k_hint, caption);
  draw_text(list, ui.fonts.small_numbers, {x + label.x + gap, at.y},
            value == k_no_value ? color::k_hint : color::k_text, value);
  return width;
}

// A shorter form of stored floats, where the full one is too wide.
std::string fitting_raw(const Ui& ui, const SurfaceInUse* surface, const MapReading& reading, float width) {
  const StoredSamples* samples = samples_of(surface);
  if (samples == nullptr || text_size(ui.fonts.small_numbers, reading.raw).x <= width) return reading.raw;
  for (const int digits : {3, 2}) {
    std::string text;
    for (std::size_t k = 0; k < samples->channels().size(); ++k) {
      text += fmt::format("{}{:.{}g}", k == 0 ? "" : " ", samples->value(reading.texel.x, reading.texel.y, k), digits);
    }
    if (text_size(ui.fonts.small_numbers, text).x <= width) return text;
  }
  return std::string(k_no_value);
}

// What is shown on the screen, its right end at `right`; where room is short, the caption is left out, then all of it.
void draw_compact_shown(const Ui& ui, ImVec2 right, float room, MapColors colors, const MapReading& reading) {
  std::string shown = fmt::format("#{:02X}{:02X}{:02X}", reading.color.x, reading.color.y, reading.color.z);
  std::string caption;
  if (colors == MapColors::slope) {
    caption = "slope";
    shown = number_text(reading.slope);
  } else if (colors == MapColors::curvature) {
    caption = "curv.";
    shown = number_text(reading.curvature);
  }
  const float swatch = ui.px(14);
  const float figure = text_size(ui.fonts.small_numbers, shown).x + swatch;
  if (figure > room) return;
  if (figure + text_size(ui.fonts.small, caption).x + ui.px(5) > room) caption.clear();
  const float width = draw_pair(ui, right, true, caption, shown);
  draw_swatch(ui, *ImGui::GetWindowDrawList(), {right.x - width - swatch, right.y + ui.px(3)}, reading.color);
}

void draw_compact(Ui& ui, const Rectangle& area, const SurfaceInUse* surface, MapColors colors,
                  const std::optional<MapReading>& reading) {
  const std::string none(k_no_value);
  const std::string texel = reading ? fmt::format("{}, {}", reading->texel.x, reading->texel.y) : none;
  const float used = draw_pair(ui, area.min, false, "texel", texel);
  const float left = area.width() - used - ui.px(14) - text_size(ui.fonts.small, "raw").x - ui.px(5);
  draw_pair(ui, {area.max.x, area.min.y}, true, "raw", reading ? fitting_raw(ui, surface, *reading, left) : none);
  const float below = area.min.y + ui.px(17);
  const float decoded = draw_pair(ui, {area.min.x, below}, false, "decoded",
                                  reading ? normal_text(glm::dvec2(reading->decoded), 2) : none);
  if (reading) draw_compact_shown(ui, {area.max.x, below}, area.width() - decoded - ui.px(10), colors, *reading);
}

}  // namespace

std::optional<MapReading> reading_at(const SurfaceInUse& surface, MapColors colors, int level, glm::dvec2 u) {
  const NormalMap& map = surface.loaded.surface.map();
  const glm::ivec2 size(map.width(), map.height());
  if (!on_map(u, size, map.wrap())) return std::nullopt;
  MapReading reading;
  reading.position = stored_position(u, size, map.wrap());
  reading.texel = {std::min(static_cast<int>(reading.position.x), size.x - 1),
                   std::min(static_cast<int>(reading.position.y), size.y - 1)};
  reading.raw = raw_text(surface, reading.texel);
  reading.decoded = map.texel(reading.texel.x, reading.texel.y);
  reading.at_cursor = surface.loaded.surface.normal(reading.position);
  const NormalPyramid& pyramid = *surface.pyramid;
  reading.color = texel_color(pyramid, colors, level, reading.texel.x >> level, reading.texel.y >> level);
  reading.slope = slope_of(reading.decoded);
  reading.curvature = curvature_of(pyramid, 0, reading.texel.x, reading.texel.y);
  return reading;
}

std::string clipboard_text(const MapReading& reading) {
  const auto three = [](double s, double t, double z) { return fmt::format("{:.9g} {:.9g} {:.9g}", s, t, z); };
  const glm::dvec2 decoded(reading.decoded);
  std::string text = fmt::format("texel {} {}\n", reading.texel.x, reading.texel.y);
  text += fmt::format("raw {}\n", reading.raw);
  text += fmt::format("decoded s t z {}\n", three(decoded.x, decoded.y, z_of(decoded)));
  text += fmt::format("at u v {} {}\n", reading.position.x, reading.position.y);
  text += fmt::format("surface s t z {}\n", three(reading.at_cursor.x, reading.at_cursor.y, z_of(reading.at_cursor)));
  text += fmt::format("displayed {}\n", color_text(reading.color));
  text += fmt::format("slope {:.9g}\ncurvature {:.9g}\n", reading.slope, reading.curvature);
  return text;
}

float readouts_height(const Ui& ui, const SurfaceInUse* surface, float width, bool compact) {
  if (compact) return ui.px(17) + ui.fonts.small_numbers->FontSize;
  const int lines = places(ui, items(surface, MapColors::normal, std::nullopt), width).back().line + 1;
  return static_cast<float>(lines - 1) * ui.px(34) + ui.fonts.small->FontSize + ui.fonts.numbers->FontSize;
}

void draw_readouts(Ui& ui, const Rectangle& area, const SurfaceInUse* surface, MapColors colors,
                   const std::optional<MapReading>& reading, bool compact) {
  if (compact) {
    draw_compact(ui, area, surface, colors, reading);
    return;
  }
  const std::vector<Item> all = items(surface, colors, reading);
  const std::vector<Place> where = places(ui, all, area.width());
  for (std::size_t k = 0; k < all.size(); ++k) {
    draw_item(ui, {area.min.x + where[k].x, area.min.y + static_cast<float>(where[k].line) * ui.px(34)}, all[k]);
  }
}

}  // namespace glint::view
