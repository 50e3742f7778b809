#include "plain.hpp"

#include <cmath>

namespace plain {

Walls::Walls(int width, int height) : rock(std::size_t(width) * height), width_(width), height_(height) {
  across_.resize(rock.size());
  down_.resize(rock.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      corners_.push_back({float(x), 0, float(y)});
      position.push_back(corners_.back());
      normal.push_back({0, 1, 0});
    }
}

/// Adds the four vertices (floor, foot, top, rim) of a wall that crosses an edge of the grid. Returns the
/// index of the first vertex.
int Walls::crossing(int x, int y, bool along) {
  const auto at = [&](int cx, int cy) {
    cx = cx < 0 ? 0 : cx >= width_ ? width_ - 1 : cx;
    cy = cy < 0 ? 0 : cy >= height_ ? height_ - 1 : cy;
    return float(rock[std::size_t(cy) * width_ + cx]);
  };
  const int ex = along ? 1 : 0, ey = 1 - ex;
  const float rise = 2 * (at(x + ex, y + ey) - at(x, y)) + at(x + ex - ey, y + ey - ex) -
                     at(x - ey, y - ex) + at(x + ex + ey, y + ey + ex) - at(x + ey, y + ex);
  const float turn =
      at(x + ey, y + ex) - at(x - ey, y - ex) + at(x + ex + ey, y + ey + ex) - at(x + ex - ey, y + ey - ex);
  const float scale = -1 / std::sqrt(rise * rise + turn * turn);
  const float nx = (along ? rise : turn) * scale, nz = (along ? turn : rise) * scale;
  const float px = float(x) + 0.5F * float(ex), pz = float(y) + 0.5F * float(ey);
  const int first = int(position.size());
  const float heights[] = {0, 0, 1, 1};
  for (int i = 0; i < 4; ++i) {
    position.push_back({px, heights[i], pz});
    normal.push_back(i == 0 || i == 3 ? Vec3{0, 1, 0} : Vec3{nx, 0, nz});
  }
  return first;
}

void Walls::square(int x, int y) {
  const std::size_t i = std::size_t(y) * width_ + x;
  const std::size_t corner[] = {i, i + 1, i + 1 + width_, i + width_};
  const int edge[] = {across_[i], down_[i + 1], across_[i + width_], down_[i]};
  const bool high[] = {rock[corner[0]] != 0, rock[corner[1]] != 0, rock[corner[2]] != 0,
                       rock[corner[3]] != 0};
  for (int in = 0; in < 4; ++in) {
    if (!high[in] || high[(in + 1) % 4]) continue;
    int out = (in + 1) % 4;
    while (high[out] || !high[(out + 1) % 4]) out = (out + 1) % 4;
    const std::uint32_t r = std::uint32_t(edge[in]), l = std::uint32_t(edge[out]);
    indices.insert(indices.end(), {l + 1, r + 1, r + 2, l + 1, r + 2, l + 2});
  }
  const bool saddle = high[0] == high[2] && high[1] == high[3];
  for (const bool wanted : {false, true}) {
    std::uint32_t face[8];
    int count = 0;
    const auto flush = [&] {
      for (int k = 2; k < count; ++k) indices.insert(indices.end(), {face[0], face[k], face[k - 1]});
      count = 0;
    };
    const bool split = saddle && !wanted;
    const int start = split && !high[0] ? 1 : 0;
    for (int step = start; step < start + 4; ++step) {
      const int a = step % 4, b = (step + 1) % 4;
      if (high[a] == wanted) face[count++] = std::uint32_t(corner[a]);
      if (high[a] == high[b]) continue;
      if (split && high[a]) flush();
      face[count++] = std::uint32_t(edge[a]) + (wanted ? 3U : 0U);
    }
    flush();
  }
}

void Walls::make() {
  position.resize(corners_.size());
  normal.resize(corners_.size());
  indices.clear();
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      const std::size_t i = std::size_t(y) * width_ + x;
      position[i].y = float(rock[i]);
      if (x + 1 < width_ && rock[i] != rock[i + 1]) across_[i] = crossing(x, y, true);
      if (y + 1 < height_ && rock[i] != rock[i + width_]) down_[i] = crossing(x, y, false);
    }
  for (int y = 0; y + 1 < height_; ++y)
    for (int x = 0; x + 1 < width_; ++x) {
      const std::size_t i = std::size_t(y) * width_ + x;
      const std::uint8_t a = rock[i];
      if (rock[i + 1] == a && rock[i + width_] == a && rock[i + width_ + 1] == a) {
        const auto me = std::uint32_t(i), row = std::uint32_t(width_);
        indices.insert(indices.end(), {me, me + row, me + 1, me + 1, me + row, me + row + 1});
      } else {
        square(x, y);
      }
    }
}

}  // namespace plain
