#include "plain.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace plain {

void pairs(const std::vector<Body>& bodies, std::vector<Vec3>& acceleration, float gravity,
           float softening) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Vec3 sum{0, 0, 0};
    for (const Body& body : bodies) {
      const float dx = body.x - bodies[i].x, dy = body.y - bodies[i].y, dz = body.z - bodies[i].z;
      const float inverse = 1 / std::sqrt(dx * dx + dy * dy + dz * dz + softening * softening);
      const float pull = body.mass * inverse * inverse * inverse;
      sum.x += dx * pull;
      sum.y += dy * pull;
      sum.z += dz * pull;
    }
    acceleration[i] = {sum.x * gravity, sum.y * gravity, sum.z * gravity};
  }
}

namespace {

struct Node {
  std::array<int, 8> child;  ///< indices of the child nodes; 0 for no child
  float x, y, z, half;       ///< centre and half width of the node's cube
  float mass, cx, cy, cz;    ///< total mass and centre of mass of the bodies inside
  int body;                  ///< index of the body in a leaf; -1 for no body
};

class Octree {
 public:
  Octree(const std::vector<Body>& bodies, float gravity, float softening, float opening)
      : bodies_(bodies), gravity_(gravity), softening_(softening), opening_(opening) {
    float half = 0;
    for (const Body& b : bodies) half = std::max({half, std::abs(b.x), std::abs(b.y), std::abs(b.z)});
    nodes_.reserve(2 * bodies.size());
    add(0, 0, 0, half * 1.0001F);
    for (int i = 0; i < int(bodies.size()); ++i) insert(0, i, 0);
    sum(0);
  }
  [[nodiscard]] Vec3 at(int i) const {
    Vec3 a{0, 0, 0};
    walk(0, i, a);
    return {a.x * gravity_, a.y * gravity_, a.z * gravity_};
  }

 private:
  int add(float x, float y, float z, float half) {
    nodes_.push_back({{}, x, y, z, half, 0, 0, 0, 0, -1});
    return int(nodes_.size()) - 1;
  }
  void insert(int n, int i, int depth) {
    if (nodes_[n].mass == 0) {
      nodes_[n].body = i;
      nodes_[n].mass = bodies_[i].mass;
      return;
    }
    if (depth > 60) return;
    nodes_[n].mass += bodies_[i].mass;
    if (const int other = nodes_[n].body; other >= 0) {
      nodes_[n].body = -1;
      down(n, other, depth);
    }
    down(n, i, depth);
  }
  void down(int n, int i, int depth) {
    const Body& b = bodies_[i];
    const int octant = (b.x > nodes_[n].x) + 2 * (b.y > nodes_[n].y) + 4 * (b.z > nodes_[n].z);
    if (nodes_[n].child[octant] == 0) {
      const float h = nodes_[n].half / 2;
      const int made = add(nodes_[n].x + (octant & 1 ? h : -h), nodes_[n].y + (octant & 2 ? h : -h),
                           nodes_[n].z + (octant & 4 ? h : -h), h);
      nodes_[n].child[octant] = made;
    }
    insert(nodes_[n].child[octant], i, depth + 1);
  }
  void sum(int n) {
    Node& node = nodes_[n];
    if (node.body >= 0) {
      const Body& b = bodies_[node.body];
      node.cx = b.x;
      node.cy = b.y;
      node.cz = b.z;
      return;
    }
    float mass = 0;
    for (const int c : node.child) {
      if (c == 0) continue;
      sum(c);
      mass += nodes_[c].mass;
      node.cx += nodes_[c].cx * nodes_[c].mass;
      node.cy += nodes_[c].cy * nodes_[c].mass;
      node.cz += nodes_[c].cz * nodes_[c].mass;
    }
    node.mass = mass;
    node.cx /= mass;
    node.cy /= mass;
    node.cz /= mass;
  }
  void walk(int n, int i, Vec3& a) const {
    const Node& node = nodes_[n];
    const Body& b = bodies_[i];
    const float dx = node.cx - b.x, dy = node.cy - b.y, dz = node.cz - b.z;
    const float squared = dx * dx + dy * dy + dz * dz;
    if (node.body >= 0 || 4 * node.half * node.half < opening_ * opening_ * squared) {
      const float inverse = 1 / std::sqrt(squared + softening_ * softening_);
      const float pull = node.mass * inverse * inverse * inverse;
      a.x += dx * pull;
      a.y += dy * pull;
      a.z += dz * pull;
      return;
    }
    for (const int c : node.child)
      if (c != 0) walk(c, i, a);
  }

  const std::vector<Body>& bodies_;
  float gravity_, softening_, opening_;
  std::vector<Node> nodes_;
};

}  // namespace

void tree(const std::vector<Body>& bodies, std::vector<Vec3>& acceleration, float gravity, float softening,
          float opening) {
  const Octree octree(bodies, gravity, softening, opening);
  for (int i = 0; i < int(bodies.size()); ++i) acceleration[i] = octree.at(i);
}

}  // namespace plain
