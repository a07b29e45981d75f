#include "viewers/widgets/draw.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace glint::view {
namespace {

ImVec2 operator+(ImVec2 a, ImVec2 b) {
  return {a.x + b.x, a.y + b.y};
}

ImVec2 along(ImVec2 a, ImVec2 b, float share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

// Of the dark stroke under one of this thickness: two pixels wider, at any scale.
float under(float thickness) {
  return thickness + std::max(2.0F, thickness);
}

float whole(float x) {
  return std::floor(x + 0.5F);
}

// Calls body(a, b) for every dash of a line that goes through the points.
template <class Body>
void for_dashes(std::span<const ImVec2> points, bool closed, float dash, float gap, Body body) {
  if (points.size() < 2) return;
  float left = dash;  // of the dash or gap under way
  bool on = true;
  const std::size_t segments = closed ? points.size() : points.size() - 1;
  for (std::size_t k = 0; k < segments; ++k) {
    const ImVec2 a = points[k];
    const ImVec2 b = points[(k + 1) % points.size()];
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    float done = 0;
    while (done < length) {
      const float step = std::min(left, length - done);
      if (on) body(along(a, b, done / length), along(a, b, (done + step) / length));
      done += step;
      left -= step;
      if (left > 0) continue;
      on = !on;
      left = on ? dash : gap;
    }
  }
}

}  // namespace

ImVec2 text_size(const ImFont* font, std::string_view text) {
  if (text.empty()) return {0, font->FontSize};  // ImGui takes a null end for the end of the string
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.data(), text.data() + text.size());
}

void draw_text(ImDrawList& list, const ImFont* font, ImVec2 at, ImU32 ink, std::string_view text) {
  if (text.empty()) return;
  list.AddText(font, font->FontSize, {whole(at.x), whole(at.y)}, ink, text.data(), text.data() + text.size());
}

void draw_text_right(ImDrawList& list, const ImFont* font, ImVec2 right, ImU32 ink, std::string_view text) {
  draw_text(list, font, {right.x - text_size(font, text).x, right.y}, ink, text);
}

void draw_text_centered(ImDrawList& list, const ImFont* font, ImVec2 center, ImU32 ink, std::string_view text) {
  const ImVec2 extent = text_size(font, text);
  draw_text(list, font, {center.x - 0.5F * extent.x, center.y - 0.5F * extent.y}, ink, text);
}

void draw_text_over(const Ui& ui, ImDrawList& list, const ImFont* font, ImVec2 at, ImU32 ink, std::string_view text) {
  const float halo = ui.px(1);
  for (const ImVec2 offset : {ImVec2(-halo, 0), ImVec2(halo, 0), ImVec2(0, -halo), ImVec2(0, halo)}) {
    draw_text(list, font, at + offset, rgb(0x000000, 190), text);
  }
  draw_text(list, font, at, ink, text);
}

std::string fitted_text(const ImFont* font, std::string_view text, float width) {
  if (text_size(font, text).x <= width) return std::string(text);
  std::string cut(text);
  while (!cut.empty() && text_size(font, cut + "…").x > width) {
    while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0U) == 0x80U) cut.pop_back();
    if (!cut.empty()) cut.pop_back();
  }
  while (!cut.empty() && cut.back() == ' ') cut.pop_back();
  return cut + "…";
}

std::vector<std::string> wrapped_text(const ImFont* font, std::string_view text, float width) {
  std::vector<std::string> lines;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  while (at < end) {
    const char* const line_end = std::find(at, end, '\n');
    const char* stop = font->CalcWordWrapPositionA(1, at, line_end, width);
    if (stop == at) stop = std::min(at + 1, end);  // narrower than one letter
    lines.emplace_back(at, stop);
    at = stop;
    while (at < end && (*at == ' ' || *at == '\n')) ++at;
  }
  return lines;
}

void draw_line_over(ImDrawList& list, ImVec2 a, ImVec2 b, ImU32 ink, float thickness) {
  list.AddLine(a, b, color::k_under_stroke, under(thickness));
  list.AddLine(a, b, ink, thickness);
}

void draw_polyline_over(ImDrawList& list, std::span<const ImVec2> points, bool closed, ImU32 ink, float thickness) {
  const ImDrawFlags flags = closed ? ImDrawFlags_Closed : ImDrawFlags_None;
  list.AddPolyline(points.data(), static_cast<int>(points.size()), color::k_under_stroke, flags, under(thickness));
  list.AddPolyline(points.data(), static_cast<int>(points.size()), ink, flags, thickness);
}

void draw_dashed_over(ImDrawList& list, std::span<const ImVec2> points, bool closed, ImU32 ink, float thickness,
                      float dash, float gap) {
  for_dashes(points, closed, dash, gap,
             [&](ImVec2 a, ImVec2 b) { list.AddLine(a, b, color::k_under_stroke, under(thickness)); });
  for_dashes(points, closed, dash, gap, [&](ImVec2 a, ImVec2 b) { list.AddLine(a, b, ink, thickness); });
}

void draw_mark(ImDrawList& list, PndfMethod method, ImVec2 center, float radius) {
  const ImU32 ink = method_color(method);
  const ImU32 edge = color::k_window;
  switch (method) {
    case PndfMethod::exact: {
      const float half = 0.8F * radius;
      const ImVec2 a{whole(center.x - half), whole(center.y - half)};
      const ImVec2 b{whole(center.x + half), whole(center.y + half)};
      list.AddRectFilled(a, b, ink);
      list.AddRect({a.x - 0.5F, a.y - 0.5F}, {b.x + 0.5F, b.y + 0.5F}, edge);
      break;
    }
    case PndfMethod::mixture:
      list.AddCircleFilled(center, 0.9F * radius, ink, 16);
      list.AddCircle(center, 0.9F * radius, edge, 16);
      break;
    case PndfMethod::lean: {
      const ImVec2 top{center.x, center.y - radius};
      const ImVec2 right{center.x + radius, center.y};
      const ImVec2 bottom{center.x, center.y + radius};
      const ImVec2 left{center.x - radius, center.y};
      list.AddQuadFilled(top, right, bottom, left, ink);
      list.AddQuad(top, right, bottom, left, edge);
      break;
    }
    case PndfMethod::automatic: {
      // A plus: the one that is made of the others.
      const float arm = 0.36F * radius;
      const std::array points{ImVec2(-arm, -radius), ImVec2(arm, -radius), ImVec2(arm, -arm),     ImVec2(radius, -arm),
                              ImVec2(radius, arm),   ImVec2(arm, arm),     ImVec2(arm, radius),   ImVec2(-arm, radius),
                              ImVec2(-arm, arm),     ImVec2(-radius, arm), ImVec2(-radius, -arm), ImVec2(-arm, -arm)};
      std::array<ImVec2, points.size()> outline{};
      std::transform(points.begin(), points.end(), outline.begin(),
                     [&](ImVec2 p) { return ImVec2(center.x + p.x, center.y + p.y); });
      list.AddRectFilled({center.x - radius, center.y - arm}, {center.x + radius, center.y + arm}, ink);
      list.AddRectFilled({center.x - arm, center.y - radius}, {center.x + arm, center.y + radius}, ink);
      list.AddPolyline(outline.data(), static_cast<int>(outline.size()), edge, ImDrawFlags_Closed, 1);
      break;
    }
    case PndfMethod::binning: {
      const float half = 0.95F * radius;
      const std::array points{ImVec2(center.x, center.y - radius), ImVec2(center.x + half, center.y + 0.72F * radius),
                              ImVec2(center.x - half, center.y + 0.72F * radius)};
      list.AddTriangleFilled(points[0], points[1], points[2], ink);
      list.AddTriangle(points[0], points[1], points[2], edge);
      break;
    }
  }
}

Rectangle draw_chip(const Ui& ui, ImDrawList& list, ImVec2 at, std::string_view text) {
  const ImVec2 extent = text_size(ui.fonts.small, text);
  const Rectangle area{at, {at.x + whole(extent.x) + ui.px(12), at.y + ui.px(18)}};
  list.AddRectFilled(area.min, area.max, color::k_chip, ui.px(3));
  draw_text(list, ui.fonts.small, {at.x + ui.px(6), at.y + 0.5F * (ui.px(18) - extent.y)}, color::k_text, text);
  return area;
}

void draw_icon(const Ui& ui, ImDrawList& list, Icon icon, ImVec2 c, ImU32 ink) {
  const float s = ui.scale;
  const float w = std::max(1.0F, 1.3F * s);
  const auto at = [&](float x, float y) { return ImVec2(c.x + x * s, c.y + y * s); };
  const auto line = [&](float x0, float y0, float x1, float y1) { list.AddLine(at(x0, y0), at(x1, y1), ink, w); };
  switch (icon) {
    case Icon::help:
      list.AddCircle(c, 6 * s, ink, 24, w);
      draw_text_centered(list, ui.fonts.small, at(0, 0), ink, "?");
      break;
    case Icon::maximise:
      list.AddRect(at(-4.5F, -4.5F), at(4.5F, 4.5F), ink, 1, 0, w);
      break;
    case Icon::restore:
      list.AddRect(at(-5, -2), at(2, 5), ink, 1, 0, w);
      line(-2, -5, 5, -5);
      line(5, -5, 5, 2);
      break;
    case Icon::export_picture:
      line(0, -5.5F, 0, 2);
      line(-3, -1, 0, 2);
      line(3, -1, 0, 2);
      line(-5.5F, 2, -5.5F, 5);
      line(-5.5F, 5, 5.5F, 5);
      line(5.5F, 5, 5.5F, 2);
      break;
    case Icon::close:
      line(-4, -4, 4, 4);
      line(-4, 4, 4, -4);
      break;
    case Icon::warning:
      line(0, -6, 6.5F, 5.5F);
      line(6.5F, 5.5F, -6.5F, 5.5F);
      line(-6.5F, 5.5F, 0, -6);
      line(0, -2, 0, 2);
      line(0, 3.2F, 0, 4.2F);
      break;
    case Icon::arrow_down:
      list.AddTriangleFilled(at(-4, -2), at(4, -2), at(0, 2.5F), ink);
      break;
    case Icon::arrow_right:
      list.AddTriangleFilled(at(-2, -4), at(2.5F, 0), at(-2, 4), ink);
      break;
    case Icon::up:
      line(0, 5, 0, -4.5F);
      line(-4, -1, 0, -4.5F);
      line(4, -1, 0, -4.5F);
      break;
    case Icon::reset:
      list.PathArcTo(at(0.5F, 0.5F), 4.5F * s, -0.75F * std::numbers::pi_v<float>, 0.6F * std::numbers::pi_v<float>,
                     20);
      list.PathStroke(ink, 0, w);
      line(-2.7F, -2.7F, -4.5F, -5.5F);
      line(-2.7F, -2.7F, 0.2F, -3.6F);
      break;
    case Icon::folder:
      line(-6, -4, -1.5F, -4);
      line(-1.5F, -4, 0, -2.2F);
      line(0, -2.2F, 6, -2.2F);
      line(6, -2.2F, 6, 4.5F);
      line(6, 4.5F, -6, 4.5F);
      line(-6, 4.5F, -6, -4);
      break;
    case Icon::file:
      line(-4, -6, 1, -6);
      line(1, -6, 4, -3);
      line(4, -3, 4, 6);
      line(4, 6, -4, 6);
      line(-4, 6, -4, -6);
      break;
    case Icon::picture:
      list.AddRect(at(-6, -5), at(6, 5), ink, 1, 0, w);
      line(-4.5F, 3, -1, -1);
      line(-1, -1, 1.5F, 2);
      line(1.5F, 2, 3, 0.5F);
      line(3, 0.5F, 4.5F, 3);
      break;
    case Icon::check:
      line(-4, 0, -1, 3.2F);
      line(-1, 3.2F, 4.5F, -3.8F);
      break;
  }
}

}  // namespace glint::view
