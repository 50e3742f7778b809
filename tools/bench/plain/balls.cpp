#include "balls.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace plain {

namespace {

Vec3 operator-(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vec3 operator*(const Vec3& a, float s) {
  return {a.x * s, a.y * s, a.z * s};
}
float dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
float length(const Vec3& a) {
  return std::sqrt(dot(a, a));
}

/// Returns the fraction of the sliding vector that friction of at most `maximum` leaves.
float leftByFriction(const Vec3& slide, float maximum) {
  return std::max(0.0F, 1 - maximum / std::max(length(slide), 1e-12F));
}

}  // namespace

void BallHeap::step(float dt) {
  for (std::size_t i = 0; i < positions.size(); ++i) {
    velocities[i].y -= numbers_.weight * dt;
    starts_[i] = positions[i];
    positions[i] = positions[i] + velocities[i] * dt;
    outOfBox(positions[i], &velocities[i], starts_[i]);
  }
  search();
  for (int i = 0; i < numbers_.impacts; ++i) strike(dt);
  struck_ = positions;
  for (int i = 0; i < numbers_.iterations; ++i) correct();
  leave(dt);
}

void BallHeap::outOfBox(Vec3& p, Vec3* velocity, const Vec3& from) const {
  const Vec3 normals[5] = {{0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}};
  for (int k = 0; k < 5; ++k) {
    const Vec3& normal = normals[k];
    const float depth = numbers_.radius - (k == 0 ? 0 : numbers_.half) - dot(normal, p);
    if (depth <= 0) continue;
    if (velocity != nullptr) {
      const float inward = dot(*velocity, normal);
      const float outward = std::max(inward, -numbers_.bounce * inward);
      const Vec3 sliding = *velocity - normal * inward;
      *velocity =
          sliding * leftByFriction(sliding, numbers_.friction * (outward - inward)) + normal * outward;
    }
    const Vec3 way = p - from;
    const Vec3 slid = way - normal * dot(way, normal);
    p = p + normal * depth - slid * (1 - leftByFriction(slid, numbers_.friction * depth));
  }
}

/// Sorts the balls by cells (counting sort) and lists the neighbours of each.
void BallHeap::search() {
  const float perCell = 1 / (2.11F * numbers_.radius);
  const auto side = static_cast<int>(2 * numbers_.half * perCell) + 3;
  float top = 0;
  for (const Vec3& p : positions) top = std::max(top, p.y);
  const int layers = static_cast<int>(top * perCell) + 3;
  const auto cellOf = [&](const Vec3& p) {
    const int x = static_cast<int>((p.x + numbers_.half) * perCell) + 1;
    const int z = static_cast<int>((p.z + numbers_.half) * perCell) + 1;
    const int y = static_cast<int>(std::max(p.y, 0.0F) * perCell) + 1;
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(z)) *
               static_cast<std::size_t>(side) +
           static_cast<std::size_t>(x);
  };
  const std::size_t cells = static_cast<std::size_t>(side) * static_cast<std::size_t>(side) *
                            static_cast<std::size_t>(layers + 1);
  firsts_.assign(cells + 1, 0);
  for (const Vec3& p : positions) ++firsts_[cellOf(p) + 1];
  for (std::size_t c = 1; c <= cells; ++c) firsts_[c] += firsts_[c - 1];
  std::vector<int> next(firsts_.begin(), firsts_.end() - 1);
  scratch_[0] = positions;
  scratch_[1] = velocities;
  scratch_[2] = starts_;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto to = static_cast<std::size_t>(next[cellOf(scratch_[0][i])]++);
    positions[to] = scratch_[0][i];
    velocities[to] = scratch_[1][i];
    starts_[to] = scratch_[2][i];
  }
  const float wide = 2.1F * numbers_.radius, touch = 2.02F * numbers_.radius;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    int found = 0, touching = 0;
    const std::size_t middle = cellOf(positions[i]);
    for (int dy = -1; dy <= 1; ++dy)
      for (int dz = -1; dz <= 1; ++dz) {
        const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(middle) + (dy * side + dz) * side;
        const auto from = static_cast<std::size_t>(std::max<std::ptrdiff_t>(row - 1, 0));
        const std::size_t end = std::min(static_cast<std::size_t>(row + 2), cells);
        for (auto j = static_cast<std::size_t>(firsts_[from]); j < static_cast<std::size_t>(firsts_[end]);
             ++j) {
          const Vec3 apart = positions[i] - positions[j];
          const float squared = dot(apart, apart);
          if (j == i || squared >= wide * wide || found == listed) continue;
          lists_[i * listed + static_cast<std::size_t>(found++)] = static_cast<int>(j);
          touching += squared < touch * touch ? 1 : 0;
        }
      }
    counts_[i] = found;
    shares_[i] = 1 + 0.3F * static_cast<float>(std::max(touching, 1) - 1);
  }
}

BallHeap::Impact BallHeap::impactOf(std::size_t a, std::size_t b, float dt) const {
  const Vec3 relative = velocities[a] - velocities[b];
  const Vec3 apart = positions[a] - positions[b] - relative * dt;
  const float along = dot(apart, relative);
  if (along >= 0) return {};
  const float squared = dot(relative, relative);
  const float beyond = dot(apart, apart) - 4 * numbers_.radius * numbers_.radius;
  const float discriminant = along * along - squared * beyond;
  if (discriminant < 0) return {};
  const float time = std::max(beyond / std::max(std::sqrt(discriminant) - along, 1e-20F), 0.0F);
  if (time > dt) return {};
  Impact hit;
  const Vec3 there = apart + relative * time;
  hit.normal = there * (1 / std::max(length(there), 1e-10F));
  hit.speed = -dot(relative, hit.normal);
  if (hit.speed > 3 * numbers_.weight * dt) hit.time = time;
  return hit;
}

/// Lets those pairs collide that meet each other first.
void BallHeap::strike(float dt) {
  for (std::size_t i = 0; i < positions.size(); ++i) {
    Impact best;
    partners_[i] = static_cast<int>(i);
    for (int k = 0; k < counts_[i]; ++k) {
      const int j = lists_[i * listed + static_cast<std::size_t>(k)];
      const Impact hit = impactOf(i, static_cast<std::size_t>(j), dt);
      if (hit.time < 0 ||
          (best.time >= 0 && (hit.time > best.time || (hit.time == best.time && hit.speed <= best.speed))))
        continue;
      best = hit;
      partners_[i] = j;
    }
  }
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto j = static_cast<std::size_t>(partners_[i]);
    if (j <= i || partners_[j] != static_cast<int>(i)) continue;
    const Impact hit = impactOf(i, j, dt);
    const float along = (1 + numbers_.restitution) * hit.speed;
    const Vec3 sliding = velocities[i] - velocities[j] + hit.normal * hit.speed;
    const Vec3 change =
        (hit.normal * along - sliding * (1 - leftByFriction(sliding, numbers_.friction * along))) * 0.5F;
    for (const std::size_t ball : {i, j}) {
      const float sign = ball == i ? 1.0F : -1.0F;
      velocities[ball] = velocities[ball] + change * sign;
      positions[ball] = positions[ball] + change * (sign * (dt - hit.time));
      outOfBox(positions[ball], &velocities[ball], starts_[ball]);
    }
  }
}

/// One Jacobi iteration over the overlaps.
void BallHeap::correct() {
  std::vector<Vec3>& next = scratch_[0];
  for (std::size_t i = 0; i < positions.size(); ++i) {
    Vec3 sum = {0, 0, 0};
    for (int k = 0; k < counts_[i]; ++k) {
      const auto j = static_cast<std::size_t>(lists_[i * listed + static_cast<std::size_t>(k)]);
      const Vec3 apart = positions[i] - positions[j];
      const float distance = length(apart), depth = 2 * numbers_.radius - distance;
      if (depth <= 0) continue;
      const Vec3 normal = apart * (1 / distance);
      const Vec3 way = (positions[i] - starts_[i]) - (positions[j] - starts_[j]);
      const Vec3 slid = way - normal * dot(way, normal);
      const float held = 1 - leftByFriction(slid, numbers_.friction * depth);
      sum = sum + (normal * depth - slid * held) * (1 / (shares_[i] + shares_[j]));
    }
    next[i] = positions[i] + sum;
    outOfBox(next[i], nullptr, starts_[i]);
  }
  positions.swap(next);
}

void BallHeap::leave(float dt) {
  std::vector<Vec3>& after = scratch_[1];
  const float perDt = 1 / dt;
  for (std::size_t i = 0; i < positions.size(); ++i)
    after[i] = velocities[i] + (positions[i] - struck_[i]) * perDt;
  scratch_[2] = velocities;
  const std::vector<Vec3>& before = scratch_[2];
  const float pull = numbers_.weight * dt;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    Vec3 velocity = after[i];
    float fastest = 0;
    bool touches = false;
    for (int k = 0; k < counts_[i]; ++k) {
      const auto j = static_cast<std::size_t>(lists_[i * listed + static_cast<std::size_t>(k)]);
      const float depth = 2 * numbers_.radius - length(struck_[i] - struck_[j]);
      if (depth <= 0) continue;
      const Vec3 apart = positions[i] - positions[j];
      const Vec3 normal = apart * (1 / length(apart));
      const float approach = dot(before[i] - before[j], normal), leaves = dot(after[i] - after[j], normal);
      const float wanted =
          approach < -3 * pull ? -numbers_.restitution * approach : std::max(approach, 0.0F);
      const float change = std::max(wanted - leaves, -depth * perDt);
      velocity = velocity + normal * (change / (shares_[i] + shares_[j]));
      fastest = std::max(fastest, -approach);
      touches = true;
    }
    const Vec3 change = velocity - before[i];
    const float maximum = 2 * pull + fastest;
    if (touches && length(change) > maximum) velocity = before[i] + change * (maximum / length(change));
    const Vec3 way = (positions[i] - starts_[i]) * perDt;
    if (touches && dot(way, way) < pull * pull && dot(velocity, velocity) < pull * pull) {
      positions[i] = starts_[i];
      velocity = velocity * 0.9F;
    }
    velocities[i] = velocity;
  }
}

}  // namespace plain
