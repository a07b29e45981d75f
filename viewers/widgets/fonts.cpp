#include "viewers/widgets/fonts.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <imgui_freetype.h>
#include <span>
#include <string>
#include <system_error>

namespace glint::view {
namespace {

using Files = std::span<const char* const>;

constexpr std::array k_regular = {"/usr/share/fonts/opentype/inter/Inter-Regular.otf",
                                  "/usr/share/fonts/truetype/inter/Inter-Regular.ttf",
                                  "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"};
constexpr std::array k_semi_bold = {"/usr/share/fonts/opentype/inter/Inter-SemiBold.otf",
                                    "/usr/share/fonts/truetype/inter/Inter-SemiBold.ttf",
                                    "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"};
constexpr std::array k_mono = {"/usr/share/fonts/truetype/jetbrains-mono/JetBrainsMono-Regular.ttf",
                               "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf"};

// Latin with its supplement, Greek, and the signs that units, errors and formulas need.
constexpr std::array<ImWchar, 37> k_glyphs = {
    0x0020, 0x00FF, 0x0391, 0x03C9, 0x2013, 0x2014, 0x2018, 0x201D, 0x2022, 0x2022, 0x2026, 0x2026, 0x2070,
    0x2079, 0x207A, 0x207B, 0x2080, 0x2089, 0x2190, 0x2193, 0x2202, 0x2202, 0x2211, 0x2212, 0x221A, 0x221E,
    0x222B, 0x222B, 0x2248, 0x2248, 0x2264, 0x2265, 0x22C5, 0x22C5, 0x00B5, 0x00B5, 0};

ImFont* add(ImFontAtlas& atlas, Files files, float pixels) {
  ImFontConfig config;
  config.OversampleH = 1;
  config.PixelSnapH = true;
  for (const char* file : files) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) continue;
    if (ImFont* font = atlas.AddFontFromFileTTF(file, pixels, &config, k_glyphs.data())) return font;
  }
  config.SizePixels = pixels;
  return atlas.AddFontDefault(&config);
}

float whole(float pixels) {
  return std::floor(pixels + 0.5F);
}

}  // namespace

Fonts load_fonts(float scale) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
  Fonts fonts;
  fonts.text = add(atlas, k_regular, whole(16 * scale));
  fonts.small = add(atlas, k_regular, whole(14 * scale));
  fonts.title = add(atlas, k_semi_bold, whole(16 * scale));
  fonts.numbers = add(atlas, k_mono, whole(16 * scale));
  fonts.small_numbers = add(atlas, k_mono, whole(15 * scale));
  atlas.Build();
  return fonts;
}

}  // namespace glint::view
