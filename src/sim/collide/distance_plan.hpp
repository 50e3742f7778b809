#pragma once
#include "sim/collide/closed_mesh.hpp"

#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Input data and layout of a mesh's distance field, for the kernels in glsl/collide/distance; the CPU
/// reference shares it.
struct DistancePlan {
  /// `cellsAlong`: number of cells along the longest side; 0 means automatic: 64, or more for thin meshes,
  /// until a cell is a quarter of the mean thickness 2 volume / area, at most 256 and two million cells in
  /// total. The field extends `reach` (m) and two cells beyond the mesh. Throws the errors of ClosedMesh,
  /// and UserError(usage) for more than four million grid nodes. Warns if cells are wider than the mesh is
  /// thick.
  DistancePlan(const std::string& name, const Mesh& mesh, float scale, int cellsAlong, double reach);

  std::vector<glm::vec4> faces;  ///< faces, sorted by leaf; faceElements elements each
  std::vector<glm::vec4> boxes;  ///< boxes of the tree (BVH), two elements each; the first pair is unused
  int firstLeaf = 1;             ///< index of the first leaf's box
  glm::vec3 corner{0};           ///< corner of the first cell in metres, in the mesh's own space
  glm::ivec3 cells{0};
  float cell = 0;  ///< side length of a cell in metres
  float unit = 0;  ///< metres per unit of the integers that store distances

  [[nodiscard]] int cellCount() const { return cells.x * cells.y * cells.z; }
  [[nodiscard]] int nodeCount() const { return (cells.x + 1) * (cells.y + 1) * (cells.z + 1); }

 private:
  void plantTree(const std::vector<ClosedMesh::Face>& from);
};

}  // namespace simreel::sim
