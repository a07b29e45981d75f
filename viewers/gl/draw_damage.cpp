#include "viewers/gl/draw_damage.h"

#include <bit>
#include <limits>
#include <utility>

#include "viewers/gl/draw_triangles.h"
#include "viewers/gl/frame_pictures.h"

namespace glint::view {
namespace {

constexpr int k_tile = 32;  // pixels
// More are not worth the passes over the recorded triangles.
constexpr std::size_t k_most_rectangles = 12;

constexpr std::uint64_t k_seed = 0x243F6A8885A308D3U;

std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x9E3779B97F4A7C15U;
  return hash ^ (hash >> 32);
}

std::uint64_t mixed(std::uint64_t hash, float a, float b) {
  return mixed(hash,
               (static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(a)) << 32) | std::bit_cast<std::uint32_t>(b));
}

std::uint64_t mixed(std::uint64_t hash, const ImDrawVert& vertex) {
  return mixed(mixed(mixed(hash, vertex.pos.x, vertex.pos.y), vertex.uv.x, vertex.uv.y), vertex.col);
}

// Of everything beside the vertices that decides a command's pixels.
std::uint64_t fingerprint(const ImDrawCmd& command, const PixelRectangle& clip) {
  const auto& picture = *static_cast<const FramePicture*>(command.GetTexID());
  const Shading& shading = picture.shading;
  // One after the other: small numbers mixed at once could cancel.
  std::uint64_t hash = mixed(k_seed, picture.texture->serial());
  hash = mixed(hash, static_cast<std::uint64_t>(shading.kind) * 4 + (shading.logarithmic ? 2U : 0U) +
                         (shading.nearest ? 1U : 0U));
  hash = mixed(hash, shading.lo, shading.hi);
  hash = mixed(hash, static_cast<std::uint64_t>(clip.x0) << 32 | static_cast<std::uint64_t>(clip.y0));
  return mixed(hash, static_cast<std::uint64_t>(clip.x1) << 32 | static_cast<std::uint64_t>(clip.y1));
}

// Beyond so many one frame around all of a row's changes is found faster than the best.
constexpr std::size_t k_most_compared = 64;

// The two whose common frame adds the fewest pixels become one.
void merge_closest(std::vector<PixelRectangle>& rectangles) {
  std::pair<std::size_t, std::size_t> best{0, 1};
  int least = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < rectangles.size(); ++i) {
    for (std::size_t j = i + 1; j < rectangles.size(); ++j) {
      const int added = around(rectangles[i], rectangles[j]).area() - rectangles[i].area() - rectangles[j].area();
      if (added >= least) continue;
      least = added;
      best = {i, j};
    }
  }
  rectangles[best.first] = around(rectangles[best.first], rectangles[best.second]);
  rectangles.erase(rectangles.begin() + static_cast<std::ptrdiff_t>(best.second));
}

// One rectangle around those that begin in the same row of tiles.
std::vector<PixelRectangle> rows_of(const std::vector<PixelRectangle>& rectangles) {
  std::vector<PixelRectangle> rows;
  for (const PixelRectangle& rectangle : rectangles) {
    if (!rows.empty() && rows.back().y0 == rectangle.y0) {
      rows.back() = around(rows.back(), rectangle);
    } else {
      rows.push_back(rectangle);
    }
  }
  return rows;
}

// A pixel drawn twice would get what is translucent twice.
bool merge_overlapping(std::vector<PixelRectangle>& rectangles) {
  for (std::size_t i = 0; i < rectangles.size(); ++i) {
    for (std::size_t j = i + 1; j < rectangles.size(); ++j) {
      if (common_part(rectangles[i], rectangles[j]).empty()) continue;
      rectangles[i] = around(rectangles[i], rectangles[j]);
      rectangles.erase(rectangles.begin() + static_cast<std::ptrdiff_t>(j));
      return true;
    }
  }
  return false;
}

}  // namespace

std::vector<PixelRectangle> DrawDamage::update(const ImDrawData& data) {
  const ImVec2 size = data.DisplaySize;
  const bool whole = size.x != size_.x || size.y != size_.y;
  size_ = size;
  columns_ = (static_cast<int>(size.x) + k_tile - 1) / k_tile;
  rows_ = (static_cast<int>(size.y) + k_tile - 1) / k_tile;
  std::vector<std::uint64_t> tiles = fingerprints(data);
  std::vector<PixelRectangle> damaged;
  if (whole) {
    damaged = {{0, 0, static_cast<int>(size.x), static_cast<int>(size.y)}};
  } else {
    damaged = changed_tiles(tiles);
  }
  tiles_ = std::move(tiles);
  return damaged;
}

std::vector<std::uint64_t> DrawDamage::fingerprints(const ImDrawData& data) const {
  std::vector<std::uint64_t> tiles(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (int n = 0; n < data.CmdListsCount; ++n) {
    const ImDrawList& list = *data.CmdLists[n];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const PixelRectangle clip = clip_of(data, command);
      if (clip.empty()) continue;
      const std::uint64_t state = fingerprint(command, clip);
      for (unsigned k = 0; k < triangle_count(command); ++k) {
        const DrawTriangle triangle = triangle_of(list, command, k);
        const PixelRectangle bounds = triangle.bounds(data, clip);
        if (bounds.empty()) continue;
        const std::uint64_t hash = mixed(mixed(mixed(state, *triangle.a), *triangle.b), *triangle.c);
        for (int row = bounds.y0 / k_tile; row <= (bounds.y1 - 1) / k_tile; ++row) {
          for (int column = bounds.x0 / k_tile; column <= (bounds.x1 - 1) / k_tile; ++column) {
            std::uint64_t& tile = tiles[index_of(column, row)];
            tile = mixed(tile, hash);
          }
        }
      }
    }
  }
  return tiles;
}

std::vector<PixelRectangle> DrawDamage::changed_tiles(const std::vector<std::uint64_t>& tiles) const {
  std::vector<PixelRectangle> rectangles;
  const auto width = static_cast<int>(size_.x);
  const auto height = static_cast<int>(size_.y);
  for (int row = 0; row < rows_; ++row) {
    const auto changed = [&](int column) {
      const std::size_t index = index_of(column, row);
      return tiles[index] != tiles_[index];
    };
    for (int column = 0; column < columns_; ++column) {
      if (!changed(column)) continue;
      const int first = column;
      while (column < columns_ && changed(column)) ++column;
      const PixelRectangle run{first * k_tile, row * k_tile, std::min(column * k_tile, width),
                               std::min((row + 1) * k_tile, height)};
      const auto above = std::find_if(rectangles.begin(), rectangles.end(), [&](const PixelRectangle& r) {
        return r.x0 == run.x0 && r.x1 == run.x1 && r.y1 == run.y0;
      });
      if (above != rectangles.end()) {
        above->y1 = run.y1;
      } else {
        rectangles.push_back(run);
      }
    }
  }
  if (rectangles.size() > k_most_compared) rectangles = rows_of(rectangles);
  while (rectangles.size() > k_most_rectangles) merge_closest(rectangles);
  while (merge_overlapping(rectangles)) {
  }
  return rectangles;
}

}  // namespace glint::view
