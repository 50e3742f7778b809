#include "sim/contact/crossings.hpp"

#include <cstddef>
#include <limits>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

namespace {

struct Box {
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};
  void include(const glm::dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void include(const Box& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  [[nodiscard]] bool meets(const Box& other) const {
    for (int axis = 0; axis < 3; ++axis)
      if (low[axis] > other.high[axis] || other.low[axis] > high[axis]) return false;
    return true;
  }
};

/// Returns six times the signed volume of a tetrahedron; its sign tells on which side of the plane through
/// a, b, c the point d lies.
double volume(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  return glm::dot(glm::cross(b - a, c - a), d - a);
}

/// Bounding volume tree over faces, with the layout of glsl/contact/search.glsl.
class FaceTree {
 public:
  FaceTree(const ContactPlan& plan, std::span<const glm::vec4> positions)
      : faces_(plan.faces()),
        positions_(positions),
        movable_(static_cast<unsigned>(plan.movable())),
        boxes_(2 * plan.faces().size()) {
    const std::vector<glm::uvec4>& faces = faces_;
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (faces[i].w == 0)
        for (int k = 0; k < 3; ++k) boxes_[faces.size() + i].include(at(faces[i][k]));
    for (std::size_t node = faces.size() - 1; node > 0; --node) {
      boxes_[node] = boxes_[2 * node];
      boxes_[node].include(boxes_[2 * node + 1]);
    }
  }

  [[nodiscard]] long crossedBy(const glm::uvec4& edge) const {
    Box box;
    box.include(at(edge.x));
    box.include(at(edge.y));
    long count = 0;
    std::vector<std::size_t> open{1};
    while (!open.empty()) {
      const std::size_t node = open.back();
      open.pop_back();
      if (!boxes_[node].meets(box)) continue;
      if (node < faces_.size()) {
        open.push_back(2 * node);
        open.push_back(2 * node + 1);
      } else if (crosses(edge, faces_[node - faces_.size()])) {
        ++count;
      }
    }
    return count;
  }

 private:
  [[nodiscard]] glm::dvec3 at(unsigned vertex) const { return glm::dvec3(glm::vec3(positions_[vertex])); }

  [[nodiscard]] bool crosses(const glm::uvec4& edge, const glm::uvec4& face) const {
    for (int k = 0; k < 3; ++k)
      if (face[k] == edge.x || face[k] == edge.y) return false;
    if (face.x >= movable_ && edge.x >= movable_) return false;
    const glm::dvec3 p = at(edge.x), q = at(edge.y), a = at(face.x), b = at(face.y), c = at(face.z);
    if ((volume(a, b, c, p) > 0) == (volume(a, b, c, q) > 0)) return false;
    const bool side = volume(p, q, a, b) > 0;
    return side == (volume(p, q, b, c) > 0) && side == (volume(p, q, c, a) > 0);
  }

  const std::vector<glm::uvec4>& faces_;
  std::span<const glm::vec4> positions_;
  unsigned movable_;
  std::vector<Box> boxes_;
};

}  // namespace

long crossingsOf(const ContactPlan& plan, std::span<const glm::vec4> positions) {
  const FaceTree tree(plan, positions);
  long count = 0;
  for (const glm::uvec4& edge : plan.edges())
    if (edge.w == 0) count += tree.crossedBy(edge);
  return count;
}

}  // namespace simreel::sim
