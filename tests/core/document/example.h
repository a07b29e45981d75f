#pragma once
// A document in which every field has a legal value other than its default, and the ways to one field of it.

#include <map>
#include <string>

#include "core/document/parameter.h"

namespace glint::test {

using Numbers = std::vector<double>;
using Texts = std::vector<std::string>;

/// For every parameter a value that differs from the default.
inline const std::map<std::string, ParameterValue, std::less<>>& other_values() {
  static const std::map<std::string, ParameterValue, std::less<>> values{
      {"name", "worn \"steel\" \\ é"},
      {"surface.source", "noise"},
      {"surface.path", "maps/with space é.png"},
      {"surface.range", "signed"},
      {"surface.green", "down"},
      {"surface.height_scale", 0.1 + 0.2},
      {"surface.wrap", "clamp"},
      {"surface.interpolation", "constant"},
      {"surface.generator.size", std::uint64_t{512}},
      {"surface.generator.seed", std::uint64_t{18446744073709551615U}},
      {"surface.generator.spectrum", "gaussian"},
      {"surface.generator.rms_slope", 1.0 / 3.0},
      {"surface.generator.correlation_length", 12.1},
      {"surface.generator.wavelengths", Numbers{2.2, 64.7}},
      {"surface.generator.count", std::uint64_t{321}},
      {"surface.generator.length", Numbers{33.3, 444.4}},
      {"surface.generator.half_width", Numbers{0.7, 0.7}},
      {"surface.generator.flank_slope", Numbers{0.011, 0.2}},
      {"surface.generator.direction", -33.3},
      {"surface.generator.spread", 5e-324},
      {"surface.generator.blur", 1e-7},
      {"surface.generator.dent_rms_slope", 0.1},
      {"surface.generator.radius", 7.7},
      {"surface.generator.alpha", 1.41},
      {"surface.generator.flat_share", 0.25},
      {"footprint.center", Numbers{-123456.789, 1e-5}},
      {"footprint.covariance", Numbers{1e9, -0.3, 2.0 / 3.0}},
      {"intrinsic_roughness", 0.0123456789012345678},
      {"methods", Texts{"binning", "mixture", "auto", "exact"}},
      {"exact.vertex_shift", true},
      {"exact.precision", "double"},
      {"mixture.step", 0.3},
      {"mixture.kappa", 0.55},
      {"mixture.elements", "curved"},
      {"auto.tolerance", 0.003},
      {"binning.samples", std::uint64_t{9'999'999'999}},
      {"grid.size", std::uint64_t{16384}},
      {"grid.window", Numbers{-1, -0.1, 0.30000000000000004, 1.5}},
      {"seed", std::uint64_t{9007199254740993}},  // 2^53 + 1: no double
      {"view.density_scale", "linear"},
      {"view.density_range", Numbers{1e-30, 1234.5}},
      {"view.difference_range", 0.1},
      {"view.map_colors", "curvature"},
      {"view.elements", true},
  };
  return values;
}

inline const ParameterValue& other_value(const Parameter& parameter) {
  return other_values().find(parameter.path)->second;
}

inline Document document_with_all_set() {
  Document document;
  for (const Parameter& parameter : parameters()) {
    if (!parameter.set(document, other_value(parameter))) return {};
  }
  return document;
}

}  // namespace glint::test
