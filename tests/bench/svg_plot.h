#pragma once
// A plot of time against error as an SVG file: one panel a footprint, both axes logarithmic.

#include <filesystem>
#include <string>
#include <vector>

#include "core/math/result.h"

namespace glint::bench {

struct PlotPoint {
  std::string name;  ///< in the legend; equal names have one colour
  double milliseconds;
  double error;
};

struct PlotPanel {
  std::string title;
  std::vector<PlotPoint> points;
};

/// Never leaves half a file.
Status write_plot(const std::filesystem::path& file, const std::string& title, const std::vector<PlotPanel>& panels);

}  // namespace glint::bench
