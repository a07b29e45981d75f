#include "viewers/map/element_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/image/color_map.h"
#include "viewers/widgets/draw.h"
#include "viewers/widgets/number_text.h"
#include "viewers/widgets/theme.h"
#include "viewers/widgets/widgets.h"

namespace glint::view {
namespace {

constexpr float k_largest_disc = 62;  // pixels of the picture of a disc: a larger one is that, enlarged

// How a disc is painted, lengths in its picture's pixels.
struct DiscLook {
  float radius;
  float rim;     // dark, outside
  float ring;    // the outer part, opaque
  float inside;  // opacity within the ring
};

// The map stays visible through large discs; small ones need all the contrast they can get.
DiscLook look_of(float radius, float scale) {
  const float size = radius / scale;
  const float largeness = std::clamp((size - 3) / 9, 0.0F, 1.0F);
  return {radius, std::clamp(0.3F * size, 0.4F, 1.0F) * scale, 1.5F * scale, 1 - 0.4F * largeness};
}

// White with a dark rim, to be tinted.
Texture disc_picture(const GlFunctions& gl, const DiscLook& look) {
  const int side = 2 * static_cast<int>(std::ceil(look.radius + look.rim + 1));
  std::vector<std::uint8_t> texels(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * 4);
  const auto covered = [](float radius, float distance) { return std::clamp(radius - distance + 0.5F, 0.0F, 1.0F); };
  std::size_t at = 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x, at += 4) {
      const float middle = 0.5F * static_cast<float>(side) - 0.5F;
      const float distance = std::hypot(static_cast<float>(x) - middle, static_cast<float>(y) - middle);
      const float disc = covered(look.radius, distance);
      const float fill = disc * (1 - (1 - look.inside) * covered(look.radius - look.ring, distance));
      const float dark = 0.6F * (covered(look.radius + look.rim, distance) - disc);
      const float alpha = fill + dark;
      const float white = alpha > 0 ? fill / alpha : 1;
      texels[at] = texels[at + 1] = texels[at + 2] = static_cast<std::uint8_t>(std::lround(255 * white));
      texels[at + 3] = static_cast<std::uint8_t>(std::lround(255 * alpha));
    }
  }
  return {gl, Texture::Format::rgba8, {side, side}, texels.data()};
}

// By share of the largest. What adds little recedes, but an element under the footprint is never quite gone.
std::array<ImU32, 256> inks() {
  std::array<ImU32, 256> result{};
  const std::array<DisplayColor, 256> table = viridis_table();
  for (std::size_t k = 0; k < result.size(); ++k) {
    const double alpha = 0.15 + 0.85 * std::min(1.0, std::sqrt(static_cast<double>(k) / 64));
    result[k] = IM_COL32(table[k].x, table[k].y, table[k].z, static_cast<int>(std::lround(255 * alpha)));
  }
  return result;
}

}  // namespace

void ElementOverlay::draw(Ui& ui, ImDrawList& list, const MapCamera& camera, const ShownElements& shown) {
  if (shown.elements.empty()) return;
  const auto radius = static_cast<float>(shown.radius * camera.pixels_per_texel);
  const float painted = std::min(radius, k_largest_disc);
  if (disc_.empty() || disc_radius_ != painted || disc_scale_ != ui.scale) {
    disc_ = disc_picture(ui.gl, look_of(painted, ui.scale));
    disc_radius_ = painted;
    disc_scale_ = ui.scale;
  }
  static const std::array<ImU32, 256> k_inks = inks();
  const auto ink = [](float share) { return k_inks[static_cast<std::size_t>(std::lround(255 * share))]; };
  const float edge = 0.5F * static_cast<float>(disc_.size().x) / painted;  // of the picture, in radii
  const double grain = static_cast<double>(ui.px(1)) / camera.pixels_per_texel;
  const std::size_t whole = shown.elements.size() - shown.parts.size();
  list.PushTextureID(ui.pictures.add(disc_, {}));
  // Of four vertices each: their indices have 16 bits, and room is reserved for one batch after another.
  constexpr std::size_t k_batch = 8000;
  const auto in_batches = [&](std::size_t count, const auto& body) {
    for (std::size_t first = 0; first < count; first += k_batch) {
      const std::size_t last = std::min(first + k_batch, count);
      list.PrimReserve(6 * static_cast<int>(last - first), 4 * static_cast<int>(last - first));
      for (std::size_t k = first; k < last; ++k) body(k);
    }
  };
  in_batches(shown.elements.size(), [&](std::size_t k) {
    const ImVec2 at = screen_of_texel(camera, shown.elements[k].seed);
    const float half = edge * radius;
    const float share = k < whole ? shown.elements[k].share : 0;  // under its part
    list.PrimRectUV({at.x - half, at.y - half}, {at.x + half, at.y + half}, {0, 0}, {1, 1}, ink(share));
  });
  in_batches(shown.parts.size(), [&](std::size_t k) {
    const ElementPart& part = shown.parts[k];
    // A pixel wide at least.
    const SymmetricMatrix2& c = part.covariance;
    const CholeskyFactor l = cholesky({c.xx + 0.5 * grain * grain, c.xy, c.yy + 0.5 * grain * grain});
    const double to_edge = static_cast<double>(edge);
    const auto corner = [&](double x, double y) {
      return screen_of_texel(camera, part.center + to_edge * l.apply({x, y}));
    };
    list.PrimQuadUV(corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1), {0, 0}, {1, 0}, {1, 1}, {0, 1},
                    ink(shown.elements[whole + k].share));
  });
  list.PopTextureID();
}

void ElementOverlay::draw_legend(Ui& ui, ImDrawList& list, ImVec2 at, float width, const ShownElements& shown,
                                 std::vector<Rectangle>& taken) {
  static constexpr std::array<std::string_view, 2> k_weight{"element weight", "weight"};
  static constexpr std::array<std::string_view, 3> k_density{"part of D at the crosshair", "part of D(s)", "of D"};
  constexpr std::string_view k_title = "Elements of the mixture";
  std::string instead(shown.instead);
  if (instead.empty() && shown.largest <= 0) instead = "no element reaches the crosshair";
  Rectangle area;
  if (instead.empty()) {
    const std::string high = number_text(shown.largest);
    area = legend_.draw(ui, list, at, width,
                        {shown.by_density ? std::span<const std::string_view>(k_density) : k_weight, "0", high});
  } else {
    area = draw_chip(ui, list, at, fitted_text(ui.fonts.small, instead, width - ui.px(12)));
  }
  taken.push_back(area);
  ui.widgets.record("map.elements", {area, instead, false, false});
  const std::string text =
      shown.by_density
          ? "Which light up for this half vector: circles of radius σh round their seeds and, from near by, the parts "
            "of "
            "them that turn to it, coloured by what each adds to the mixture's D at the crosshair."
          : "Circles of radius σh round their seeds, coloured by their weight under the footprint. A crosshair in the "
            "P-NDF shows which of them light up for its normal.";
  explain(ui, "map.elements", area, {std::string(k_title), text, {}});
  if (shown.left_out == 0) return;
  const std::string cut =
      fmt::format("the {} that {} most, of {}", count_text(shown.elements.size()), shown.by_density ? "add" : "weigh",
                  count_text(shown.elements.size() + shown.left_out));
  taken.push_back(
      draw_chip(ui, list, {at.x, area.max.y + ui.px(4)}, fitted_text(ui.fonts.small, cut, width - ui.px(12))));
}

}  // namespace glint::view
