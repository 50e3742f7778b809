#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Cells at the vertices of a mesh. Vertices at one position form one cell, so seams of texture coordinates
/// and creases do not separate cells. A cell's area is a third of the surrounding faces.
///
/// The flow between neighbours, which share an edge, is (u_j - u_i) times the length of the border between
/// their cells over the distance of the vertices: half the sum of the cotangents of the angles opposite to
/// the edge (Pinkall and Polthier 1993), the border of circumcentric cells. This operator is exact for
/// functions linear in a plane, equals the five-point operator on a grid of right triangles, and conserves
/// the sum of area times u, also on open meshes, whose borders no flow crosses. Cells at faces would need
/// centres whose connections are perpendicular to the edges, which most meshes do not have.
struct MeshCells {
  struct Link {
    int neighbour = 0;
    double weight = 0;  ///< border length over distance; 0 across a square's diagonal
  };
  std::vector<int> cellOf;         ///< cell of each vertex of the mesh; -1: none
  std::vector<glm::dvec3> places;  ///< positions of the cells in metres
  std::vector<double> areas;       ///< area of each cell in m^2
  std::vector<int> first;          ///< per cell: index of its first link; then the total number of links
  std::vector<Link> links;         ///< links of a cell, sorted by neighbour
  double meanEdge = 1;             ///< mean length of the edges in metres
  glm::dvec3 low{0}, high{0};      ///< bounds in metres

  [[nodiscard]] int count() const { return static_cast<int>(areas.size()); }
};

/// Returns the cells of a mesh. Vertices without a face get no cell. Throws UserError(inputOutput) if no
/// face has an area; `whose` names the object in the message, for example "reaction \"x\"".
[[nodiscard]] MeshCells cellsOf(const Mesh& mesh, const std::string& whose);

/// Returns the mesh after one step of Loop subdivision: each face becomes four and the surface smoother;
/// borders remain borders. Seams are closed, so the result has neither texture coordinates nor materials.
/// Normals are averages of the refined faces' normals, weighted by area.
[[nodiscard]] Mesh refined(const Mesh& mesh);

}  // namespace simreel::sim
