#pragma once
#include "sim/collide/closed_mesh.hpp"

#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// What a mesh's field of distances is made of and from, decided on the CPU; shared with the CPU twin. The
/// kernels are those of glsl/collide/distance.
struct DistancePlan {
  /// `cellsAlong` of its longest side; 0: 64, and more for what is thin, until a quarter of the mean
  /// thickness 2 volume / area is a cell, up to 256 and to two million cells in all. The field reaches
  /// `reach` (m) and two cells beyond the mesh. Throws what ClosedMesh throws, and UserError(usage) for
  /// more than four million corners of cells; warns where cells are wider than the mesh is thick.
  DistancePlan(const std::string& name, const Mesh& mesh, float scale, int cellsAlong, double reach);

  std::vector<glm::vec4> faces;  ///< faceElements of each, leaf by leaf
  std::vector<glm::vec4> boxes;  ///< two of each box of the tree, the first of them for none
  int firstLeaf = 1;             ///< of the boxes
  glm::vec3 corner{0};           ///< m, of the first cell, in the mesh's own space
  glm::ivec3 cells{0};
  float cell = 0;  ///< side, m
  float unit = 0;  ///< m, of the whole numbers in which distances are kept

  [[nodiscard]] int cellCount() const { return cells.x * cells.y * cells.z; }
  [[nodiscard]] int nodeCount() const { return (cells.x + 1) * (cells.y + 1) * (cells.z + 1); }

 private:
  void plantTree(const std::vector<ClosedMesh::Face>& from);
};

}  // namespace simreel::sim
