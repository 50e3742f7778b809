#include "plain.hpp"

#include <cmath>

namespace plain {

namespace {

float dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec3 minus(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
void add(Vec3& to, const Vec3& what, float times) {
  to.x += what.x * times;
  to.y += what.y * times;
  to.z += what.z * times;
}

}  // namespace

Fabric::Fabric(int width, int height, const Numbers& numbers)
    : position(std::size_t(width) * height),
      velocity(position.size()),
      next(position.size()),
      inverseMass(position.size()),
      width_(width),
      height_(height),
      n_(numbers),
      force_(position.size()) {
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float share =
          (x == 0 || x == width - 1 ? 0.5F : 1.0F) * (y == 0 || y == height - 1 ? 0.5F : 1.0F);
      position[at(x, y)] = {x * n_.spacing, -y * n_.spacing, 0};
      inverseMass[at(x, y)] = 1 / (n_.density * n_.spacing * n_.spacing * share);
    }
}

/// Adds the bending forces of a plate. They are computed from the second differences of the positions.
void Fabric::bend() {
  force_.assign(position.size(), Vec3{0, 0, 0});
  const float k = n_.bending / (n_.spacing * n_.spacing);
  const auto three = [&](std::size_t a, std::size_t b, std::size_t c, float strength) {
    Vec3 d = minus(position[a], position[b]);
    add(d, minus(position[c], position[b]), 1);
    add(force_[a], d, -strength);
    add(force_[b], d, 2 * strength);
    add(force_[c], d, -strength);
  };
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      const std::size_t i = at(x, y), w = std::size_t(width_);
      const bool row = x > 0 && x + 1 < width_, column = y > 0 && y + 1 < height_;
      if (row) three(i - 1, i, i + 1, column ? k : 0.5F * k);
      if (column) three(i - w, i, i + w, row ? k : 0.5F * k);
      if (x + 1 == width_ || y + 1 == height_) continue;
      Vec3 d = minus(position[i], position[i + 1]);
      add(d, minus(position[i + w + 1], position[i + w]), 1);
      add(force_[i], d, -2 * k);
      add(force_[i + 1], d, 2 * k);
      add(force_[i + w], d, 2 * k);
      add(force_[i + w + 1], d, -2 * k);
    }
}

void Fabric::predict() {
  bend();
  for (std::size_t i = 0; i < position.size(); ++i) {
    next[i] = position[i];
    if (inverseMass[i] == 0) continue;
    Vec3& v = velocity[i];
    v.y -= n_.gravity * n_.dt;
    add(v, force_[i], inverseMass[i] * n_.dt);
    v = {v.x * n_.kept, v.y * n_.kept, v.z * n_.kept};
    add(next[i], v, n_.dt);
  }
  const float rest = n_.spacing * std::sqrt(2.0F), give = 1 / (n_.shear * n_.dt * n_.dt);
  for (int y = 0; y + 1 < height_; ++y)
    for (int x = 0; x + 1 < width_; ++x) {
      pull(at(x, y), at(x + 1, y + 1), rest, give);
      pull(at(x + 1, y), at(x, y + 1), rest, give);
    }
  for (int y = 0; y < height_; ++y)
    line(at(0, y), 1, width_, n_.weft * (y == 0 || y == height_ - 1 ? 0.5F : 1));
  for (int x = 0; x < width_; ++x)
    line(at(x, 0), std::size_t(width_), height_, n_.warp * (x == 0 || x == width_ - 1 ? 0.5F : 1));
}

void Fabric::pull(std::size_t a, std::size_t b, float rest, float give) {
  const Vec3 d = minus(next[b], next[a]);
  const float length = std::sqrt(dot(d, d));
  const float lambda = (length - rest) / ((inverseMass[a] + inverseMass[b] + give) * length);
  add(next[a], d, lambda * inverseMass[a]);
  add(next[b], d, -lambda * inverseMass[b]);
}

/// Solves all links of a line together. Their matrix is tridiagonal.
void Fabric::line(std::size_t first, std::size_t pace, int count, float stiffness) {
  const float give = 1 / (stiffness * n_.dt * n_.dt);
  along_.resize(std::size_t(count));
  upper_.resize(std::size_t(count));
  lambda_.resize(std::size_t(count));
  float inverse = 0;  // inverse of the previous pivot
  for (int k = 0; k + 1 < count; ++k) {
    const std::size_t a = first + k * pace;
    const float wa = inverseMass[a], wb = inverseMass[a + pace];
    const Vec3 d = minus(next[a + pace], next[a]);
    const float length = std::sqrt(dot(d, d));
    along_[k] = {d.x / length, d.y / length, d.z / length};
    const float lower = k > 0 ? -wa * dot(along_[k - 1], along_[k]) : 0;
    const float above = lower * inverse;
    if (k > 0) upper_[k - 1] = above;
    inverse = 1 / ((wa + wb) * 1.00003F + give - lower * above);
    lambda_[k] = (n_.spacing - length - (k > 0 ? lower * lambda_[k - 1] : 0)) * inverse;
  }
  for (int k = count - 3; k >= 0; --k) lambda_[k] -= upper_[k] * lambda_[k + 1];
  for (int k = 0; k + 1 < count; ++k) {
    const std::size_t a = first + k * pace;
    add(next[a], along_[k], -lambda_[k] * inverseMass[a]);
    add(next[a + pace], along_[k], lambda_[k] * inverseMass[a + pace]);
  }
}

void Fabric::settle() {
  const float perDt = 1 / n_.dt;
  for (std::size_t i = 0; i < position.size(); ++i) {
    const Vec3 d = minus(next[i], position[i]);
    velocity[i] = {d.x * perDt, d.y * perDt, d.z * perDt};
  }
  position.swap(next);
}

}  // namespace plain
