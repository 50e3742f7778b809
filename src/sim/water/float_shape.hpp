#pragma once
#include "sim/collide/closed_mesh.hpp"

#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Contact shape of a floating body in its local space, relative to the centre of mass: either a sphere, or
/// a lattice of signed distances to its surface with probe points on the surface. Computed in double
/// arithmetic without libm.
struct FloatShape {
  FloatShape() = default;
  /// Sphere of the given radius in metres.
  explicit FloatShape(double radius);
  /// Closed mesh. `middle`: centre of mass in mesh coordinates.
  FloatShape(const ClosedMesh& mesh, const glm::dvec3& middle);

  double radius = 0;              ///< Radius in metres of a sphere; 0 for a mesh.
  std::vector<glm::vec4> probes;  ///< Position (metres) in xyz, radius (metres) in w.
  /// Lattice nodes, x fastest: xyz is the unit normal at the nearest point of the surface, w the signed
  /// distance (metres), negative inside.
  std::vector<glm::vec4> nodes;
  glm::dvec3 low{0};  ///< Position of the first node in metres.
  double step = 1;    ///< Distance between nodes in metres.
  glm::ivec3 counts{0};
};

/// Point of a face nearest to `p`, and the pseudonormal at that point (Baerentzen and Aanaes 2005): the
/// sign of its dot product with the offset to `p` tells whether `p` is outside the mesh.
struct NearestOnFace {
  glm::dvec3 place{0}, normal{0};
};
[[nodiscard]] NearestOnFace nearestOnFace(const ClosedMesh::Face& face, const glm::dvec3& p);

}  // namespace simreel::sim
