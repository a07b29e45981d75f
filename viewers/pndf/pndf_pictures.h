#pragma once
// P-NDF images as textures, made once each, the differences of two of them, and what an image says at a normal.

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "core/pndf/model_factory.h"
#include "core/pndf/pndf_grid.h"
#include "viewers/gl/texture.h"

namespace glint::view {

using ImagePointer = std::shared_ptr<const PndfImage>;

/// Values by rows from the top, ready for a texture.
struct Texels {
  glm::ivec2 size{0, 0};
  std::vector<float> values;
};

/// Cells as texels; where a side has more than `most`, blocks of n x n cells as their mean (fewer at the far edges).
/// A block that holds a NaN is NaN: it is seen.
Texels reduced_texels(const PndfGrid& grid, std::span<const double> cells, int most = 1024);

struct CellReading {
  double density = 0;
  std::optional<double> standard_error;
};
/// The cell that holds `s`; none outside the window. A normal on an edge belongs to the cell of larger s and smaller t,
/// one on the far edges of the window to the last cell.
std::optional<CellReading> read_cell(const PndfImage& image, glm::dvec2 s);

/// The largest magnitude among values that are numbers; 0 if there is none.
double largest_magnitude(std::span<const double> values);

/// One image minus another on the same grid.
struct DifferenceImage {
  PndfGrid grid;
  std::vector<double> values;
  double largest = 0;  ///< of their magnitudes
};
/// `image` - `reference`; none where their grids differ.
std::optional<DifferenceImage> difference_of(const PndfImage& image, const PndfImage& reference);
/// The value of the cell that holds `s`.
std::optional<double> difference_at(const DifferenceImage& difference, glm::dvec2 s);

/// An image on the graphics card.
struct ShownImage {
  ImagePointer image;
  Texture texture;
  double largest = 0;
  double mass = 0;  ///< its integral
};

struct ShownDifference {
  ImagePointer image;
  ImagePointer reference;
  DifferenceImage difference;
  Texture texture;
};

/// Keeps what was asked for since the last forget_unused(). One context, one thread.
class PndfPictures {
 public:
  /// Addresses stay valid until forget_unused().
  const ShownImage& shown(const GlFunctions& gl, const ImagePointer& image);
  /// Null where the grids differ.
  const ShownDifference* shown_difference(const GlFunctions& gl, const ImagePointer& image,
                                          const ImagePointer& reference);
  /// At the end of a frame.
  void forget_unused();

 private:
  template <class Shown>
  struct Kept {
    std::unique_ptr<Shown> shown;
    bool used = true;
  };
  std::vector<Kept<ShownImage>> images_;
  std::vector<Kept<ShownDifference>> differences_;
};

/// Minuend and subtrahend of the difference between two or more methods: a method less exact, else the second less the
/// first.
std::pair<PndfMethod, PndfMethod> difference_pair(const std::vector<PndfMethod>& methods);

}  // namespace glint::view
