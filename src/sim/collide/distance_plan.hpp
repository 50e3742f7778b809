#pragma once
#include "sim/collide/closed_mesh.hpp"

#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Input data and layout of a mesh's distance field, for the kernels in glsl/collide/distance. The CPU
/// reference uses it, too.
struct DistancePlan {
  /// `cellsAlong` is the number of cells along the longest side. If it is 0, there are 64, or more for thin
  /// meshes: the cell width is then a quarter of the mean thickness 2 volume / area, with at most 256 cells
  /// along the side and two million cells in total. The field extends beyond the mesh by `reach` (metres)
  /// and two cells. Throws the errors of ClosedMesh, and UserError(usage) for more than four million grid
  /// nodes. Warns if cells are wider than the mesh is thick.
  DistancePlan(const std::string& name, const Mesh& mesh, float scale, int cellsAlong, double reach);

  std::vector<glm::vec4> faces;  ///< faces, sorted by leaf, with faceElements elements per face
  std::vector<glm::vec4> boxes;  ///< boxes of the bounding volume tree, two elements per box; the first two
                                 ///< elements are unused
  int firstLeaf = 1;             ///< index of the first leaf's box
  glm::vec3 corner{0};           ///< corner of the first cell in metres, in the mesh's local space
  glm::ivec3 cells{0};
  float cell = 0;  ///< side length of a cell in metres
  float unit = 0;  ///< length in metres of one unit of the integers that store distances

  [[nodiscard]] int cellCount() const { return cells.x * cells.y * cells.z; }
  [[nodiscard]] int nodeCount() const { return (cells.x + 1) * (cells.y + 1) * (cells.z + 1); }

 private:
  void plantTree(const std::vector<ClosedMesh::Face>& from);
};

}  // namespace simreel::sim
