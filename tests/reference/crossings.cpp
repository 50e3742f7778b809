#include "reference/crossings.hpp"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace {

/// True if the segment p-q passes through the triangle a-b-c. Uses signed volumes in double precision.
bool crosses(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& a, const glm::dvec3& b,
             const glm::dvec3& c) {
  const auto volume = [](const glm::dvec3& u, const glm::dvec3& v, const glm::dvec3& w,
                         const glm::dvec3& x) { return glm::dot(glm::cross(v - u, w - u), x - u); };
  if ((volume(a, b, c, p) > 0) == (volume(a, b, c, q) > 0)) return false;
  const bool s = volume(p, q, a, b) > 0;
  return s == (volume(p, q, b, c) > 0) && s == (volume(p, q, c, a) > 0);
}

}  // namespace

int crossings(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& faces,
              unsigned firstSolid) {
  int count = 0;
  for (const glm::uvec3& f : faces) {
    const glm::dvec3 &a = points[f.x], &b = points[f.y], &c = points[f.z];
    const glm::dvec3 low = glm::min(glm::min(a, b), c), high = glm::max(glm::max(a, b), c);
    for (const glm::uvec3& g : faces) {
      if (f.x >= firstSolid && g.x >= firstSolid) continue;
      for (int k = 0; k < 3; ++k) {
        const unsigned u = g[k], v = g[(k + 1) % 3];
        if (u == f.x || u == f.y || u == f.z || v == f.x || v == f.y || v == f.z) continue;
        const glm::dvec3 &p = points[u], &q = points[v];
        bool disjoint = false;
        for (int axis = 0; axis < 3; ++axis)
          disjoint =
              disjoint || std::max(p[axis], q[axis]) < low[axis] || std::min(p[axis], q[axis]) > high[axis];
        count += !disjoint && crosses(p, q, a, b, c) ? 1 : 0;
      }
    }
  }
  return count;
}
