#include "sim/contour/unwrap.hpp"

#include <cmath>

#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

constexpr unsigned perPoint = 4, wallBottom = 1,
                   wallTop = 2;  // Order of the vertices of a contour point, as in
                                 // glsl/contour/vertices.glsl.
constexpr std::size_t wallIndices = 6;

/// Sets UVs by axis-aligned projection. The result is correct for all vertices except wall vertices.
void unwrapFlat(MeshTable& mesh, double metre) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::dvec3 p(mesh.positions[i]);
    const glm::dvec3 n(mesh.normals[i]);
    const bool level = std::abs(n.y) > 0.5;
    // Seen from outside with y up, cross(y, n) points to the right. Faces that point down use the mirrored
    // mapping of faces that point up.
    const glm::dvec2 at = level ? glm::dvec2(n.y * p.x, p.z) : glm::dvec2(n.z * p.x - n.x * p.z, -p.y);
    mesh.uvs.emplace_back(at / metre);
  }
}

class WallSheets {
 public:
  WallSheets(MeshTable& mesh, const std::vector<unsigned>& next, unsigned firstPoint, double metre)
      : mesh_(mesh), next_(next), firstPoint_(firstPoint), metre_(metre), seams_(next.size(), 0) {}

  void unroll() {
    std::vector<bool> done(next_.size(), false);
    for (unsigned start = 0; start < next_.size(); ++start) {
      double along = 0;
      for (unsigned point = start; !done[point]; point = next_[point]) {
        done[point] = true;
        place(vertexOf(point) + wallBottom, along);
        place(vertexOf(point) + wallTop, along);
        along += lengthFrom(point);
        if (next_[point] == start) addSeam(start, along);
      }
    }
    for (std::size_t i = 0; i + 2 < mesh_.indices.size(); i += 3) moveToSeam(&mesh_.indices[i]);
  }

 private:
  [[nodiscard]] unsigned vertexOf(unsigned point) const { return firstPoint_ + perPoint * point; }
  [[nodiscard]] double lengthFrom(unsigned point) const {
    return glm::distance(glm::dvec3(mesh_.positions[vertexOf(point) + wallBottom]),
                         glm::dvec3(mesh_.positions[vertexOf(next_[point]) + wallBottom]));
  }
  /// Seen from outside the wall, the contour runs from right to left.
  void place(unsigned vertex, double along) {
    mesh_.uvs[vertex] = glm::dvec2(-along, -static_cast<double>(mesh_.positions[vertex].y)) / metre_;
  }
  void addSeam(unsigned start, double along) {
    seams_[start] = static_cast<unsigned>(mesh_.positions.size());
    for (const unsigned vertex : {vertexOf(start) + wallBottom, vertexOf(start) + wallTop}) {
      const glm::vec3 position = mesh_.positions[vertex];
      const glm::vec3 normal = mesh_.normals[vertex];
      mesh_.positions.push_back(position);
      mesh_.normals.push_back(normal);
      mesh_.uvs.emplace_back();
      place(static_cast<unsigned>(mesh_.positions.size()) - 1, along);
    }
  }
  /// Returns true if the vertex is a wall vertex of a contour point.
  [[nodiscard]] bool isWall(unsigned vertex) const {
    const unsigned part = (vertex - firstPoint_) % perPoint;
    return vertex >= firstPoint_ && vertex < vertexOf(static_cast<unsigned>(next_.size())) &&
           (part == wallBottom || part == wallTop);
  }
  /// Makes the wall triangle between a contour's last and first point use the duplicated vertices at the
  /// seam.
  void moveToSeam(unsigned* triangle) const {
    for (int i = 0; i < 3; ++i)
      if (!isWall(triangle[i])) return;
    for (int i = 0; i < 3; ++i) {
      const unsigned to = next_[(triangle[i] - firstPoint_) / perPoint];
      if (seams_[to] == 0) continue;
      for (int k = 0; k < 3; ++k)
        if (isWall(triangle[k]) && (triangle[k] - firstPoint_) / perPoint == to)
          triangle[k] = seams_[to] + (triangle[k] - firstPoint_) % perPoint - wallBottom;
      return;
    }
  }

  MeshTable& mesh_;
  const std::vector<unsigned>& next_;
  unsigned firstPoint_;
  double metre_;
  std::vector<unsigned> seams_;  ///< For the first point of a contour, index of the duplicated vertex at
                                 ///< the seam; 0 for other points.
};

}  // namespace

void unwrap(MeshTable& mesh, const std::vector<unsigned>& next, unsigned firstPoint, float metre) {
  unwrapFlat(mesh, static_cast<double>(metre));
  WallSheets(mesh, next, firstPoint, static_cast<double>(metre)).unroll();
}

}  // namespace simreel::sim
