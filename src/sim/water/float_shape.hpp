#pragma once
#include "sim/collide/closed_mesh.hpp"

#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// What other floats touch of a float, in its own space, from its middle of mass: a sphere, or signed
/// distances to its surface on a lattice, and probes spread over that. Made in double arithmetic without
/// libm.
struct FloatShape {
  FloatShape() = default;
  /// A sphere (m).
  explicit FloatShape(double radius);
  /// A closed mesh; `middle`: of the mass, in its coordinates.
  FloatShape(const ClosedMesh& mesh, const glm::dvec3& middle);

  double radius = 0;              ///< m, of a sphere; 0: a mesh
  std::vector<glm::vec4> probes;  ///< place (m), radius (m)
  /// x fastest: the unit normal of the nearest place of the surface, distance (m), negative within.
  std::vector<glm::vec4> nodes;
  glm::dvec3 low{0};  ///< m: of the first node
  double step = 1;    ///< m between nodes
  glm::ivec3 counts{0};
};

/// The place of a face that is nearest to `p`, and the pseudonormal there (Baerentzen and Aanaes 2005): the
/// side of it that p is on is the side of the mesh.
struct NearestOnFace {
  glm::dvec3 place{0}, normal{0};
};
[[nodiscard]] NearestOnFace nearestOnFace(const ClosedMesh::Face& face, const glm::dvec3& p);

}  // namespace simreel::sim
