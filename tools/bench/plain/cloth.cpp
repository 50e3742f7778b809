#include "plain.hpp"

#include <cmath>

namespace plain {

namespace {

struct Spring {
  int dx, dy;
  float length;  ///< rest length in units of the grid spacing
  int kind;      ///< kind of spring: 0 structural, 1 shear, 2 bend
};
const float diagonal = std::sqrt(2.0F);
const Spring springs[12] = {{-1, 0, 1, 0},        {1, 0, 1, 0},          {0, -1, 1, 0},
                            {0, 1, 1, 0},         {-1, -1, diagonal, 1}, {1, -1, diagonal, 1},
                            {-1, 1, diagonal, 1}, {1, 1, diagonal, 1},   {-2, 0, 2, 2},
                            {2, 0, 2, 2},         {0, -2, 2, 2},         {0, 2, 2, 2}};

}  // namespace

Cloth::Cloth(int width, int height, const Numbers& numbers)
    : position(std::size_t(width) * height),
      velocity(position.size()),
      width_(width),
      height_(height),
      n_(numbers),
      before_(position.size()) {
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      position[std::size_t(y) * width + x] = {x * n_.spacing, -y * n_.spacing, 0};
}

void Cloth::springStep() {
  const float stiffness[3] = {n_.stiffness, n_.stiffness * n_.shear, n_.stiffness * n_.bend};
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      const std::size_t i = std::size_t(y) * width_ + x;
      const Vec3 p = position[i];
      Vec3 force{0, 0, 0};
      for (const Spring& s : springs) {
        const int nx = x + s.dx, ny = y + s.dy;
        if (nx < 0 || ny < 0 || nx >= width_ || ny >= height_) continue;
        const Vec3 q = position[std::size_t(ny) * width_ + nx];
        const float dx = q.x - p.x, dy = q.y - p.y, dz = q.z - p.z;
        const float length = std::sqrt(dx * dx + dy * dy + dz * dz);
        if (length < 1e-4F) continue;
        const float f = stiffness[s.kind] * (1 - s.length * n_.spacing / length);
        force.x += f * dx;
        force.y += f * dy;
        force.z += f * dz;
      }
      Vec3& v = velocity[i];
      v.x = (v.x + force.x * n_.inverseMass * n_.dt) * n_.kept;
      v.y = (v.y + (force.y * n_.inverseMass - n_.gravity) * n_.dt) * n_.kept;
      v.z = (v.z + force.z * n_.inverseMass * n_.dt) * n_.kept;
      before_[i] = y == 0 ? p : Vec3{p.x + v.x * n_.dt, p.y + v.y * n_.dt, p.z + v.z * n_.dt};
    }
  position.swap(before_);
}

void Cloth::solve(int dx, int dy, float rest, float compliance) {
  const float alpha = compliance / (n_.dt * n_.dt);
  for (int y = 0; y + dy < height_; ++y)
    for (int x = dx < 0 ? -dx : 0; x < width_ && x + dx < width_; ++x) {
      const float wa = y == 0 ? 0 : n_.inverseMass, wb = y + dy == 0 ? 0 : n_.inverseMass;
      if (wa + wb == 0) continue;
      Vec3& a = position[std::size_t(y) * width_ + x];
      Vec3& b = position[std::size_t(y + dy) * width_ + x + dx];
      const float ex = b.x - a.x, ey = b.y - a.y, ez = b.z - a.z;
      const float length = std::sqrt(ex * ex + ey * ey + ez * ez);
      const float lambda = (length - rest) / ((wa + wb + alpha) * length);
      a.x += wa * lambda * ex;
      a.y += wa * lambda * ey;
      a.z += wa * lambda * ez;
      b.x -= wb * lambda * ex;
      b.y -= wb * lambda * ey;
      b.z -= wb * lambda * ez;
    }
}

void Cloth::constraintStep() {
  before_ = position;
  for (std::size_t i = width_; i < position.size(); ++i) {
    velocity[i].y -= n_.gravity * n_.dt;
    position[i].x += velocity[i].x * n_.dt;
    position[i].y += velocity[i].y * n_.dt;
    position[i].z += velocity[i].z * n_.dt;
  }
  const float s = n_.spacing;
  solve(1, 0, s, n_.compliance);
  solve(0, 1, s, n_.compliance);
  solve(1, 1, s * diagonal, n_.shearCompliance);
  solve(-1, 1, s * diagonal, n_.shearCompliance);
  solve(2, 0, 2 * s, n_.bendCompliance);
  solve(0, 2, 2 * s, n_.bendCompliance);
  for (std::size_t i = width_; i < position.size(); ++i) {
    velocity[i].x = (position[i].x - before_[i].x) / n_.dt * n_.kept;
    velocity[i].y = (position[i].y - before_[i].y) / n_.dt * n_.kept;
    velocity[i].z = (position[i].z - before_[i].z) / n_.dt * n_.kept;
  }
}

}  // namespace plain
