#pragma once
// From the values of a file to normals, texel by texel, with a count of everything that had to be repaired. 2c - 1,
// length and division run in double; the resulting (s, t) are rounded to float once, by being stored.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/image/channel_layout.h"
#include "core/image/normal_map_reader.h"

namespace glint {

/// How often something happened, and where first (column, row).
struct TexelCount {
  std::size_t count = 0;
  glm::ivec2 first{0, 0};

  void add(glm::ivec2 texel) {
    if (count++ == 0) first = texel;
  }
};

struct DecodingRules {
  Layout layout = Layout::vector;  ///< neither height nor constant_grey
  bool signed_values = false;      ///< values as they stand, else 2c - 1
  GreenDirection green = GreenDirection::up;
  bool measure_transfer = false;  ///< fill the length errors after transfer curves: two powers a value
};

struct DecodingCounts {
  std::size_t texels = 0;
  TexelCount not_finite;   ///< made flat
  TexelCount zero;         ///< vectors without a direction, made flat
  TexelCount beyond_rim;   ///< (s, t) longer than 1, scaled onto the rim
  TexelCount turned_away;  ///< z <= 0, kept

  // Three channels only, over the texels that were not made flat.
  double least_length = 0;
  double greatest_length = 0;
  double length_error = 0;               ///< sum of | |v| - 1 |
  double length_error_linearised = 0;    ///< likewise after the sRGB curve was taken off the values
  double length_error_encoded = 0;       ///< likewise after the sRGB curve was put on the values
  std::size_t vectors = 0;               ///< how many went into the sums
  glm::dvec3 sum{0, 0, 0};               ///< of the unit vectors
  std::array<std::size_t, 6> leaning{};  ///< unit vectors beyond 0.6 along +x, -x, +y, -y, +z, -z
};

/// Decodes blocks of rows, whose samples follow ChannelChoice::all(), into a map of the given width.
class NormalDecoder {
 public:
  NormalDecoder(const DecodingRules& rules, std::size_t channels_per_texel, int width, std::span<glm::vec2> normals);

  void decode(const RowBlock& block);
  [[nodiscard]] const DecodingCounts& counts() const { return counts_; }

 private:
  [[nodiscard]] double value(float stored) const;
  [[nodiscard]] glm::dvec2 texel(const float* samples, glm::ivec2 at);
  [[nodiscard]] glm::dvec2 from_vector(const float* samples, glm::ivec2 at);
  [[nodiscard]] glm::dvec2 from_pair(float x, float y, glm::ivec2 at);
  void measure_transfer(const float* samples);

  DecodingRules rules_;
  std::size_t stride_;
  int width_;
  std::span<glm::vec2> normals_;
  DecodingCounts counts_;
};

}  // namespace glint
