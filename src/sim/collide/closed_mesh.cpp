#include "sim/collide/closed_mesh.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <tuple>

#include <fmt/format.h>
#include <glm/common.hpp>

namespace simreel::sim {

namespace {

using Corners = std::array<unsigned, 3>;

double dotOf(const glm::dvec3& a, const glm::dvec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
glm::dvec3 crossOf(const glm::dvec3& a, const glm::dvec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double lengthOf(const glm::dvec3& a) {
  return std::sqrt(dotOf(a, a));
}
/// Returns the unit vector, or zero for a zero vector.
glm::dvec3 unitOf(const glm::dvec3& a) {
  const double length = lengthOf(a);
  return length > 0 ? a / length : glm::dvec3(0);
}

/// Returns atan(t) for t >= 0 without libm, so that every machine gives the same bits. Halves the angle
/// twice, then evaluates the Taylor series.
double arcTangent(double t) {
  if (t > 1) return 0.5 * std::numbers::pi - arcTangent(1 / t);
  for (int i = 0; i < 2; ++i) t = t / (1 + std::sqrt(1 + t * t));
  double sum = 0;
  for (int k = 12; k >= 0; --k) sum = (k % 2 == 0 ? 1.0 : -1.0) / (2 * k + 1) + t * t * sum;
  return 4 * t * sum;
}

/// Returns the angle between two directions, 0 to pi.
double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
  const double along = dotOf(a, b);
  const double across = lengthOf(crossOf(a, b));
  const double whole = std::sqrt(along * along + across * across) + along;
  return whole > 0 ? 2 * arcTangent(across / whole) : across > 0 || along < 0 ? std::numbers::pi : 0;
}

/// Returns for each vertex the index of the first vertex at the same position.
std::vector<unsigned> welded(const std::vector<glm::vec3>& points) {
  std::vector<unsigned> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](unsigned i) { return std::tuple(points[i].x, points[i].y, points[i].z); };
  std::sort(order.begin(), order.end(),
            [&](unsigned a, unsigned b) { return std::tuple(key(a), a) < std::tuple(key(b), b); });
  std::vector<unsigned> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && points[order[i]] == points[order[i - 1]] ? first[order[i - 1]] : order[i];
  return first;
}

/// Directed side of a face, from one vertex to another vertex.
struct Side {
  unsigned low, high;  ///< the two vertices of the side in ascending order
  bool up;             ///< true if the side runs from `low` to `high`
  unsigned face;
  unsigned corner;  ///< index of the corner at which the side begins
};

std::vector<Side> sidesOf(const std::vector<Corners>& faces) {
  std::vector<Side> sides;
  sides.reserve(3 * faces.size());
  for (unsigned f = 0; f < faces.size(); ++f)
    for (unsigned k = 0; k < 3; ++k) {
      const unsigned a = faces[f][k];
      const unsigned b = faces[f][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), a < b, f, k});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tuple(a.low, a.high, a.face) < std::tuple(b.low, b.high, b.face);
  });
  return sides;
}

/// Throws unless each edge has two faces that traverse it in opposite directions.
void checkSides(const std::string& name, const std::vector<Side>& sides,
                const std::vector<glm::vec3>& points) {
  std::size_t open = 0;
  std::size_t crowded = 0;
  std::size_t turned = 0;
  glm::dvec3 place(0);
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
    const bool first = open + crowded + turned == 0;
    const std::size_t count = end - i;
    if (count == 1) ++open;
    if (count > 2) ++crowded;
    if (count == 2 && sides[i].up == sides[i + 1].up) ++turned;
    if (first && open + crowded + turned > 0)
      place = 0.5 * (glm::dvec3(points[sides[i].low]) + glm::dvec3(points[sides[i].high]));
    i = end;
  }
  const auto refuse = [&](std::size_t count, const char* what, const char* advice) {
    if (count > 0)
      fail(ExitCode::usage,
           "mesh \"{}\" collides, but is not closed: {} of its edges {}, the first near ({:.4g}, {:.4g}, "
           "{:.4g}); {}",
           name, count, what, place.x, place.y, place.z, advice);
  };
  refuse(open, "have a face on one side only", "close its holes, or use spheres and capsules instead");
  refuse(crowded, "have more than two faces", "move parts that touch apart, or make them one");
  refuse(turned, "have two faces that are turned differently", "turn all faces outwards");
}

}  // namespace

ClosedMesh::ClosedMesh(const std::string& name, const Mesh& mesh, float scale) {
  std::vector<glm::vec3> points;
  points.reserve(mesh.positions.size());
  for (const glm::vec3& p : mesh.positions) points.push_back(p * scale);
  const std::vector<unsigned> first = welded(points);
  std::vector<Corners> corners;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Corners face = {first[mesh.indices[i]], first[mesh.indices[i + 1]], first[mesh.indices[i + 2]]};
    if (face[0] != face[1] && face[1] != face[2] && face[2] != face[0]) corners.push_back(face);
  }
  if (corners.empty()) fail(ExitCode::usage, "mesh \"{}\" collides, but has no face with an area", name);
  const std::vector<Side> sides = sidesOf(corners);
  checkSides(name, sides, points);
  low = high = glm::dvec3(points[corners.front()[0]]);
  std::vector<glm::dvec3> ofFaces;  // face normals whose length is twice the area of the face
  for (const Corners& face : corners) {
    const glm::dvec3 a(points[face[0]]);
    const glm::dvec3 b(points[face[1]]);
    const glm::dvec3 c(points[face[2]]);
    ofFaces.push_back(crossOf(b - a, c - a));
    area += 0.5 * lengthOf(ofFaces.back());
    volume += dotOf(a, crossOf(b, c)) / 6;
    low = glm::min(low, glm::min(a, glm::min(b, c)));
    high = glm::max(high, glm::max(a, glm::max(b, c)));
  }
  if (std::abs(volume) <= 1e-9 * area * std::sqrt(area))
    fail(ExitCode::usage, "mesh \"{}\" collides, but encloses no space; use a \"plane\" object", name);
  const double outwards = volume < 0 ? -1 : 1;
  volume = std::abs(volume);
  std::vector<glm::dvec3> ofCorners(points.size(), glm::dvec3(0));
  for (std::size_t f = 0; f < corners.size(); ++f) {
    ofFaces[f] = unitOf(ofFaces[f]) * outwards;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 here(points[corners[f][k]]);
      const double angle = angleBetween(glm::dvec3(points[corners[f][(k + 1) % 3]]) - here,
                                        glm::dvec3(points[corners[f][(k + 2) % 3]]) - here);
      ofCorners[corners[f][k]] += ofFaces[f] * angle;
    }
  }
  std::vector<std::array<glm::dvec3, 3>> ofEdges(corners.size());
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
    const glm::dvec3 both = unitOf(ofFaces[sides[i].face] + ofFaces[sides[i + 1].face]);
    ofEdges[sides[i].face][sides[i].corner] = both;
    ofEdges[sides[i + 1].face][sides[i + 1].corner] = both;
  }
  for (std::size_t f = 0; f < corners.size(); ++f) {
    if (ofFaces[f] == glm::dvec3(0)) continue;  // the face is degenerate; its neighbours cover its edges
    Face& face = faces.emplace_back();
    face.normals[0] = glm::vec3(ofFaces[f]);
    for (std::size_t k = 0; k < 3; ++k) {
      face.corners[k] = points[corners[f][k]];
      face.normals[1 + k] = glm::vec3(ofEdges[f][k]);
      face.normals[4 + k] = glm::vec3(unitOf(ofCorners[corners[f][k]]));
    }
  }
}

}  // namespace simreel::sim
