#pragma once
// P-NDF images: D_P(s) over a grid of projected normals.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace glint {

/// A window of the projected hemisphere, cut into columns x rows cells. Row 0 holds the largest t, column 0 the
/// smallest s.
struct PndfGrid {
  double s_min = -1;
  double s_max = 1;
  double t_min = -1;
  double t_max = 1;
  int columns = 256;
  int rows = 256;

  [[nodiscard]] glm::dvec2 pitch() const { return {(s_max - s_min) / columns, (t_max - t_min) / rows}; }
  [[nodiscard]] double cell_area() const { return pitch().x * pitch().y; }
  [[nodiscard]] std::size_t cells() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  /// The projected normal at the centre of a cell.
  [[nodiscard]] glm::dvec2 center(int column, int row) const {
    return {s_min + (column + 0.5) * pitch().x, t_max - (row + 0.5) * pitch().y};
  }

  /// Column and row of the cell that holds s, if it lies in the window.
  [[nodiscard]] std::optional<glm::ivec2> cell_at(glm::dvec2 s) const;

  friend bool operator==(const PndfGrid&, const PndfGrid&) = default;
};

inline constexpr int k_largest_grid_side = 16384;

/// What is wrong with it, as half a sentence, or nothing.
std::optional<std::string> grid_fault(const PndfGrid& grid);

/// What a method knows of its error (relative L1) without a reference, and how it knows.
struct PndfError {
  /// Its bounded parts cannot be larger together: merging, a footprint's windows, the cuts of exact methods (those of a
  /// mixture's images, which move 1.5e-3 of the mass, are not in it).
  double bounded = 0;
  std::optional<double> estimated;  ///< a measured guess of all others: a standard error where the method is random, 0
                                    ///< where there are none; nothing where there is no guess

  /// Of all parts, where that is known.
  [[nodiscard]] std::optional<double> total() const {
    return estimated ? std::optional(bounded + *estimated) : std::nullopt;
  }
};

/// Who computed an image, where a method chooses among others.
struct PndfAnswer {
  std::string text;   ///< "mixture, h = 0.5"; empty where there was no choice
  double step = 0;    ///< of a mixture
  bool known = true;  ///< whether the method's estimate met its tolerance
};

struct PndfImage {
  PndfGrid grid;
  std::vector<double> density;         ///< per unit of disk area, grid.cells() values by rows
  std::vector<double> standard_error;  ///< of each cell; empty where the method has none
  glm::dvec2 widening{0, 0};           ///< variance added to sigma_r^2 along s and t: pitch^2 / 12, or 0
  PndfError error;
  PndfAnswer answer;
  std::size_t invalid_samples = 0;  ///< Monte Carlo only: draws outside the unit disk
  std::size_t outside_samples = 0;  ///< Monte Carlo only: draws outside the window, valid or not
};

/// pitch^2 / 12 on each axis: the variance by which a Gaussian is widened when it is averaged over a cell.
glm::dvec2 mean_widening(const PndfGrid& grid);

/// The variance by which an image widens sigma_r^2 on each axis: pitch^2 / 12 where sigma_r < 0.6 pitch, else 0.
glm::dvec2 widening_for(const PndfGrid& grid, double intrinsic_roughness);

/// Sum of cells x cell area: 1 where the window contains the lobe.
double integral(const PndfImage& image);

/// The mean normal of the image, weighted by density; (0, 0) for an image without mass.
glm::dvec2 mean_normal(const PndfImage& image);

}  // namespace glint
