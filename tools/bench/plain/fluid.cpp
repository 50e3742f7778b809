#include "plain.hpp"

#include <algorithm>
#include <cmath>

namespace plain {

Fluid::Fluid(int width, int height, const Numbers& numbers)
    : width_(width), height_(height), n_(numbers), jets_(jetsOf(width, height)) {
  const auto cells = static_cast<std::size_t>(width) * height;
  u.resize(static_cast<std::size_t>(width + 1) * height);
  v.resize(static_cast<std::size_t>(width) * (height + 1));
  heat.resize(cells);
  for (auto& channel : dye) channel.resize(cells);
  solid.resize(cells);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float dx = x + 0.5F - 0.37F * width, dy = y + 0.5F - 0.5F * height;
      solid[at(x, y)] = dx * dx + dy * dy < 0.0025F * width * width;
    }
  nextU_ = forthU_ = u;
  nextV_ = forthV_ = v;
  nextHeat_ = forthHeat_ = heat;
  flux_.resize(cells);
  for (int w = width, h = height;; w /= 2, h /= 2) {
    Level& level = levels_.emplace_back();
    level.width = w;
    level.height = h;
    level.value.resize(static_cast<std::size_t>(w) * h);
    level.rhs.resize(level.value.size());
    level.across.resize(static_cast<std::size_t>(w + 1) * h);
    level.down.resize(static_cast<std::size_t>(w) * (h + 1));
    if (levels_.size() == 1) {
      for (int y = 0; y < h; ++y)
        for (int x = 1; x < w; ++x)
          level.across[static_cast<std::size_t>(y) * (w + 1) + x] =
              !solid[at(x, y)] && !solid[at(x - 1, y)];
      for (int y = 1; y < h; ++y)
        for (int x = 0; x < w; ++x)
          level.down[static_cast<std::size_t>(y) * w + x] = !solid[at(x, y)] && !solid[at(x, y - 1)];
    } else {
      const Level& fine = levels_[levels_.size() - 2];
      for (int y = 0; y < h; ++y)
        for (int x = 0; x <= w; ++x)
          for (int k = 0; k < 2; ++k)
            level.across[static_cast<std::size_t>(y) * (w + 1) + x] +=
                0.5F * fine.across[static_cast<std::size_t>(2 * y + k) * (2 * w + 1) + 2 * x];
      for (int y = 0; y <= h; ++y)
        for (int x = 0; x < w; ++x)
          for (int k = 0; k < 2; ++k)
            level.down[static_cast<std::size_t>(y) * w + x] +=
                0.5F * fine.down[static_cast<std::size_t>(2 * y) * 2 * w + 2 * x + k];
    }
    if (w % 2 != 0 || h % 2 != 0 || w <= 8 || h <= 8) break;
  }
}

std::vector<Fluid::Jet> Fluid::jetsOf(int width, int height) {
  const float w = static_cast<float>(width), h = static_cast<float>(height);
  return {{0.06F * w, 0.36F * h, 0.04F * h, 120, 28, {1.6F, 0.22F, 0.04F}},
          {0.94F * w, 0.45F * h, 0.04F * h, -120, 20, {0.03F, 0.35F, 1.6F}},
          {0.5F * w, 0.92F * h, 0.04F * h, 10, -105, {1.1F, 0.8F, 0.1F}}};
}

/// Interpolates bilinearly on a grid of w x h values. Outside, uses the nearest value of the border.
static float sample(const std::vector<float>& f, int w, int h, float x, float y) {
  x = std::clamp(x, 0.0F, static_cast<float>(w - 1));
  y = std::clamp(y, 0.0F, static_cast<float>(h - 1));
  const int i = std::min(static_cast<int>(x), w - 2), j = std::min(static_cast<int>(y), h - 2);
  const float fx = x - i, fy = y - j;
  const float* p = f.data() + static_cast<std::size_t>(j) * w + i;
  const float above = p[0] + fx * (p[1] - p[0]), below = p[w] + fx * (p[w + 1] - p[w]);
  return above + fy * (below - above);
}

void Fluid::velocity(float x, float y, float& a, float& b) const {
  a = sample(u, width_ + 1, height_, x, y - 0.5F);
  b = sample(v, width_, height_ + 1, x - 0.5F, y);
}

void Fluid::trace(float& x, float& y, float dt) const {
  float a, b;
  velocity(x, y, a, b);
  velocity(x + 0.5F * dt * a, y + 0.5F * dt * b, a, b);
  x = std::clamp(x + dt * a, 0.0F, static_cast<float>(width_));
  y = std::clamp(y + dt * b, 0.0F, static_cast<float>(height_));
}

// MacCormack advection: advects forwards and then backwards, subtracts half of the resulting error, and
// clamps the result to the range of the four source values.
void Fluid::carry(const std::vector<float>& from, std::vector<float>& forth, std::vector<float>& to, int w,
                  int h, float ox, float oy) const {
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      float px = x + ox, py = y + oy;
      trace(px, py, -n_.dt);
      forth[static_cast<std::size_t>(y) * w + x] = sample(from, w, h, px - ox, py - oy);
    }
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      float px = x + ox, py = y + oy, qx = px, qy = py;
      trace(px, py, n_.dt);
      trace(qx, qy, -n_.dt);
      const auto i = static_cast<std::size_t>(y) * w + x;
      const float value = forth[i] + 0.5F * (from[i] - sample(forth, w, h, px - ox, py - oy));
      const int a = std::clamp(static_cast<int>(qx - ox), 0, w - 2),
                b = std::clamp(static_cast<int>(qy - oy), 0, h - 2);
      const float* p = from.data() + static_cast<std::size_t>(b) * w + a;
      to[i] =
          std::clamp(value, std::min({p[0], p[1], p[w], p[w + 1]}), std::max({p[0], p[1], p[w], p[w + 1]}));
    }
}

void Fluid::step() {
  carry(u, forthU_, nextU_, width_ + 1, height_, 0, 0.5F);
  carry(v, forthV_, nextV_, width_, height_ + 1, 0.5F, 0);
  carry(heat, forthHeat_, nextHeat_, width_, height_, 0.5F, 0.5F);
  u.swap(nextU_);
  v.swap(nextV_);
  heat.swap(nextHeat_);
  for (int y = 1; y < height_; ++y)
    for (int x = 0; x < width_; ++x)
      v[static_cast<std::size_t>(y) * width_ + x] -=
          n_.dt * n_.lift * 0.5F * (heat[at(x, y)] + heat[at(x, y - 1)]);
  for (float& h : heat) h *= n_.kept;
  paint();
  project();
  for (int i = 0; i < n_.dyePasses; ++i)
    for (auto& channel : dye) moveDye(channel, n_.dt / static_cast<float>(n_.dyePasses));
}

void Fluid::paint() {
  for (const Jet& jet : jets_)
    for (int y = std::max(0, static_cast<int>(jet.y - jet.radius));
         y < std::min(height_, static_cast<int>(jet.y + jet.radius) + 1); ++y)
      for (int x = std::max(0, static_cast<int>(jet.x - jet.radius));
           x < std::min(width_, static_cast<int>(jet.x + jet.radius) + 1); ++x) {
        const float dx = x + 0.5F - jet.x, dy = y + 0.5F - jet.y;
        if (dx * dx + dy * dy > jet.radius * jet.radius) continue;
        u[static_cast<std::size_t>(y) * (width_ + 1) + x] = jet.u;
        v[static_cast<std::size_t>(y) * width_ + x] = jet.v;
        heat[at(x, y)] = 1;
        for (int c = 0; c < 3; ++c) dye[c][at(x, y)] = jet.dye[c];
      }
}

// Relaxes the cells of one colour, 0 or 1, of a red-black checkerboard.
void Fluid::sweep(Level& l, int color) {
  const int w = l.width;
  for (int y = 0; y < l.height; ++y)
    for (int x = (y + color) % 2; x < w; x += 2) {
      const auto i = static_cast<std::size_t>(y) * w + x;
      const float a = l.across[static_cast<std::size_t>(y) * (w + 1) + x];
      const float b = l.across[static_cast<std::size_t>(y) * (w + 1) + x + 1];
      const float c = l.down[i], d = l.down[i + w];
      const float all = a + b + c + d;
      if (all <= 0) continue;
      float sum = l.rhs[i];
      if (a > 0) sum += a * l.value[i - 1];
      if (b > 0) sum += b * l.value[i + 1];
      if (c > 0) sum += c * l.value[i - w];
      if (d > 0) sum += d * l.value[i + w];
      l.value[i] = sum / all;
    }
}

float Fluid::residual(const Level& l, int x, int y) const {
  const int w = l.width;
  const auto i = static_cast<std::size_t>(y) * w + x;
  const float a = l.across[static_cast<std::size_t>(y) * (w + 1) + x];
  const float b = l.across[static_cast<std::size_t>(y) * (w + 1) + x + 1];
  float rest = l.rhs[i];
  if (a > 0) rest -= a * (l.value[i] - l.value[i - 1]);
  if (b > 0) rest -= b * (l.value[i] - l.value[i + 1]);
  if (l.down[i] > 0) rest -= l.down[i] * (l.value[i] - l.value[i - w]);
  if (l.down[i + w] > 0) rest -= l.down[i + w] * (l.value[i] - l.value[i + w]);
  return rest;
}

void Fluid::project() {
  Level& top = levels_.front();
  float fastest = 0;
  for (int y = 0; y < height_; ++y) {
    u[static_cast<std::size_t>(y) * (width_ + 1)] = u[static_cast<std::size_t>(y) * (width_ + 1) + width_] =
        0;
    for (int x = 1; x < width_; ++x)
      u[static_cast<std::size_t>(y) * (width_ + 1) + x] *=
          top.across[static_cast<std::size_t>(y) * (width_ + 1) + x];
  }
  for (int y = 0; y <= height_; ++y)
    for (int x = 0; x < width_; ++x)
      v[static_cast<std::size_t>(y) * width_ + x] *= top.down[static_cast<std::size_t>(y) * width_ + x];
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      const float* a = u.data() + static_cast<std::size_t>(y) * (width_ + 1) + x;
      const float* b = v.data() + static_cast<std::size_t>(y) * width_ + x;
      top.rhs[at(x, y)] = -(a[1] - a[0] + b[width_] - b[0]);
      fastest = std::max({fastest, std::abs(*a), std::abs(*b)});
    }
  std::fill(top.value.begin(), top.value.end(), 0.0F);
  for (cycles = 0; cycles < 24; ++cycles) {
    float worst = 0;
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) worst = std::max(worst, std::abs(residual(top, x, y)));
    if (worst <= 1e-5F * fastest) break;
    for (std::size_t k = 0; k + 1 < levels_.size(); ++k) {
      Level &fine = levels_[k], &coarse = levels_[k + 1];
      sweep(fine, 0);
      sweep(fine, 1);
      for (int y = 0; y < coarse.height; ++y)
        for (int x = 0; x < coarse.width; ++x)
          coarse.rhs[static_cast<std::size_t>(y) * coarse.width + x] =
              residual(fine, 2 * x, 2 * y) + residual(fine, 2 * x + 1, 2 * y) +
              residual(fine, 2 * x, 2 * y + 1) + residual(fine, 2 * x + 1, 2 * y + 1);
      std::fill(coarse.value.begin(), coarse.value.end(), 0.0F);
    }
    for (int i = 0; i < 24; ++i) {
      sweep(levels_.back(), 0);
      sweep(levels_.back(), 1);
    }
    for (std::size_t k = levels_.size() - 1; k-- > 0;) {
      Level &fine = levels_[k], &coarse = levels_[k + 1];
      for (int y = 0; y < fine.height; ++y)
        for (int x = 0; x < fine.width; ++x)
          fine.value[static_cast<std::size_t>(y) * fine.width + x] +=
              sample(coarse.value, coarse.width, coarse.height, 0.5F * x - 0.25F, 0.5F * y - 0.25F);
      sweep(fine, 1);
      sweep(fine, 0);
    }
  }
  for (int y = 0; y < height_; ++y)
    for (int x = 1; x < width_; ++x) {
      const float open = top.across[static_cast<std::size_t>(y) * (width_ + 1) + x];
      u[static_cast<std::size_t>(y) * (width_ + 1) + x] -=
          open * (top.value[at(x, y)] - top.value[at(x - 1, y)]);
    }
  for (int y = 1; y < height_; ++y)
    for (int x = 0; x < width_; ++x)
      v[static_cast<std::size_t>(y) * width_ + x] -= top.down[static_cast<std::size_t>(y) * width_ + x] *
                                                     (top.value[at(x, y)] - top.value[at(x, y - 1)]);
}

// Moves dye by fluxes with van Leer's slopes.
void Fluid::moveDye(std::vector<float>& d, float dt) {
  const auto slope = [](float a, float b) {
    if (a * b <= 0) return 0.0F;
    const float minimum = std::min({2 * std::abs(a), 2 * std::abs(b), 0.5F * std::abs(a + b)});
    return a < 0 ? -minimum : minimum;
  };
  const auto through = [&](float way, const float* p, int pace, int place, int count) {
    const float b = p[-pace], c = p[0];
    const float a = place > 1 ? p[-2 * pace] : b, e = place < count - 1 ? p[pace] : c;
    return way > 0 ? way * (b + 0.5F * (1 - way) * slope(b - a, c - b))
                   : way * (c - 0.5F * (1 + way) * slope(c - b, e - c));
  };
  flux_ = d;
  for (int y = 0; y < height_; ++y)
    for (int x = 1; x < width_; ++x) {
      const float f = through(dt * u[static_cast<std::size_t>(y) * (width_ + 1) + x], d.data() + at(x, y),
                              1, x, width_);
      flux_[at(x, y)] += f;
      flux_[at(x - 1, y)] -= f;
    }
  for (int y = 1; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      const float f = through(dt * v[static_cast<std::size_t>(y) * width_ + x], d.data() + at(x, y), width_,
                              y, height_);
      flux_[at(x, y)] += f;
      flux_[at(x, y - 1)] -= f;
    }
  d.swap(flux_);
}

}  // namespace plain
