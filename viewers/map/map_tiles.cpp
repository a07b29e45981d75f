#include "viewers/map/map_tiles.h"

#include <algorithm>
#include <utility>

#include "viewers/map/map_colors.h"

namespace glint::view {
namespace {

std::size_t bytes_of(const Texture& texture) {
  return static_cast<std::size_t>(texture.size().x) * static_cast<std::size_t>(texture.size().y) * 4;
}

}  // namespace

glm::ivec2 tile_count(const NormalPyramid& pyramid, int level) {
  return {(pyramid.width(level) + k_tile_texels - 1) / k_tile_texels,
          (pyramid.height(level) + k_tile_texels - 1) / k_tile_texels};
}

TileKey coarser(const TileKey& key) {
  return {key.level + 1, key.x / 2, key.y / 2};
}

void MapTiles::begin_frame(std::shared_ptr<const NormalPyramid> pyramid, MapColors colors,
                           std::chrono::steady_clock::duration budget) {
  if (pyramid != pyramid_ || colors != colors_) {
    tiles_.clear();
    recent_.clear();
    bytes_ = 0;
  }
  pyramid_ = std::move(pyramid);
  colors_ = colors;
  using Clock = std::chrono::steady_clock;
  const Clock::time_point now = Clock::now();
  deadline_ = budget < Clock::time_point::max() - now ? now + budget : Clock::time_point::max();
  incomplete_ = false;
  ++frame_;
  forget_oldest();
}

MapTiles::Found MapTiles::find(const TileKey& key) {
  if (const Texture* texture = existing(key)) return {texture, key};
  if (std::chrono::steady_clock::now() < deadline_) return {make(key), key};
  TileKey other = key;
  while (tile_count(*pyramid_, other.level) != glm::ivec2(1, 1)) {  // the last level is one tile
    incomplete_ = true;
    other = coarser(other);
    if (const Texture* texture = existing(other)) return {texture, other};
  }
  return {make(other), other};
}

const Texture* MapTiles::existing(const TileKey& key) {
  const auto found = tiles_.find(key);
  if (found == tiles_.end()) return nullptr;
  recent_.splice(recent_.begin(), recent_, found->second.place);
  found->second.frame = frame_;
  return &found->second.texture;
}

const Texture* MapTiles::make(const TileKey& key) {
  const glm::ivec2 first(key.x * k_tile_texels, key.y * k_tile_texels);
  const glm::ivec2 size(std::min(k_tile_texels, pyramid_->width(key.level) - first.x) + 2,
                        std::min(k_tile_texels, pyramid_->height(key.level) - first.y) + 2);
  const std::vector<std::uint8_t> texels = colored_texels(*pyramid_, colors_, key.level, first - glm::ivec2(1), size);
  recent_.push_front(key);
  Tile& tile = tiles_[key];
  tile = {Texture(gl_, Texture::Format::rgba8, size, texels.data()), frame_, recent_.begin()};
  bytes_ += bytes_of(tile.texture);
  forget_oldest();
  return &tile.texture;
}

// Never what this frame draws.
void MapTiles::forget_oldest() {
  while (bytes_ > most_bytes_ && !recent_.empty()) {
    const auto oldest = tiles_.find(recent_.back());
    if (oldest->second.frame == frame_) return;
    bytes_ -= bytes_of(oldest->second.texture);
    tiles_.erase(oldest);
    recent_.pop_back();
  }
}

}  // namespace glint::view
