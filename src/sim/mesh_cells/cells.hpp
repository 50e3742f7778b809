#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// The vertices of a mesh as cells: those at one place are one cell, so seams of texture coordinates or
/// creases are none here. A cell's area is a third of the faces around it. Between neighbours, which share
/// an edge, what flows is (u_j - u_i) times the length of the border between their cells over the distance
/// of the vertices: half the sum of the cotangents of the angles across the edge (Pinkall and Polthier
/// 1993), the border of circumcentric cells. That operator is exact for what is linear in a plane, on a
/// grid of right triangles it is the five-point one, and it keeps the sum of area times u, on open meshes
/// too, whose borders nothing crosses. Faces as cells would want centres whose distances are at right
/// angles to edges, which most meshes do not have.
struct MeshCells {
  struct Link {
    int neighbour = 0;
    double weight = 0;  ///< border over distance; 0 across a square's diagonal
  };
  std::vector<int> cellOf;         ///< of each vertex of the mesh
  std::vector<glm::dvec3> places;  ///< m, of the cells
  std::vector<double> areas;       ///< m^2
  std::vector<int> first;          ///< of each cell, and the end
  std::vector<Link> links;         ///< of a cell by the numbers of its neighbours
  double meanEdge = 1;             ///< m
  glm::dvec3 low{0}, high{0};      ///< m: their box

  [[nodiscard]] int count() const { return static_cast<int>(areas.size()); }
};

/// Vertices that no face has are cells of nothing. Throws UserError(inputOutput) for a mesh whose faces
/// have no area; `whose`: "reaction \"x\"".
[[nodiscard]] MeshCells cellsOf(const Mesh& mesh, const std::string& whose);

/// Loop's subdivision: every face becomes four and the whole smoother; borders stay borders. Seams are
/// closed, so it has neither texture coordinates nor materials; normals are those of the limit surface's
/// neighbourhood, by area.
[[nodiscard]] Mesh refined(const Mesh& mesh);

}  // namespace simreel::sim
