#include "plain.hpp"

#include <utility>

namespace plain {

namespace {

/// Computes the Laplacian along row `e`. Rows a to c belong to the previous layer, rows g to i to the next
/// layer. `left` and `right` are the indices of the neighbours of the first and the last cell across the
/// border. Without `__restrict`, compilers do not vectorise the loop.
void laplacian(const float* __restrict a, const float* __restrict b, const float* __restrict c,
               const float* __restrict d, const float* __restrict e, const float* __restrict f,
               const float* __restrict g, const float* __restrict h, const float* __restrict i,
               float* __restrict lap, int side) {
  const auto at = [&](int left, int x, int right) {
    const float faces = e[left] + e[right] + d[x] + f[x] + b[x] + h[x];
    const float edges = d[left] + d[right] + f[left] + f[right] + b[left] + b[right] + h[left] + h[right] +
                        a[x] + c[x] + g[x] + i[x];
    return (2 * faces + edges - 24 * e[x]) * (1.0F / 6);
  };
  for (int x = 1; x < side - 1; ++x) lap[x] = at(x - 1, x, x + 1);
  lap[0] = at(side - 1, 0, 1);
  lap[side - 1] = at(side - 2, side - 1, 0);
}

struct Rates {
  float diffuseU, diffuseV, feed, kill, dt;
};

void react(const float* __restrict u, const float* __restrict v, const float* __restrict lapU,
           const float* __restrict lapV, float* __restrict nextU, float* __restrict nextV, int side,
           const Rates& rates) {
  const Rates r = rates;
  for (int x = 0; x < side; ++x) {
    const float reacted = u[x] * v[x] * v[x];
    nextU[x] = u[x] + r.dt * (r.diffuseU * lapU[x] - reacted + r.feed * (1 - u[x]));
    nextV[x] = v[x] + r.dt * (r.diffuseV * lapV[x] + reacted - (r.feed + r.kill) * v[x]);
  }
}

}  // namespace

GrayScottVolume::GrayScottVolume(int side)
    : u(std::size_t(side) * side * side, 1.0F),
      v(u.size(), 0.0F),
      side_(side),
      nextU_(u.size()),
      nextV_(u.size()) {}

void GrayScottVolume::step(float diffuseU, float diffuseV, float feed, float kill, float dt) {
  const Rates rates{diffuseU, diffuseV, feed, kill, dt};
  const int n = side_;
  std::vector<float> lapU(static_cast<std::size_t>(n)), lapV(lapU);
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y) {
      const auto lap = [&](const std::vector<float>& field, std::vector<float>& to) {
        const auto row = [&](int dy, int dz) {
          return &field[(std::size_t((z + dz + n) % n) * n + std::size_t((y + dy + n) % n)) * n];
        };
        laplacian(row(-1, -1), row(0, -1), row(1, -1), row(-1, 0), row(0, 0), row(1, 0), row(-1, 1),
                  row(0, 1), row(1, 1), to.data(), n);
      };
      lap(u, lapU);
      lap(v, lapV);
      const std::size_t here = (std::size_t(z) * n + y) * n;
      react(&u[here], &v[here], lapU.data(), lapV.data(), &nextU_[here], &nextV_[here], n, rates);
    }
  std::swap(u, nextU_);
  std::swap(v, nextV_);
}

}  // namespace plain
