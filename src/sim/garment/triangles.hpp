#pragma once
#include "sim/cloth/coloring.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Mesh prepared for cloth: coincident vertices are merged, and the neighbours of each face are known.
struct ClothTriangles {
  static constexpr unsigned none = 0xffffffffU;

  /// Face with counter-clockwise corners. Edge k goes from corner k to the next corner.
  struct Face {
    std::array<unsigned, 3> corners;
    std::array<unsigned, 3> neighbours;  ///< face on the other side of each edge, or `none` at a border
    std::array<unsigned, 3> beyond;      ///< third corner of the face on the other side of each edge
    double area;                         ///< area in m^2
  };

  /// Merges vertices that are at most `weld` (metres) apart into one vertex at the position of the first; 0
  /// merges only vertices at identical positions. Multiplies coordinates by `scale`. Throws
  /// UserError(usage), naming `name` and the position, for an edge with more than two faces, neighbours
  /// that face opposite directions, a face without area, and a vertex with no face or with more than 256
  /// faces.
  ClothTriangles(const std::string& name, const Mesh& mesh, double scale, double weld);

  std::vector<glm::dvec3> points;  ///< positions in metres, in the mesh's local space
  std::vector<Face> faces;         ///< faces in the mesh's order
  std::vector<unsigned> vertexOf;  ///< maps each vertex of the mesh to an index into `points`

  /// Faces around each vertex in ascending order: vertex i has the faces around[starts[i]] to
  /// around[starts[i + 1]] (exclusive).
  std::vector<unsigned> starts, around;

  /// Makes two faces neighbours if the ends of their border edges are sewn together by `stitches` (pairs of
  /// vertices), as if the cloth were continuous at the seam. Returns the number of pairs of faces that face
  /// opposite directions and therefore cannot be joined.
  int sew(const std::vector<std::pair<unsigned, unsigned>>& stitches);
  /// Returns the first of the vertices that are sewn together with `vertex`, which may be `vertex` itself.
  [[nodiscard]] unsigned firstOf(unsigned vertex) const { return sewn_.empty() ? vertex : sewn_[vertex]; }
  /// Returns the index, in the neighbouring face beyond edge `side`, of the edge that both faces have in
  /// common.
  [[nodiscard]] std::size_t sideBeyond(unsigned face, std::size_t side) const;

 private:
  void join(const std::string& name);
  void gather(const std::string& name);

  std::vector<unsigned> sewn_;  ///< for each vertex, the first vertex sewn together with it, or itself;
                                ///< empty if nothing is sewn
};

/// Returns the edges around the drawn vertices.
[[nodiscard]] ClothEdges edgesOf(const ClothTriangles& cloth);

/// Returns the colour of each face, from 0 on, by greedy colouring. Faces of one colour have no vertex in
/// common, so they can be moved in parallel.
[[nodiscard]] std::vector<int> colourFaces(const ClothTriangles& cloth);

}  // namespace simreel::sim
