#pragma once
// The flakes of one footprint, in order of their normals: neighbours on a surface of flakes have nothing in common, so
// that boxes over parts of it would hold every normal, but of those about one normal only few are to be looked at.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "core/math/random.h"
#include "core/pndf/flake_grid.h"
#include "core/pndf/mixture_rows.h"

namespace glint {

/// D(s) = sum of w_i N(s; s_i, diag(roughness^2)) / sum of w_i, each flake cut where its own squared distance in s and
/// what its weight is below the largest, 2 ln(w_max / w_i), exceed cut^2 together (the joint cut, counted from the
/// flake that is nearest). What is left is scaled so that its integral is exactly 1. Immutable; shared between threads.
class PreparedFlakes {
 public:
  PreparedFlakes(std::span<const Flake> flakes, std::span<const FlakeWeight> weights, glm::dvec2 roughness, double cut);

  [[nodiscard]] std::size_t count() const { return elements_.size(); }
  [[nodiscard]] double density(glm::dvec2 s) const;
  /// Drawn with exactly that density: a flake by its share, then a normal of its truncated Gaussian.
  [[nodiscard]] glm::dvec2 sample(RandomStream& random) const;
  /// In single precision, for splatting: `count` of them from `first` on in place of what is in `out`.
  void copy_to(ElementList& out, std::size_t first, std::size_t count) const;

 private:
  struct Element {
    glm::dvec2 normal;
    double amplitude;  // the density at its normal
    double room;       // squared distance in s, in deviations, where it ends
  };

  // Cells of the rectangle that holds all normals.
  [[nodiscard]] std::size_t column_of(double s) const;
  [[nodiscard]] std::size_t row_of(double t) const;

  glm::dvec2 roughness_;
  double cut_;
  glm::dvec2 corner_;
  glm::dvec2 cell_;
  std::size_t columns_;
  std::size_t rows_;
  std::vector<Element> elements_;     // by cells
  std::vector<std::uint32_t> begin_;  // of each cell, by rows, and the end
  std::vector<double> cumulative_;    // shares of the elements up to each
};

}  // namespace glint
