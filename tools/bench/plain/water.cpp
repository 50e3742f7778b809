#include "plain.hpp"

#include <algorithm>
#include <cmath>

namespace plain {

Water::Water(int width, int height, const Numbers& numbers) : width_(width), height_(height), n_(numbers) {
  const auto cells = static_cast<std::size_t>(width) * height;
  level.resize(cells);
  alongX.resize(cells);
  alongY.resize(cells);
  bed.resize(cells);
}

namespace {

float limited(float a, float b) {
  if (a * b <= 0) return 0;
  const float minimum = std::min({2 * std::abs(a), 2 * std::abs(b), 0.5F * std::abs(a + b)});
  return a < 0 ? -minimum : minimum;
}

}  // namespace

/// Returns a cell. Beyond the border, returns the cell's mirror image.
Water::Cell Water::cell(int x, int y) const {
  const int i = x < 0 ? -1 - x : x >= width_ ? 2 * width_ - 1 - x : x;
  const int j = y < 0 ? -1 - y : y >= height_ ? 2 * height_ - 1 - y : y;
  const auto k = static_cast<std::size_t>(j) * width_ + i;
  const float depth = std::max(level[k] - bed[k], 0.0F);
  const float per = 2 * depth / (depth * depth + std::max(depth * depth, n_.thin * n_.thin));
  Cell c{level[k], depth, alongX[k] * per, alongY[k] * per};
  if (i != x) c.u = -c.u;
  if (j != y) c.v = -c.v;
  return c;
}

// The step computes slopes, half a step in each cell, and then HLL fluxes between reconstructed depths, as
// in simreel's equations.
void Water::step() {
  const float k = 0.5F * n_.ratio;
  const int w = width_ + 2;
  slopesX_.resize(static_cast<std::size_t>(w) * (height_ + 2));
  slopesY_.resize(slopesX_.size());
  halves_.resize(slopesX_.size());
  for (int y = -1; y <= height_; ++y)
    for (int x = -1; x <= width_; ++x) {
      const Cell c = cell(x, y), e = cell(x + 1, y), a = cell(x - 1, y), n = cell(x, y - 1),
                 s = cell(x, y + 1);
      const auto i = static_cast<std::size_t>(y + 1) * w + x + 1;
      const auto slope = [&](const Cell& before, const Cell& after) {
        if (before.depth < n_.dry || c.depth < n_.dry || after.depth < n_.dry) return Cell{0, 0, 0, 0};
        return Cell{limited(c.level - before.level, after.level - c.level),
                    limited(c.depth - before.depth, after.depth - c.depth),
                    limited(c.u - before.u, after.u - c.u), limited(c.v - before.v, after.v - c.v)};
      };
      const Cell sx = slope(a, e), sy = slope(n, s);
      slopesX_[i] = sx;
      slopesY_[i] = sy;
      const float change = k * (c.u * sx.depth + c.depth * sx.u + c.v * sy.depth + c.depth * sy.v);
      halves_[i] = {c.level - change, std::max(c.depth - change, 0.0F),
                    c.u - k * (c.u * sx.u + c.v * sy.u + n_.gravity * sx.level),
                    c.v - k * (c.u * sx.v + c.v * sy.v + n_.gravity * sy.level)};
    }
  nextLevel_ = level;
  nextX_ = alongX;
  nextY_ = alongY;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x <= width_; ++x) {
      const auto i = static_cast<std::size_t>(y + 1) * w + x + 1;
      flow(i - 1, i, true, x > 0 ? at(x - 1, y) : none, x < width_ ? at(x, y) : none);
    }
  for (int y = 0; y <= height_; ++y)
    for (int x = 0; x < width_; ++x) {
      const auto i = static_cast<std::size_t>(y + 1) * w + x + 1;
      flow(i - w, i, false, y > 0 ? at(x, y - 1) : none, y < height_ ? at(x, y) : none);
    }
  for (std::size_t i = 0; i < level.size(); ++i) {
    const int x = static_cast<int>(i % width_), y = static_cast<int>(i / width_);
    const auto j = static_cast<std::size_t>(y + 1) * w + x + 1;
    nextX_[i] -= n_.ratio * n_.gravity * halves_[j].depth * slopesX_[j].level;
    nextY_[i] -= n_.ratio * n_.gravity * halves_[j].depth * slopesY_[j].level;
    if (nextLevel_[i] - bed[i] < n_.dry) nextX_[i] = nextY_[i] = 0;
    nextLevel_[i] = std::max(nextLevel_[i], bed[i]);
    nextX_[i] *= n_.kept;
    nextY_[i] *= n_.kept;
  }
  level.swap(nextLevel_);
  alongX.swap(nextX_);
  alongY.swap(nextY_);
}

void Water::flow(std::size_t before, std::size_t behind, bool across, std::size_t a, std::size_t b) {
  const Cell &h0 = halves_[before], &h1 = halves_[behind];
  const Cell &s0 = across ? slopesX_[before] : slopesY_[before],
             &s1 = across ? slopesX_[behind] : slopesY_[behind];
  const float w0 = h0.level + 0.5F * s0.level, w1 = h1.level - 0.5F * s1.level;
  const float d0 = std::max(h0.depth + 0.5F * s0.depth, 0.0F),
              d1 = std::max(h1.depth - 0.5F * s1.depth, 0.0F);
  const float ground = std::max(w0 - d0, w1 - d1);
  const float l = std::max(w0 - ground, 0.0F), r = std::max(w1 - ground, 0.0F);
  if (l <= n_.dry && r <= n_.dry) return;
  const float ul = across ? h0.u + 0.5F * s0.u : h0.v + 0.5F * s0.v,
              ur = across ? h1.u - 0.5F * s1.u : h1.v - 0.5F * s1.v;
  const float vl = across ? h0.v + 0.5F * s0.v : h0.u + 0.5F * s0.u,
              vr = across ? h1.v - 0.5F * s1.v : h1.u - 0.5F * s1.u;
  const float g = n_.gravity;
  const float cl = std::sqrt(g * l), cr = std::sqrt(g * r);
  const float mean = 0.5F * (ul + ur) + cl - cr, wave = 0.5F * (cl + cr) + 0.25F * (ul - ur);
  const float sl = std::min({ul - cl, mean - wave, l > n_.dry ? ul - cl : ur - 2 * cr, 0.0F});
  const float sr = std::max({ur + cr, mean + wave, r > n_.dry ? ur + cr : ul + 2 * cl, 0.0F});
  const float per = 1 / std::max(sr - sl, 1e-12F);
  const float ml = l * ul, mr = r * ur, pl = 0.5F * g * l * l, pr = 0.5F * g * r * r;
  const float mass = (sr * ml - sl * mr + sl * sr * (r - l)) * per;
  const float push = (sr * (ml * ul + pl) - sl * (mr * ur + pr) + sl * sr * (mr - ml)) * per;
  const float along = mass > 0 ? mass * vl : mass * vr;
  const float t = n_.ratio;
  if (a != none) {
    nextLevel_[a] -= t * mass;
    (across ? nextX_ : nextY_)[a] -= t * (push - pl);
    (across ? nextY_ : nextX_)[a] -= t * along;
  }
  if (b != none) {
    nextLevel_[b] += t * mass;
    (across ? nextX_ : nextY_)[b] += t * (push - pr);
    (across ? nextY_ : nextX_)[b] += t * along;
  }
}

}  // namespace plain
