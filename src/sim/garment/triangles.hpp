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

/// Mesh prepared for cloth: coincident vertices are merged and faces store their neighbours.
struct ClothTriangles {
  static constexpr unsigned none = 0xffffffffU;

  /// Face with counter-clockwise corners; edge k leads from corner k to the next one.
  struct Face {
    std::array<unsigned, 3> corners;
    std::array<unsigned, 3> neighbours;  ///< face beyond each edge; none: border
    std::array<unsigned, 3> beyond;      ///< third corner of the face beyond each edge
    double area;                         ///< area in m^2
  };

  /// Merges vertices no farther apart than `weld` (metres) into one at the first one's position; 0 merges
  /// only vertices at identical positions. Multiplies coordinates by `scale`. Throws UserError(usage),
  /// naming `name` and the position, for an edge with more than two faces, neighbours that face opposite
  /// ways, a face without area, and a vertex with no face or more than 256.
  ClothTriangles(const std::string& name, const Mesh& mesh, double scale, double weld);

  std::vector<glm::dvec3> points;  ///< positions in metres, in the mesh's own space
  std::vector<Face> faces;         ///< faces in the mesh's order
  std::vector<unsigned> vertexOf;  ///< maps each vertex of the mesh to its vertex here

  /// Faces around each vertex in ascending order: vertex i has the faces around[starts[i]] to
  /// around[starts[i + 1]] (exclusive).
  std::vector<unsigned> starts, around;

  /// Makes faces neighbours if the ends of their border edges are sewn together by `stitches` (pairs of
  /// vertices), as if the cloth were continuous there. Returns the number of pairs that face opposite ways
  /// and cannot be joined.
  int sew(const std::vector<std::pair<unsigned, unsigned>>& stitches);
  /// Returns the first of all vertices that `vertex` is sewn to, itself included.
  [[nodiscard]] unsigned firstOf(unsigned vertex) const { return sewn_.empty() ? vertex : sewn_[vertex]; }
  /// Returns the side of the neighbour beyond `side` that touches the face.
  [[nodiscard]] std::size_t sideBeyond(unsigned face, std::size_t side) const;

 private:
  void join(const std::string& name);
  void gather(const std::string& name);

  std::vector<unsigned> sewn_;  ///< first vertex of each sewn group; empty if nothing is sewn
};

/// Returns the edges around the vertices that are drawn.
[[nodiscard]] ClothEdges edgesOf(const ClothTriangles& cloth);

/// Returns a greedy colouring of the faces, colours from 0 on. Faces of one colour share no vertex, so they
/// can be moved in parallel.
[[nodiscard]] std::vector<int> colourFaces(const ClothTriangles& cloth);

}  // namespace simreel::sim
