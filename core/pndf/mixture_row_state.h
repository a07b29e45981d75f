#pragma once
// What one thread keeps while it makes rows of elements: which texels and weights each seed takes.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/pndf/footprint_window.h"
#include "core/pndf/mixture_rows.h"

namespace glint {

/// Seeds of a row that vectors take together: of one phase, where each stands a texel further than the one before, or
/// all of them.
struct SeedRun {
  bool contiguous;                                       ///< texel[k + 1] = texel[k] + 1
  std::vector<std::int32_t> texel;                       ///< the first of four, from the window's first
  std::vector<float> offset;                             ///< u of the seed from the footprint's centre
  std::array<std::vector<float>, 4> value, slope, bend;  ///< weights of the four
  std::size_t count = 0;                                 ///< the arrays are padded to whole vectors
  std::size_t first = 0;                                 ///< those of the row under way
  std::size_t last = 0;
};

/// Weights of four rows of texels.
struct RowWeights {
  std::array<float, 4> value, slope, bend;
};

/// One component of four rows of texels, combined along v.
struct CombinedRow {
  std::vector<float> value, slope, bend;
};

struct RowPlan {
  std::int64_t texel_row;  ///< the first of four
  RowWeights weights;
  float offset;  ///< v of the seeds from the footprint's centre
};

struct MixtureRows::State {
  explicit State(const MixtureFrame& of);

  MixtureFrame frame;
  std::vector<SeedRun> runs;
  std::array<CombinedRow, 2> combined;  // of s and t

  /// Nothing for a row that the footprint does not reach.
  std::optional<RowPlan> plan(std::int64_t row);
  [[nodiscard]] std::size_t most_elements() const { return most_elements_; }
  /// The texels of the window in row j; valid until four other rows have been asked for.
  const float* texel_row(std::int64_t j, std::size_t axis);

 private:
  struct KeptRow {
    std::int64_t row = std::numeric_limits<std::int64_t>::min();
    std::array<std::vector<float>, 2> texels;
  };

  void add_seeds(std::int64_t first, std::int64_t last);

  FootprintWindow window_;  // of V
  std::int64_t first_texel_ = 0;
  std::size_t texel_count_ = 0;
  std::array<KeptRow, 4> kept_;
  std::size_t most_elements_ = 0;
};

}  // namespace glint
