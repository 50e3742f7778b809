#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// A mesh as cloth needs it: vertices at one place are one, faces know their neighbours.
struct ClothTriangles {
  static constexpr unsigned none = 0xffffffffU;

  /// Corners counter-clockwise; edge k leads from corner k to the next one.
  struct Face {
    std::array<unsigned, 3> corners;
    std::array<unsigned, 3> neighbours;  ///< face beyond each edge; none: a border
    std::array<unsigned, 3> beyond;      ///< that face's third corner
    double area;                         ///< m^2
  };

  /// Vertices of the mesh no farther apart than `weld` (m) become one, with the place of the first; 0:
  /// those at the same place. Coordinates are multiplied with `scale`. Throws UserError(usage), with `name`
  /// and the place, for an edge of more than two faces, neighbours that do not face the same way, a face
  /// without area, a vertex without faces or of more than 256.
  ClothTriangles(const std::string& name, const Mesh& mesh, double scale, double weld);

  std::vector<glm::dvec3> points;  ///< m, in the mesh's own space
  std::vector<Face> faces;         ///< in the order of the mesh
  std::vector<unsigned> vertexOf;  ///< of each vertex of the mesh: its vertex here

  /// Faces around each vertex, in their order: of vertex i from around[starts[i]] to around[starts[i + 1]].
  std::vector<unsigned> starts, around;

  /// Makes neighbours of the faces at border edges whose ends are sewn together by `stitches` of two
  /// vertices, as of cloth that has grown together there. Returns how many pairs of faces cannot be: they
  /// face opposite ways.
  int sew(const std::vector<std::pair<unsigned, unsigned>>& stitches);
  /// Of those that a vertex is sewn to, with itself, the first.
  [[nodiscard]] unsigned firstOf(unsigned vertex) const { return sewn_.empty() ? vertex : sewn_[vertex]; }
  /// The side of a face's neighbour beyond `side` at which that has the face.
  [[nodiscard]] std::size_t sideBeyond(unsigned face, std::size_t side) const;

 private:
  void join(const std::string& name);
  void gather(const std::string& name);

  std::vector<unsigned> sewn_;  ///< empty: nothing is
};

/// Which faces may be moved at once: a colour for each, no two of a colour sharing a vertex, by the first
/// that is free. Returns their colours, from 0 on.
[[nodiscard]] std::vector<int> colourFaces(const ClothTriangles& cloth);

}  // namespace simreel::sim
