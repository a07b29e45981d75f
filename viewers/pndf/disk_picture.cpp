#include "viewers/pndf/disk_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "viewers/pndf/axis_ticks.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/number_text.h"
#include "viewers/widgets/theme.h"

namespace glint::view {
namespace {

constexpr double k_narrowest_window = 1e-4;
constexpr double k_ring_30 = 0.5;                 // sin 30°
constexpr double k_ring_60 = 0.8660254037844386;  // sin 60°

float whole(float x) {
  return std::floor(x + 0.5F);
}

// One axis of a window: rounded to a ten-thousandth of its width's decade, shifted into [-1, 1].
glm::dvec2 tidy_axis(double lowest, double width) {
  width = std::clamp(width, k_narrowest_window, 2.0);
  const double unit = std::pow(10, std::floor(std::log10(width)) - 4);
  const double per_unit = std::round(1 / unit);
  const double start = std::clamp(lowest, -1.0, 1 - width);
  const auto rounded = [&](double value) { return std::clamp(std::round(value * per_unit) / per_unit, -1.0, 1.0); };
  return {rounded(start), rounded(start + width)};
}

glm::dvec4 joined(glm::dvec2 s, glm::dvec2 t) {
  return {s.x, s.y, t.x, t.y};
}

// The part of a circle about the disk's middle that can be seen, every few pixels.
std::vector<ImVec2> visible_arc(const DiskPlace& place, double radius, bool& closed) {
  const glm::dvec2 middle{0.5 * (place.window.x + place.window.y), 0.5 * (place.window.z + place.window.w)};
  const double distance = std::hypot(middle.x, middle.y);
  const double reach = 0.5 * std::hypot(place.window.y - place.window.x, place.window.w - place.window.z);
  closed = distance <= reach;
  if (!closed && std::abs(radius - distance) > reach) return {};
  // Seen from the middle of the disk, the window lies within this angle to either side of its own middle.
  const double half = closed ? std::numbers::pi : std::asin(std::min(1.0, reach / distance));
  const double turn = closed ? 0 : std::atan2(middle.y, middle.x);
  const double length = 2 * half * radius * place.pixels_per_unit();
  const int count = static_cast<int>(std::clamp(length / 4, 16.0, 720.0));
  std::vector<ImVec2> points;
  points.reserve(static_cast<std::size_t>(count) + 1);
  for (int k = 0; k < (closed ? count : count + 1); ++k) {
    const double angle = turn - half + 2 * half * k / count;
    points.push_back(place.screen_of({radius * std::cos(angle), radius * std::sin(angle)}));
  }
  return points;
}

void draw_ring(ImDrawList& list, const DiskPlace& place, double radius, ImU32 ink, float thickness) {
  bool closed = false;
  const std::vector<ImVec2> points = visible_arc(place, radius, closed);
  if (points.empty()) return;
  const ImDrawFlags flags = closed ? ImDrawFlags_Closed : ImDrawFlags_None;
  const int count = static_cast<int>(points.size());
  list.AddPolyline(points.data(), count, rgb(0x000000, 70), flags, thickness + 2);
  list.AddPolyline(points.data(), count, ink, flags, thickness);
}

void draw_cell_edges(ImDrawList& list, const Rectangle& area, const PndfGrid& grid, const Rectangle& cut) {
  const float width = area.width() / static_cast<float>(grid.columns);
  const float height = area.height() / static_cast<float>(grid.rows);
  const ImU32 ink = rgb(0x000000, 70);
  const auto lines = [&](float start, float step, int count, float from, float to, auto line) {
    const int first = std::max(0, static_cast<int>((from - start) / step));
    const int last = std::min(count, static_cast<int>((to - start) / step) + 1);
    for (int k = first; k <= last; ++k) line(std::floor(start + static_cast<float>(k) * step));
  };
  lines(area.min.x, width, grid.columns, cut.min.x, cut.max.x, [&](float x) {
    list.AddRectFilled({x, cut.min.y}, {x + 1, cut.max.y}, ink);
  });
  lines(area.min.y, height, grid.rows, cut.min.y, cut.max.y, [&](float y) {
    list.AddRectFilled({cut.min.x, y}, {cut.max.x, y + 1}, ink);
  });
}

// A number at each end and, where it is inside and there is room, at 0 or in the middle.
std::vector<double> axis_numbers(double lowest, double highest) {
  if (lowest < 0 && highest > 0 && std::min(-lowest, highest) > 0.25 * (highest - lowest)) return {lowest, 0, highest};
  return {lowest, highest};
}

// Of the small disc that shows where the window lies.
Rectangle inset_area(const Ui& ui, const DiskPlace& place) {
  const float side = ui.px(34);
  const float margin = ui.px(5);
  return {{place.square.max.x - margin - side, place.square.min.y + margin},
          {place.square.max.x - margin, place.square.min.y + margin + side}};
}

void draw_rim_labels(const Ui& ui, ImDrawList& list, const DiskPlace& place) {
  const float half = 0.5F * ui.fonts.small->FontSize;
  const auto label = [&](double radius, std::string_view text) {
    // Above the middle, on the ring, for chips stand below; elsewhere on it where that is not in the window.
    const std::array angles{0.5, 0.25, 0.0, 0.75, 1.0, -0.25, -0.5};
    for (const double angle : angles) {
      const double turn = angle * std::numbers::pi;
      const ImVec2 at = place.screen_of({radius * std::cos(turn), radius * std::sin(turn)});
      const float width = text_size(ui.fonts.small, text).x;
      const Rectangle area{{at.x - 0.5F * width, at.y - half}, {at.x + 0.5F * width, at.y + half}};
      const float margin = ui.px(2);
      const bool fits = area.min.x > place.shown.min.x + margin && area.max.x < place.shown.max.x - margin &&
                        area.min.y > place.shown.min.y + margin && area.max.y < place.shown.max.y - margin;
      if (!fits || (!place.whole() && overlap(area, inset_area(ui, place)))) continue;
      draw_text_over(ui, list, ui.fonts.small, area.min, color::k_text, text);
      return;
    }
  };
  label(k_ring_30, "30°");
  label(k_ring_60, "60°");
}

}  // namespace

glm::dvec4 window_of(const PndfGrid& grid) {
  return {grid.s_min, grid.s_max, grid.t_min, grid.t_max};
}

ImVec2 DiskPlace::screen_of(glm::dvec2 s) const {
  return {shown.min.x + static_cast<float>((s.x - window.x) / (window.y - window.x) * shown.width()),
          shown.min.y + static_cast<float>((window.w - s.y) / (window.w - window.z) * shown.height())};
}

glm::dvec2 DiskPlace::normal_at(ImVec2 screen) const {
  return {window.x + (window.y - window.x) * ((screen.x - shown.min.x) / shown.width()),
          window.w - (window.w - window.z) * ((screen.y - shown.min.y) / shown.height())};
}

std::optional<glm::dvec2> DiskPlace::normal_under(ImVec2 screen) const {
  if (!shown.contains(screen)) return std::nullopt;
  const glm::dvec2 s = normal_at(screen);
  if (std::hypot(s.x, s.y) > 1) return std::nullopt;
  return s;
}

DiskPlace disk_place(const Rectangle& square, glm::dvec4 window) {
  DiskPlace place{square, window, square};
  const double aspect = (window.y - window.x) / (window.w - window.z);
  if (aspect > 1) {
    const float height = std::max(1.0F, whole(static_cast<float>(square.height() / aspect)));
    place.shown.min.y = whole(square.center().y - 0.5F * height);
    place.shown.max.y = place.shown.min.y + height;
  } else if (aspect < 1) {
    const float width = std::max(1.0F, whole(static_cast<float>(square.width() * aspect)));
    place.shown.min.x = whole(square.center().x - 0.5F * width);
    place.shown.max.x = place.shown.min.x + width;
  }
  return place;
}

glm::dvec4 zoomed_window(glm::dvec4 window, glm::dvec2 s, double notches) {
  const double widest = std::max(window.y - window.x, window.w - window.z);
  const double narrowest = std::min(window.y - window.x, window.w - window.z);
  const double factor =
      std::clamp(std::pow(1.25, -notches), std::min(1.0, k_narrowest_window / narrowest), std::max(1.0, 2 / narrowest));
  const double width = (window.y - window.x) * factor;
  const double height = (window.w - window.z) * factor;
  if (widest * factor >= 1.95) return k_whole_disk;
  return joined(tidy_axis(s.x + (window.x - s.x) * factor, width), tidy_axis(s.y + (window.z - s.y) * factor, height));
}

glm::dvec4 panned_window(glm::dvec4 window, glm::dvec2 moved) {
  return joined(tidy_axis(window.x - moved.x, window.y - window.x), tidy_axis(window.z - moved.y, window.w - window.z));
}

void draw_disk_ground(ImDrawList& list, const DiskPlace& place) {
  list.AddRectFilled(place.square.min, place.square.max, color::k_picture);
  list.AddRect({place.square.min.x - 1, place.square.min.y - 1}, {place.square.max.x + 1, place.square.max.y + 1},
               color::k_border);
}

void draw_disk_image(Ui& ui, ImDrawList& list, const DiskPlace& place, const PndfGrid& grid, const Texture& texture,
                     Shading shading, float opacity) {
  const Rectangle area{place.screen_of({grid.s_min, grid.t_max}), place.screen_of({grid.s_max, grid.t_min})};
  const float pixels_per_cell = area.width() / static_cast<float>(texture.size().x);
  shading.nearest = pixels_per_cell >= 4;
  const ImTextureID picture = ui.pictures.add(texture, shading);
  const ImU32 tint = rgb(0xFFFFFF, static_cast<unsigned>(255 * opacity));
  if (place.whole() && window_of(grid) == place.window) {
    list.AddImageRounded(picture, area.min, area.max, {0, 0}, {1, 1}, tint, 0.5F * area.width());
  } else {
    const Rectangle cut{{std::max(area.min.x, place.shown.min.x), std::max(area.min.y, place.shown.min.y)},
                        {std::min(area.max.x, place.shown.max.x), std::min(area.max.y, place.shown.max.y)}};
    if (cut.width() <= 0 || cut.height() <= 0) return;
    const auto coordinate = [&](ImVec2 p) {
      return ImVec2((p.x - area.min.x) / area.width(), (p.y - area.min.y) / area.height());
    };
    list.AddImage(picture, cut.min, cut.max, coordinate(cut.min), coordinate(cut.max), tint);
  }
  if (pixels_per_cell < 8 || texture.size() != glm::ivec2(grid.columns, grid.rows)) return;
  draw_cell_edges(list, area, grid, place.shown);
}

void draw_disk_rings(const Ui& ui, ImDrawList& list, const DiskPlace& place, bool labelled) {
  list.PushClipRect(place.shown.min, place.shown.max, true);
  const float thickness = std::max(1.0F, ui.px(1));
  for (const double radius : {k_ring_30, k_ring_60}) draw_ring(list, place, radius, rgb(0xFFFFFF, 51), thickness);
  draw_ring(list, place, 1, rgb(0xFFFFFF, 115), thickness);
  if (labelled) draw_rim_labels(ui, list, place);
  list.PopClipRect();
}

void draw_disk_axes(const Ui& ui, ImDrawList& list, const DiskPlace& place, bool labelled) {
  const ImFont* font = ui.fonts.small_numbers;
  const Rectangle& shown = place.shown;
  const float tick = ui.px(4);
  const float top = place.square.max.y + tick + ui.px(3);
  const std::vector<double> numbers = axis_numbers(place.window.x, place.window.y);
  float free_from = shown.min.x;  // between the last two numbers: room for the name
  float free_to = shown.max.x;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const float x = std::min(std::floor(place.screen_of({numbers[k], 0}).x), shown.max.x - 1);
    list.AddRectFilled({x, place.square.max.y + 1}, {x + 1, place.square.max.y + 1 + tick}, color::k_axis);
    const std::string text = short_number_text(numbers[k]);
    const float width = text_size(font, text).x;
    const float left = k == 0 ? shown.min.x : k + 1 == numbers.size() ? shown.max.x - width : x - 0.5F * width;
    draw_text(list, font, {left, top}, color::k_text_2, text);
    if (k + 1 == numbers.size()) free_to = left;
    if (k + 1 < numbers.size()) free_from = left + width;
  }
  draw_text_centered(list, ui.fonts.small, {0.5F * (free_from + free_to), top + 0.5F * font->FontSize}, color::k_text_2,
                     "s");
  if (!labelled) return;
  const float inset = ui.px(4);
  const std::string highest = place.whole() ? "t" : "t " + short_number_text(place.window.w);
  draw_text_over(ui, list, ui.fonts.small, {shown.min.x + inset, shown.min.y + ui.px(3)}, color::k_text, highest);
  if (place.whole()) return;
  draw_text_over(ui, list, ui.fonts.small, {shown.min.x + inset, shown.max.y - ui.fonts.small->FontSize - ui.px(1)},
                 color::k_text, "t " + short_number_text(place.window.z));
}

void draw_crosshair(const Ui& ui, ImDrawList& list, const DiskPlace& place, glm::dvec2 s) {
  const ImVec2 at = place.screen_of(s);
  const Rectangle& shown = place.shown;
  list.PushClipRect(shown.min, shown.max, true);
  const float x = std::floor(at.x);
  const float y = std::floor(at.y);
  const float line = std::max(1.0F, ui.px(1));
  const float radius = 3.5F * ui.scale;
  const float gap = radius + ui.px(1.5F);
  const std::array bars = {
      Rectangle{{x, shown.min.y}, {x + line, y - gap}}, Rectangle{{x, y + gap}, {x + line, shown.max.y}},
      Rectangle{{shown.min.x, y}, {x - gap, y + line}}, Rectangle{{x + gap, y}, {shown.max.x, y + line}}};
  for (const bool under : {true, false}) {
    const float wider = under ? 1.0F : 0.0F;
    for (const Rectangle& bar : bars) {
      if (bar.width() <= 0 || bar.height() <= 0) continue;
      list.AddRectFilled({bar.min.x - wider, bar.min.y - wider}, {bar.max.x + wider, bar.max.y + wider},
                         under ? color::k_under_stroke : color::k_accent);
    }
  }
  const ImVec2 middle{x + 0.5F * line, y + 0.5F * line};
  list.AddCircle(middle, radius, color::k_under_stroke, 0, line + 2);
  list.AddCircle(middle, radius, color::k_accent, 0, line + 0.3F);
  list.PopClipRect();
}

void draw_window_inset(const Ui& ui, ImDrawList& list, const DiskPlace& place) {
  if (place.whole()) return;
  const Rectangle area = inset_area(ui, place);
  list.AddRectFilled(area.min, area.max, color::k_chip, ui.px(3));
  const float radius = 0.5F * area.width() - ui.px(3);
  const ImVec2 middle = area.center();
  list.AddCircleFilled(middle, radius, color::k_picture, 0);
  list.AddCircle(middle, radius, rgb(0xFFFFFF, 140), 0, 1);
  const auto at = [&](double s, double t) {
    const auto clamped = [](double x) { return static_cast<float>(std::clamp(x, -1.0, 1.0)); };
    return ImVec2(middle.x + radius * clamped(s), middle.y - radius * clamped(t));
  };
  Rectangle window{at(place.window.x, place.window.w), at(place.window.y, place.window.z)};
  // Never smaller than can be seen.
  const float least = ui.px(3);
  if (window.width() < least) {
    const ImVec2 center = window.center();
    window = {{center.x - 0.5F * least, center.y - 0.5F * least}, {center.x + 0.5F * least, center.y + 0.5F * least}};
  }
  list.AddRect({whole(window.min.x), whole(window.min.y)}, {whole(window.max.x), whole(window.max.y)}, color::k_text);
}

}  // namespace glint::view
