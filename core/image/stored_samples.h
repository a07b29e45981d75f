#pragma once
// What a file holds before it is decoded, for a read-out at the cursor: the numbers another program would show.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/image/image_file.h"

namespace glint {

/// The stored value of each channel read of each texel: integers of up to 8 and 16 bits in one and two bytes,
/// everything else as float (integers of more bits as the reader delivers them, scaled to 1). Immutable once the file
/// is read.
class StoredSamples {
 public:
  /// More than this is not kept.
  static constexpr std::size_t k_most_bytes = std::size_t{256} << 20;

  /// Of no file.
  StoredSamples() = default;
  /// Of the channels of those indices, as read_rows() delivers them. Memory is taken here, if at all.
  StoredSamples(const ImageInfo& info, std::span<const int> channels);

  /// Keeps a block of the rows; nothing where the file is too large.
  void keep(const RowBlock& block);

  /// True where nothing is kept: of no file, or of one that is too large.
  [[nodiscard]] bool empty() const { return bytes() == 0; }
  [[nodiscard]] bool too_large() const { return too_large_; }
  [[nodiscard]] std::size_t bytes() const;

  /// Names of the channels kept, in the order of their values.
  [[nodiscard]] const std::vector<std::string>& channels() const { return channels_; }
  /// Of a sample in the file.
  [[nodiscard]] int bits() const { return bits_; }

  /// The value of a channel of the texel in column i and row j, which lies on the map; not for an empty one.
  [[nodiscard]] double value(int i, int j, std::size_t channel) const;
  /// All values of that texel: "94 93 247", "0.125 -0.5 0.99"; where empty, why.
  [[nodiscard]] std::string text(int i, int j) const;

 private:
  [[nodiscard]] std::size_t index(int i, int j) const {
    return (static_cast<std::size_t>(j) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(i)) *
           channels_.size();
  }

  int width_ = 0;
  int bits_ = 0;
  bool signed_ = false;
  bool too_large_ = false;
  double largest_ = 1;  // the integer that is delivered as 1
  std::vector<std::string> channels_;
  /// Signed integers as their two's complement.
  std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>> values_;
};

}  // namespace glint
