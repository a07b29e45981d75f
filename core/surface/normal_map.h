#pragma once
// A normal map in memory: one projected normal (s, t) per texel, as float. Those floats *are* the map for every method,
// double precision included (docs: a file's pixels are decoded in double and rounded to float once).

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace glint {

/// What lies beyond the border: the map again, or its border texels.
enum class Wrap { repeat, clamp };

/// Immutable after construction; safe to read from any thread.
/// Texel (i, j) holds its normal at u = (i + 0.5, j + 0.5) texels; i runs right, j runs down.
class NormalMap {
 public:
  /// `normals` holds width x height (s, t) pairs, rows from the top. Both sizes are at least 1.
  NormalMap(int width, int height, std::vector<glm::vec2> normals, Wrap wrap, bool piecewise_constant = false);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] Wrap wrap() const { return wrap_; }
  /// True for maps of flakes: normals jump between texels and nothing may be interpolated.
  [[nodiscard]] bool piecewise_constant() const { return piecewise_constant_; }
  [[nodiscard]] std::size_t bytes() const { return normals_.size() * sizeof(glm::vec2); }
  [[nodiscard]] const std::vector<glm::vec2>& normals() const { return normals_; }

  /// The texel in column i and row j; any i and j, brought inside by the map's wrap.
  [[nodiscard]] glm::vec2 texel(std::int64_t i, std::int64_t j) const {
    return normals_[static_cast<std::size_t>(inside(j, height_)) * static_cast<std::size_t>(width_) +
                    static_cast<std::size_t>(inside(i, width_))];
  }

 private:
  [[nodiscard]] std::int64_t inside(std::int64_t k, std::int64_t size) const {
    if (k >= 0 && k < size) return k;
    if (wrap_ == Wrap::clamp) return k < 0 ? 0 : size - 1;
    const std::int64_t remainder = k % size;
    return remainder < 0 ? remainder + size : remainder;
  }

  int width_;
  int height_;
  Wrap wrap_;
  bool piecewise_constant_;
  std::vector<glm::vec2> normals_;
};

/// The largest width or height of a map, in texels.
inline constexpr int k_largest_map_side = 16384;

}  // namespace glint
