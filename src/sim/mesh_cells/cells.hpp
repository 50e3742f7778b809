#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Cells at the vertices of a mesh. Vertices at the same position form one cell, so seams of texture
/// coordinates and creases do not separate cells. A cell's area is a third of the area of the surrounding
/// faces.
///
/// Neighbours are cells whose vertices share an edge. The flow between the neighbours i and j is (u_j -
/// u_i) times the length of the border between their cells, divided by the distance of the vertices. For
/// circumcentric cells, this factor is half the sum of the cotangents of the angles opposite to the edge
/// (Pinkall and Polthier 1993). The operator is exact for linear functions in a plane, equals the
/// five-point operator on a grid of right triangles, and conserves the sum of area times u, also on open
/// meshes, across whose borders nothing flows. Cells at faces would need centres whose connecting lines are
/// perpendicular to the edges, which most meshes do not have.
struct MeshCells {
  struct Link {
    int neighbour = 0;
    double weight = 0;  ///< border length divided by distance; 0 across a square's diagonal
  };
  std::vector<int> cellOf;         ///< cell of each vertex of the mesh, or -1 for none
  std::vector<glm::dvec3> places;  ///< positions of the cells in metres
  std::vector<double> areas;       ///< area of each cell in m^2
  std::vector<int> first;          ///< for each cell, the index of its first link; the last entry is the
                                   ///< total number of links
  std::vector<Link> links;         ///< links of all cells, one cell after another, sorted by neighbour
  double meanEdge = 1;             ///< mean length of the edges in metres
  glm::dvec3 low{0}, high{0};      ///< bounds in metres

  [[nodiscard]] int count() const { return static_cast<int>(areas.size()); }
};

/// Returns the cells of a mesh. Vertices without a face get no cell. Throws UserError(inputOutput) if no
/// face has an area; `whose` names the object in the message, for example "reaction \"x\"".
[[nodiscard]] MeshCells cellsOf(const Mesh& mesh, const std::string& whose);

/// Returns the mesh after one step of Loop subdivision, which splits each face into four and smooths the
/// surface. Borders remain borders. Seams are closed, so the result has neither texture coordinates nor
/// materials. Normals are averages of the normals of the refined faces, weighted by area.
[[nodiscard]] Mesh refined(const Mesh& mesh);

}  // namespace simreel::sim
