#include "tests/bench/svg_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/image/atomic_file.h"

namespace glint::bench {
namespace {

// Okabe and Ito's, which colour-blind people tell apart.
constexpr std::array<const char*, 8> k_colors{"#0072b2", "#e69f00", "#009e73", "#d55e00",
                                              "#cc79a7", "#56b4e9", "#f0e442", "#000000"};
constexpr double k_width = 380;
constexpr double k_height = 340;
constexpr double k_left = 70;
constexpr double k_top = 64;
constexpr double k_gap = 90;

struct Axis {
  int first;  // powers of ten
  int last;
  double from;  // pixels
  double to;

  [[nodiscard]] double at(double value) const {
    return from + (to - from) * (std::log10(value) - first) / (last - first);
  }
};

Axis axis_over(const std::vector<PlotPanel>& panels, double PlotPoint::*field, double from, double to) {
  double least = 1e300;
  double most = 0;
  for (const PlotPanel& panel : panels) {
    for (const PlotPoint& point : panel.points) {
      if (!(point.*field > 0)) continue;
      least = std::min(least, point.*field);
      most = std::max(most, point.*field);
    }
  }
  if (!(most > 0)) return {0, 1, from, to};
  const int first = static_cast<int>(std::floor(std::log10(least)));
  return {first, std::max(first + 1, static_cast<int>(std::ceil(std::log10(most)))), from, to};
}

std::string escaped(const std::string& words) {
  std::string out;
  for (const char c : words) out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  return out;
}

std::string text(double x, double y, const char* anchor, const std::string& words, int size = 12) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\">{}</text>\n", x, y, anchor,
                     size, escaped(words));
}

std::string axes(const Axis& x, const Axis& y) {
  std::string out;
  for (int k = x.first; k <= x.last; ++k) {
    const double at = x.at(std::pow(10, k));
    out += fmt::format("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke=\"#ddd\"/>\n", at, y.from, y.to);
    out += text(at, y.from + 18, "middle", fmt::format("{:g}", std::pow(10, k)));
  }
  for (int k = y.first; k <= y.last; ++k) {
    const double at = y.at(std::pow(10, k));
    out += fmt::format("<path d=\"M{0:.1f} {1:.1f}H{2:.1f}\" stroke=\"#ddd\"/>\n", x.from, at, x.to);
    out += text(x.from - 6, at + 4, "end", fmt::format("1e{}", k));
  }
  return out;
}

}  // namespace

Status write_plot(const std::filesystem::path& file, const std::string& title, const std::vector<PlotPanel>& panels) {
  std::vector<std::string> names;
  for (const PlotPanel& panel : panels) {
    for (const PlotPoint& point : panel.points) {
      if (std::find(names.begin(), names.end(), point.name) == names.end()) names.push_back(point.name);
    }
  }
  const auto color = [&](const std::string& name) {
    const auto at = std::find(names.begin(), names.end(), name) - names.begin();
    return k_colors[static_cast<std::size_t>(at) % k_colors.size()];
  };
  const double width = k_left + static_cast<double>(panels.size()) * (k_width + k_gap);
  const double legend = k_top + k_height + 56;
  const double height = legend + 20 * std::ceil(static_cast<double>(names.size()) / 3) + 10;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" font-family=\"sans-serif\" "
      "fill=\"#222\">\n<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#fff\"/>\n",
      width, height);
  out += text(k_left, 24, "start", title, 15);
  for (std::size_t k = 0; k < panels.size(); ++k) {
    const double left = k_left + static_cast<double>(k) * (k_width + k_gap);
    const Axis x = axis_over(panels, &PlotPoint::milliseconds, left, left + k_width);
    const Axis y = axis_over(panels, &PlotPoint::error, k_top + k_height, k_top);
    out += axes(x, y);
    out += text(left, k_top - 12, "start", panels[k].title, 13);
    out += text(left + k_width / 2, k_top + k_height + 36, "middle", "ms per image");
    if (k == 0) {
      out += fmt::format(
          "<text transform=\"translate(16 {:.1f}) rotate(-90)\" text-anchor=\"middle\" "
          "font-size=\"12\">relative L1 against double precision</text>\n",
          k_top + k_height / 2);
    }
    for (const PlotPoint& point : panels[k].points) {
      if (!(point.milliseconds > 0 && point.error > 0)) continue;
      out += fmt::format(
          "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" fill=\"{}\"><title>{}: {:.3g} ms, {:.2g}</title></circle>\n",
          x.at(point.milliseconds), y.at(point.error), color(point.name), escaped(point.name), point.milliseconds,
          point.error);
    }
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    const double x = k_left + 260 * static_cast<double>(k % 3);
    const double y = legend + 20 * static_cast<double>(k / 3);
    out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" fill=\"{}\"/>\n", x, y, color(names[k]));
    out += text(x + 10, y + 4, "start", names[k]);
  }
  out += "</svg>\n";
  return write_file(file, out);
}

}  // namespace glint::bench
