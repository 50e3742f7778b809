#include "sim/volume/cubes.hpp"

#include "base/error.hpp"

#include <cstddef>

namespace simreel::sim {

namespace {

/// Corners of each face, counter-clockwise as seen from outside the cube.
constexpr int faceCorners[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                   {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

/// Returns the edge between two corners that differ along one axis.
int edgeBetween(int a, int b) {
  const int axis = (a ^ b) == 1 ? 0 : (a ^ b) == 2 ? 1 : 2;
  const int low = a & b;
  const int at = axis == 0 ? low >> 1 : axis == 1 ? (low & 1) | (low >> 2) << 1 : low & 3;
  return 4 * axis + at;
}

CubeKind kindOfCube(int kind) {
  const auto inside = [&](int corner) { return (kind >> corner & 1) != 0; };
  // Walks around each face. A segment of the surface starts where the walk leaves the inside and ends where
  // it next enters the inside again. `after` maps each crossed edge to the next edge of the same polygon.
  int after[12];
  for (int& edge : after) edge = -1;
  for (const auto& face : faceCorners)
    for (int i = 0; i < 4; ++i) {
      if (!inside(face[i]) || inside(face[(i + 1) % 4])) continue;
      for (int j = 1; j < 4; ++j) {
        const int from = face[(i + j) % 4], to = face[(i + j + 1) % 4];
        if (inside(from) || !inside(to)) continue;
        after[edgeBetween(face[i], face[(i + 1) % 4])] = edgeBetween(from, to);
        break;
      }
    }
  CubeKind made;
  for (int first = 0; first < 12; ++first) {
    if (after[first] < 0) continue;
    std::vector<int> polygon;
    for (int edge = first; after[edge] >= 0;) {
      polygon.push_back(edge);
      const int next = after[edge];
      after[edge] = -1;
      edge = next;
    }
    // Triangulates the polygon as a fan around its first edge. Polygons run clockwise around the inside, so
    // the winding is reversed.
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
      made.triangles.push_back({polygon[0], polygon[i + 1], polygon[i]});
  }
  return made;
}

}  // namespace

const std::array<CubeKind, 256>& cubeKinds() {
  static const std::array<CubeKind, 256> kinds = [] {
    std::array<CubeKind, 256> all;
    for (int kind = 0; kind < 256; ++kind) all[static_cast<std::size_t>(kind)] = kindOfCube(kind);
    return all;
  }();
  return kinds;
}

std::vector<glm::uvec4> cubeWords() {
  std::vector<glm::uvec4> words;
  for (const CubeKind& kind : cubeKinds()) {
    SIMREEL_CHECK(kind.triangles.size() <= 5);
    glm::uvec4 word(kind.triangles.size(), 0, 0, 0);
    unsigned t = 0;
    for (const auto& triangle : kind.triangles)
      for (const int edge : triangle) {
        word[t < 8 ? 1 : 2] |= static_cast<unsigned>(edge) << (4 * (t % 8));
        ++t;
      }
    words.push_back(word);
  }
  return words;
}

}  // namespace simreel::sim
