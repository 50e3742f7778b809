#pragma once
#include "frame/image.hpp"

#include <algorithm>
#include <cstring>

#include <tbb/parallel_for.h>

namespace simreel::golden {

/// Part of a picture that is processed as a unit. It is so small that the filter results stay in a core's
/// cache.
struct Tile {
  int index = 0;  ///< index of the tile, counted row by row
  int x = 0, y = 0;
  int width = 0, height = 0;
};

inline constexpr int tileWidth = 256, tileHeight = 64;
[[nodiscard]] constexpr int tilesOver(int width, int height) {
  return ((width + tileWidth - 1) / tileWidth) * ((height + tileHeight - 1) / tileHeight);
}

/// Calls work(tile) for each tile of a picture, in parallel and in any order. Tiles must be independent of
/// each other, so that results do not depend on the thread count.
template <class Work>
void forEachTile(int width, int height, const Work& work) {
  const int across = (width + tileWidth - 1) / tileWidth;
  tbb::parallel_for(0, tilesOver(width, height), [&](int index) {
    const int x = index % across * tileWidth, y = index / across * tileHeight;
    work(Tile{index, x, y, std::min(tileWidth, width - x), std::min(tileHeight, height - y)});
  });
}

/// Calls work(first, last) for bands of 32 rows, in parallel and in any order.
template <class Work>
void forEachBand(int height, const Work& work) {
  constexpr int rows = 32;
  tbb::parallel_for(0, (height + rows - 1) / rows,
                    [&](int band) { work(band * rows, std::min(height, (band + 1) * rows)); });
}

/// True if two pictures of equal size have equal bytes in a tile and `margin` pixels around it.
[[nodiscard]] inline bool equalAround(const frame::Image& a, const frame::Image& b, const Tile& tile,
                                      int margin) {
  const int left = std::max(0, tile.x - margin), right = std::min(a.width, tile.x + tile.width + margin);
  const int top = std::max(0, tile.y - margin), bottom = std::min(a.height, tile.y + tile.height + margin);
  for (int y = top; y < bottom; ++y) {
    const std::size_t at = (std::size_t(y) * std::size_t(a.width) + std::size_t(left)) * 4;
    if (std::memcmp(a.bytes.data() + at, b.bytes.data() + at, std::size_t(right - left) * 4) != 0)
      return false;
  }
  return true;
}

}  // namespace simreel::golden
