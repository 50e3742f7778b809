#include "sim/water/float_shape.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace simreel::sim {

namespace {

constexpr int longestNodes = 32;   ///< Number of lattice steps along the longest side of the body.
constexpr int margin = 2;          ///< Number of lattice steps added on each side of the body.
constexpr int longestProbes = 20;  ///< Number of probe spacings along the longest side of the body.

double dot(const glm::dvec3& a, const glm::dvec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
double length(const glm::dvec3& v) {
  return std::sqrt(dot(v, v));
}
std::size_t placeIn(const glm::ivec3& counts, int x, int y, int z) {
  return (static_cast<std::size_t>(z) * static_cast<std::size_t>(counts.y) + static_cast<std::size_t>(y)) *
             static_cast<std::size_t>(counts.x) +
         static_cast<std::size_t>(x);
}

/// Nearest mesh face of each lattice node.
class NearestFaces {
 public:
  NearestFaces(const ClosedMesh& mesh, const glm::dvec3& low, double step, const glm::ivec3& counts)
      : mesh_(mesh), low_(low), step_(step), counts_(counts), found_(placeIn(counts, 0, 0, counts.z)) {
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) note(i);
    // Propagates faces to neighbouring nodes, including diagonal neighbours, in ascending and then in
    // descending index order, twice. Each node keeps the nearest of the faces that it is offered.
    for (int round = 0; round < 2; ++round) {
      spread(1);
      spread(-1);
    }
  }
  [[nodiscard]] glm::dvec3 at(int x, int y, int z) const { return low_ + step_ * glm::dvec3(x, y, z); }
  /// Returns the normal in xyz and the signed distance in w.
  [[nodiscard]] glm::vec4 distance(int x, int y, int z) const {
    const glm::dvec3 p = at(x, y, z);
    const NearestOnFace nearest = nearestOnFace(mesh_.faces[found_[placeIn(counts_, x, y, z)].face], p);
    const glm::dvec3 off = p - nearest.place;
    const double away = length(off);
    const double sign = dot(off, nearest.normal) < 0 ? -1 : 1;
    const glm::dvec3 normal = away > 1e-6 * step_ ? off * (sign / away) : nearest.normal;
    return glm::vec4(glm::dvec4(normal, sign * away));
  }

 private:
  struct Found {
    std::size_t face = 0;
    double square = 1e300;
  };
  void offer(int x, int y, int z, std::size_t face) {
    const glm::dvec3 off = at(x, y, z) - nearestOnFace(mesh_.faces[face], at(x, y, z)).place;
    Found& found = found_[placeIn(counts_, x, y, z)];
    if (dot(off, off) < found.square) found = {face, dot(off, off)};
  }
  void note(std::size_t face) {
    glm::dvec3 lowest(1e300), highest(-1e300);
    for (const glm::vec3& corner : mesh_.faces[face].corners) {
      lowest = glm::min(lowest, glm::dvec3(corner));
      highest = glm::max(highest, glm::dvec3(corner));
    }
    glm::ivec3 from(0), to(0);
    for (int i = 0; i < 3; ++i) {
      from[i] = std::clamp(static_cast<int>(std::floor((lowest[i] - low_[i]) / step_)), 0, counts_[i] - 1);
      to[i] = std::clamp(static_cast<int>(std::ceil((highest[i] - low_[i]) / step_)), 0, counts_[i] - 1);
    }
    for (int z = from.z; z <= to.z; ++z)
      for (int y = from.y; y <= to.y; ++y)
        for (int x = from.x; x <= to.x; ++x) offer(x, y, z, face);
  }
  void spread(int way) {
    const auto of = [&](int i, int count) { return way > 0 ? i : count - 1 - i; };
    for (int k = 0; k < counts_.z; ++k)
      for (int j = 0; j < counts_.y; ++j)
        for (int i = 0; i < counts_.x; ++i) {
          const int x = of(i, counts_.x), y = of(j, counts_.y), z = of(k, counts_.z);
          const auto from = [&](int nx, int ny, int nz) {
            if (nx < 0 || ny < 0 || nz < 0 || nx >= counts_.x || ny >= counts_.y || nz >= counts_.z) return;
            const Found& there = found_[placeIn(counts_, nx, ny, nz)];
            if (there.square < 1e300) offer(x, y, z, there.face);
          };
          for (int n = 1; n < 8; ++n)
            from(x - way * (n & 1), y - way * (n >> 1 & 1), z - way * (n >> 2 & 1));
        }
  }

  const ClosedMesh& mesh_;
  glm::dvec3 low_;
  double step_;
  glm::ivec3 counts_;
  std::vector<Found> found_;
};

/// Returns sample points of the surface, corners first, at most one per cube of a lattice.
std::vector<glm::vec4> probesOf(const ClosedMesh& mesh, const glm::dvec3& middle, double probeDistance) {
  const glm::ivec3 cubes = glm::ivec3(glm::floor((mesh.high - mesh.low) / probeDistance)) + 1;
  std::vector<bool> taken(placeIn(cubes, 0, 0, cubes.z));
  std::vector<glm::vec4> probes;
  const auto addProbe = [&](const glm::dvec3& p) {
    const glm::ivec3 cube =
        glm::clamp(glm::ivec3(glm::floor((p - mesh.low) / probeDistance)), glm::ivec3(0), cubes - 1);
    const std::size_t i = placeIn(cubes, cube.x, cube.y, cube.z);
    if (taken[i]) return;
    taken[i] = true;
    probes.emplace_back(glm::vec3(p - middle), 0.0F);
  };
  for (const ClosedMesh::Face& face : mesh.faces)
    for (const glm::vec3& corner : face.corners) addProbe(glm::dvec3(corner));
  for (const ClosedMesh::Face& face : mesh.faces) {
    const glm::dvec3 a(face.corners[0]);
    const glm::dvec3 ab = glm::dvec3(face.corners[1]) - a, ac = glm::dvec3(face.corners[2]) - a;
    const double longest = std::max({length(ab), length(ac), length(ac - ab)});
    const int parts = static_cast<int>(std::ceil(2 * longest / probeDistance));
    for (int i = 0; i <= parts; ++i)
      for (int j = 0; i + j <= parts; ++j)
        addProbe(a + ab * (double(i) / parts) + ac * (double(j) / parts));
  }
  return probes;
}

}  // namespace

FloatShape::FloatShape(double radius) : radius(std::max(radius, 1e-9)) {
  probes.emplace_back(0.0F, 0.0F, 0.0F, static_cast<float>(this->radius));
}

FloatShape::FloatShape(const ClosedMesh& mesh, const glm::dvec3& middle) {
  const glm::dvec3 extent = mesh.high - mesh.low;
  const double longest = std::max({extent.x, extent.y, extent.z});
  step = longest / longestNodes;
  for (int i = 0; i < 3; ++i) counts[i] = static_cast<int>(std::ceil(extent[i] / step)) + 1 + 2 * margin;
  const glm::dvec3 from = 0.5 * (mesh.low + mesh.high) - 0.5 * step * glm::dvec3(counts - 1);
  const NearestFaces nearest(mesh, from, step, counts);
  for (int z = 0; z < counts.z; ++z)
    for (int y = 0; y < counts.y; ++y)
      for (int x = 0; x < counts.x; ++x) nodes.push_back(nearest.distance(x, y, z));
  low = from - middle;
  probes = probesOf(mesh, middle, longest / longestProbes);
}

// Ericson, "Real-Time Collision Detection", section 5.1.5.
NearestOnFace nearestOnFace(const ClosedMesh::Face& face, const glm::dvec3& p) {
  const glm::dvec3 a(face.corners[0]), b(face.corners[1]), c(face.corners[2]);
  const auto normal = [&](int i) { return glm::dvec3(face.normals[static_cast<std::size_t>(i)]); };
  const glm::dvec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return {a, normal(4)};
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return {b, normal(5)};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {a + ab * (d1 / (d1 - d3)), normal(1)};
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return {c, normal(6)};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {a + ac * (d2 / (d2 - d6)), normal(3)};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return {b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6))), normal(2)};
  return {a + ab * (vb / (va + vb + vc)) + ac * (vc / (va + vb + vc)), normal(0)};
}

}  // namespace simreel::sim
