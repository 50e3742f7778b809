#include "plain.hpp"

#include <utility>

namespace plain {

namespace {

float held(float x) {
  return x < 0 ? 0 : x > 1 ? 1 : x;
}

struct Rates {
  float diffuseU, diffuseV, feed, kill, dt;
};

/// Updates all cells of a row except the first and the last, from three rows of u and of v. Without
/// `__restrict`, compilers do not vectorise the loop.
void inner(const float* __restrict ua, const float* __restrict u, const float* __restrict ub,
           const float* __restrict va, const float* __restrict v, const float* __restrict vb,
           float* __restrict nextU, float* __restrict nextV, int width, const Rates& rates) {
  const Rates r = rates;
  for (int x = 1; x < width - 1; ++x) {
    const float lapU = 0.2F * (u[x - 1] + u[x + 1] + ua[x] + ub[x]) +
                       0.05F * (ua[x - 1] + ua[x + 1] + ub[x - 1] + ub[x + 1]) - u[x];
    const float lapV = 0.2F * (v[x - 1] + v[x + 1] + va[x] + vb[x]) +
                       0.05F * (va[x - 1] + va[x + 1] + vb[x - 1] + vb[x + 1]) - v[x];
    const float reacted = u[x] * v[x] * v[x];
    nextU[x] = held(u[x] + r.dt * (r.diffuseU * lapU - reacted + r.feed * (1 - u[x])));
    nextV[x] = held(v[x] + r.dt * (r.diffuseV * lapV + reacted - (r.feed + r.kill) * v[x]));
  }
}

}  // namespace

GrayScott::GrayScott(int width, int height)
    : u(std::size_t(width) * height, 1.0F),
      v(u.size(), 0.0F),
      width_(width),
      height_(height),
      nextU_(u.size()),
      nextV_(u.size()) {}

void GrayScott::step(float diffuseU, float diffuseV, float feed, float kill, float dt) {
  const Rates rates{diffuseU, diffuseV, feed, kill, dt};
  // Updates the two border cells. The x coordinates of their neighbours wrap around.
  const auto border = [&](std::size_t above, std::size_t here, std::size_t below, int x) {
    const int l = (x + width_ - 1) % width_, r = (x + 1) % width_;
    const auto lap = [&](const std::vector<float>& f) {
      return 0.2F * (f[here + l] + f[here + r] + f[above + x] + f[below + x]) +
             0.05F * (f[above + l] + f[above + r] + f[below + l] + f[below + r]) - f[here + x];
    };
    const float a = u[here + x], b = v[here + x], reacted = a * b * b;
    nextU_[here + x] = held(a + dt * (diffuseU * lap(u) - reacted + feed * (1 - a)));
    nextV_[here + x] = held(b + dt * (diffuseV * lap(v) + reacted - (feed + kill) * b));
  };
  for (int y = 0; y < height_; ++y) {
    const std::size_t above = std::size_t((y + height_ - 1) % height_) * width_;
    const std::size_t here = std::size_t(y) * width_;
    const std::size_t below = std::size_t((y + 1) % height_) * width_;
    inner(&u[above], &u[here], &u[below], &v[above], &v[here], &v[below], &nextU_[here], &nextV_[here],
          width_, rates);
    border(above, here, below, 0);
    border(above, here, below, width_ - 1);
  }
  std::swap(u, nextU_);
  std::swap(v, nextV_);
}

}  // namespace plain
