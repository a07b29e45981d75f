#pragma once
// The map on the graphics card: squares of its pyramid's levels, coloured when they are first looked at and forgotten
// when they were not looked at for longest.

#include <chrono>
#include <compare>
#include <cstddef>
#include <list>
#include <map>
#include <memory>

#include <glm/vec2.hpp>

#include "core/document/document.h"
#include "core/surface/normal_pyramid.h"
#include "viewers/gl/gl_functions.h"
#include "viewers/gl/texture.h"

namespace glint::view {

/// One square of 254 x 254 texels of a level, with a frame of one texel of its neighbours so that linear filtering
/// shows no seams. The last of a row or column is narrower.
struct TileKey {
  int level = 0;
  int x = 0;  ///< in tiles
  int y = 0;

  friend auto operator<=>(const TileKey&, const TileKey&) = default;
};

inline constexpr int k_tile_texels = 254;  ///< along a side, without the frame

/// How many tiles a level has in both directions.
glm::ivec2 tile_count(const NormalPyramid& pyramid, int level);
/// The tile of the next coarser level that shows the same part of the map. Exists while level + 1 does.
TileKey coarser(const TileKey& key);

/// Frame thread only; the context of `gl` must outlive this.
class MapTiles {
 public:
  static constexpr std::size_t k_most_bytes = std::size_t{64} << 20;

  /// `most_bytes` of texels are kept at most.
  explicit MapTiles(const GlFunctions& gl, std::size_t most_bytes = k_most_bytes) : gl_(gl), most_bytes_(most_bytes) {}

  /// Before the first use in a frame: what is shown, and how long tiles may be made in it. Another pyramid or other
  /// colours drop all tiles.
  void begin_frame(std::shared_ptr<const NormalPyramid> pyramid, MapColors colors,
                   std::chrono::steady_clock::duration budget);

  struct Found {
    const Texture* texture = nullptr;  ///< valid until the frame was drawn
    TileKey key;                       ///< that asked for, or a coarser one that shows it too
  };
  /// The tile, made if there is time left, else the finest coarser one there is, else the one tile of the finest level
  /// that is a single tile: that is made in any case. A tile handed out in a frame is not forgotten in it, even if that
  /// exceeds the limit.
  Found find(const TileKey& key);

  /// Whether a tile was asked for that could not be made: another frame will show more.
  [[nodiscard]] bool incomplete() const { return incomplete_; }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] std::size_t count() const { return tiles_.size(); }

 private:
  struct Tile {
    Texture texture;
    std::size_t frame = 0;  // it was last handed out in
    std::list<TileKey>::iterator place;
  };

  const Texture* existing(const TileKey& key);
  const Texture* make(const TileKey& key);
  void forget_oldest();

  const GlFunctions& gl_;
  std::size_t most_bytes_;
  std::shared_ptr<const NormalPyramid> pyramid_;
  MapColors colors_ = MapColors::normal;
  std::chrono::steady_clock::time_point deadline_{};
  std::size_t frame_ = 0;
  std::size_t bytes_ = 0;
  bool incomplete_ = false;
  std::map<TileKey, Tile> tiles_;
  std::list<TileKey> recent_;  // most recently used first
};

}  // namespace glint::view
