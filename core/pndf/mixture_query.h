#pragma once
// D_P(s) at single normals from the elements of one footprint: prepared once, in blocks of neighbouring seeds with
// bounds of what each can reach.

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "core/pndf/mixture_rows.h"

namespace glint {

/// Immutable once made; shared between threads.
class PreparedMixture {
 public:
  static constexpr std::size_t k_block = 16;

  /// The elements of those rows within the frame's cut.
  PreparedMixture(const MixtureFrame& frame, MixtureFrame::Seeds of_rows);

  /// D_P(s): never negative, NaN or infinite.
  [[nodiscard]] double density(glm::dvec2 s) const;
  /// The integral of density(): the sum of the elements' weights, which ripples about 1 with the lattice.
  [[nodiscard]] double mass() const { return mass_; }
  [[nodiscard]] std::size_t elements() const { return count_; }

  /// Elements in blocks of k_block, the last of each band of rows filled up with amplitude 0. Per element: its mean
  /// and the whitening in amplitude 2^-((w11 x + w12 y)^2 + (w22 y)^2), of which exponents up to `most` count.
  struct Fields {
    std::vector<float> x, y, w11, w12, w22, amplitude, most;
  };
  /// Of blocks, along s, t, s + t and s - t; padded to whole vectors.
  struct Bounds {
    std::array<std::vector<float>, 4> lo;
    std::array<std::vector<float>, 4> hi;
  };
  [[nodiscard]] const Fields& fields() const { return fields_; }
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }
  [[nodiscard]] std::size_t blocks() const { return blocks_; }

 private:
  Fields fields_;
  Bounds bounds_;
  std::size_t count_ = 0;
  std::size_t blocks_ = 0;
  double mass_ = 0;
};

}  // namespace glint
