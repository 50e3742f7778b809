#include "plain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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
Vec3 minimum(const Vec3& a, const Vec3& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vec3 maximum(const Vec3& a, const Vec3& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}
int cellOf(float x, float size) {
  return int(std::floor(x / size));
}

/// Returns the barycentric coordinates of the point of triangle abc closest to p (Ericson, Real-Time
/// Collision Detection).
Vec3 closest(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const float d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Vec3 bp = p - b;
  const float d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  const Vec3 cp = p - c;
  const float d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const float t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - t, t};
  }
  const float all = 1 / (va + vb + vc);
  return {va * all, vb * all, vc * all};
}

}  // namespace

Contact::Contact(std::vector<std::uint32_t> indices, std::size_t vertices, float cell, float thickness,
                 float friction)
    : indices_(std::move(indices)), cell_(cell), thickness_(thickness), friction_(friction) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t i = 0; i < indices_.size(); ++i) {
    const std::uint32_t a = indices_[i], b = indices_[i % 3 == 2 ? i - 2 : i + 1];
    edges.emplace_back(std::min(a, b), std::max(a, b));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const auto& [a, b] : edges) edges_.insert(edges_.end(), {a, b});
  std::size_t slots = 1;
  while (slots < 2 * vertices) slots *= 2;
  starts_.resize(slots + 1);
}

std::size_t Contact::slot(int x, int y, int z) const {
  const auto h = std::uint32_t(x) * 73856093U ^ std::uint32_t(y) * 19349663U ^ std::uint32_t(z) * 83492791U;
  return h & (starts_.size() - 2);
}

template <class Visit>
void Contact::cells(const Box& box, const Visit& visit) const {
  for (int z = cellOf(box.low.z, cell_); z <= cellOf(box.high.z, cell_); ++z)
    for (int y = cellOf(box.low.y, cell_); y <= cellOf(box.high.y, cell_); ++y)
      for (int x = cellOf(box.low.x, cell_); x <= cellOf(box.high.x, cell_); ++x) visit(x, y, z);
}

void Contact::fill(const std::vector<Box>& boxes) {
  std::fill(starts_.begin(), starts_.end(), 0);
  for (const Box& box : boxes) cells(box, [&](int x, int y, int z) { ++starts_[slot(x, y, z) + 1]; });
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  entries_.resize(starts_.back());
  static thread_local std::vector<std::uint32_t> at;
  at = starts_;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    cells(boxes[i], [&](int x, int y, int z) { entries_[at[slot(x, y, z)]++] = i; });
}

void Contact::push(const std::vector<Vec3>& now, std::vector<Vec3>& next,
                   const std::vector<float>& inverseMass) {
  touches_.clear();
  const Vec3 wide{0.75F * thickness_, 0.75F * thickness_, 0.75F * thickness_};
  const auto apart = [](const Box& a, const Box& b) {
    return a.low.x > b.high.x || a.low.y > b.high.y || a.low.z > b.high.z || b.low.x > a.high.x ||
           b.low.y > a.high.y || b.low.z > a.high.z;
  };
  const auto boxOf = [&](std::initializer_list<std::uint32_t> corners) {
    const std::uint32_t first = *corners.begin();
    Box box{now[first], now[first]};
    for (const std::uint32_t v : corners) {
      box.low = minimum(box.low, minimum(now[v], next[v]));
      box.high = maximum(box.high, maximum(now[v], next[v]));
    }
    return Box{box.low - wide, box.high + wide};
  };
  boxes_.clear();
  for (std::size_t f = 0; f < indices_.size(); f += 3)
    boxes_.push_back(boxOf({indices_[f], indices_[f + 1], indices_[f + 2]}));
  fill(boxes_);
  for (std::uint32_t v = 0; v < now.size(); ++v) {
    const Box box = boxOf({v});
    cells(box, [&](int x, int y, int z) {
      for (std::uint32_t k = starts_[slot(x, y, z)]; k < starts_[slot(x, y, z) + 1]; ++k) {
        const std::size_t f = entries_[k];
        const std::uint32_t* c = &indices_[3 * f];
        if (apart(box, boxes_[f]) || c[0] == v || c[1] == v || c[2] == v) continue;
        // A pair may share several cells. It is handled only in the cell with the smallest coordinates.
        const Vec3 low = maximum(box.low, boxes_[f].low);
        if (cellOf(low.x, cell_) == x && cellOf(low.y, cell_) == y && cellOf(low.z, cell_) == z)
          addVertex(now, int(v), f);
      }
    });
  }
  boxes_.clear();
  for (std::size_t e = 0; e < edges_.size(); e += 2) boxes_.push_back(boxOf({edges_[e], edges_[e + 1]}));
  fill(boxes_);
  for (std::uint32_t i = 0; i < boxes_.size(); ++i)
    cells(boxes_[i], [&](int x, int y, int z) {
      for (std::uint32_t k = starts_[slot(x, y, z)]; k < starts_[slot(x, y, z) + 1]; ++k) {
        const std::uint32_t j = entries_[k];
        if (j <= i || apart(boxes_[i], boxes_[j])) continue;
        const std::uint32_t *a = &edges_[2 * i], *b = &edges_[2 * j];
        if (a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1]) continue;
        const Vec3 low = maximum(boxes_[i].low, boxes_[j].low);
        if (cellOf(low.x, cell_) == x && cellOf(low.y, cell_) == y && cellOf(low.z, cell_) == z)
          addEdges(now, i, j);
      }
    });
  for (int round = 0; round < 2; ++round) solve(now, next, inverseMass);
}

void Contact::addVertex(const std::vector<Vec3>& now, int v, std::size_t face) {
  const std::uint32_t* c = &indices_[3 * face];
  const Vec3 s = closest(now[v], now[c[0]], now[c[1]], now[c[2]]);
  if (s.x == 0 || s.y == 0 || s.z == 0)
    return;  // The closest point is on an edge. Edge pairs handle this
             // case.
  const int corner[4] = {v, int(c[0]), int(c[1]), int(c[2])};
  const float share[4] = {1, -s.x, -s.y, -s.z};
  addTouch(corner, share, now[v] - now[c[0]] * s.x - now[c[1]] * s.y - now[c[2]] * s.z);
}

void Contact::addEdges(const std::vector<Vec3>& now, std::size_t i, std::size_t j) {
  const int corner[4] = {int(edges_[2 * i]), int(edges_[2 * i + 1]), int(edges_[2 * j]),
                         int(edges_[2 * j + 1])};
  const Vec3 a = now[corner[0]], along = now[corner[1]] - a, c = now[corner[2]], other = now[corner[3]] - c;
  const Vec3 apart = a - c;
  const float aa = dot(along, along), ee = dot(other, other), ab = dot(along, other);
  const float slope = aa * ee - ab * ab;
  if (slope <= 1e-6F * aa * ee) return;
  const float s = (ab * dot(other, apart) - dot(along, apart) * ee) / slope;
  const float t = (ab * s + dot(other, apart)) / ee;
  if (s <= 0 || s >= 1 || t <= 0 || t >= 1)
    return;  // The closest point is at a vertex. Vertex-face pairs handle this case.
  const float share[4] = {1 - s, s, t - 1, -t};
  addTouch(corner, share, apart + along * s - other * t);
}

void Contact::addTouch(const int* corner, const float* share, const Vec3& apart) {
  const float length = std::sqrt(dot(apart, apart));
  if (length > 1.5F * thickness_ || length < 1e-9F) return;
  Touch touch{{corner[0], corner[1], corner[2], corner[3]},
              {share[0], share[1], share[2], share[3]},
              apart * (1 / length),
              length};
  touches_.push_back(touch);
}

void Contact::solve(const std::vector<Vec3>& now, std::vector<Vec3>& next,
                    const std::vector<float>& inverseMass) {
  for (const Touch& t : touches_) {
    Vec3 gap{0, 0, 0}, slide{0, 0, 0};
    float weight = 0;
    for (int k = 0; k < 4; ++k) {
      const int c = t.corner[k];
      gap = gap + next[c] * t.share[k];
      slide = slide + (next[c] - now[c]) * t.share[k];
      weight += inverseMass[c] * t.share[k] * t.share[k];
    }
    // A pair that is already too near is separated by only a twentieth of the missing distance, so that it
    // gains no speed.
    const float missing = std::max(thickness_ - t.distance, 0.0F);
    const float push = thickness_ - 0.95F * missing - dot(gap, t.normal);
    if (push <= 0 || weight == 0) continue;
    const Vec3 along = slide - t.normal * dot(slide, t.normal);
    const float held = std::min(friction_ * push / std::max(std::sqrt(dot(along, along)), 1e-12F), 1.0F);
    const Vec3 way = (t.normal * push - along * held) * (1 / weight);
    for (int k = 0; k < 4; ++k)
      next[t.corner[k]] = next[t.corner[k]] + way * (inverseMass[t.corner[k]] * t.share[k]);
  }
}

}  // namespace plain
