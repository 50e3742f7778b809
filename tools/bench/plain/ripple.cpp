#include "plain.hpp"

#include <cmath>

namespace plain {

Ripple::Ripple(int width, int height, float size)
    : position(std::size_t(width) * height),
      normal(position.size()),
      width_(width),
      height_(height),
      rest_(position.size()) {
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      rest_[std::size_t(y) * width + x] = {size * (float(x) / float(width - 1) - 0.5F), 0,
                                           size * (float(y) / float(height - 1) - 0.5F)};
  for (int y = 0; y + 1 < height; ++y)
    for (int x = 0; x + 1 < width; ++x) {
      const auto a = std::uint32_t(y * width + x), b = a + std::uint32_t(width);
      indices_.insert(indices_.end(), {a, b, a + 1, a + 1, b, b + 1});
    }
}

void Ripple::step(float phase, float amplitude, float wavenumber, float decay) {
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    const Vec3 p = rest_[i];
    const float r = std::sqrt(p.x * p.x + p.z * p.z);
    position[i] = {p.x, p.y + std::sin(phase - wavenumber * r) * amplitude * std::exp(-decay * r), p.z};
    normal[i] = {0, 0, 0};
  }
  for (std::size_t t = 0; t < indices_.size(); t += 3) {
    const Vec3 a = position[indices_[t]], b = position[indices_[t + 1]], c = position[indices_[t + 2]];
    const float ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = c.x - a.x, vy = c.y - a.y,
                vz = c.z - a.z;
    const Vec3 n{uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
    for (int k = 0; k < 3; ++k) {
      Vec3& sum = normal[indices_[t + std::size_t(k)]];
      sum.x += n.x;
      sum.y += n.y;
      sum.z += n.z;
    }
  }
  for (Vec3& n : normal) {
    const float length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    n = {n.x / length, n.y / length, n.z / length};
  }
}

}  // namespace plain
