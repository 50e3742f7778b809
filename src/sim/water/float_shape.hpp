#pragma once
#include "sim/collide/closed_mesh.hpp"

#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Contact shape of a floating body in its local space, relative to the centre of mass. It is either a
/// sphere or a lattice of signed distances to the body's surface, with probe points on the surface.
/// Computed in double arithmetic without libm.
struct FloatShape {
  FloatShape() = default;
  /// Creates a sphere of the given radius in metres.
  explicit FloatShape(double radius);
  /// Creates the lattice and probes of a closed mesh. `middle` is the centre of mass in mesh coordinates.
  FloatShape(const ClosedMesh& mesh, const glm::dvec3& middle);

  double radius = 0;              ///< Radius in metres of a sphere; 0 for a mesh.
  std::vector<glm::vec4> probes;  ///< Probe points: xyz is the position, w the probe's radius (0 on a
                                  ///< mesh), in metres.
  /// Lattice nodes, x fastest: xyz is the unit normal at the nearest point of the surface, w the signed
  /// distance (metres), negative inside.
  std::vector<glm::vec4> nodes;
  glm::dvec3 low{0};  ///< Position of the first node in metres.
  double step = 1;    ///< Distance between nodes in metres.
  glm::ivec3 counts{0};
};

/// Point of a face nearest to `p`, and the pseudonormal at that point (Baerentzen and Aanaes 2005). The
/// sign of the dot product of the pseudonormal and the vector from the point to `p` tells whether `p` is
/// outside the mesh.
struct NearestOnFace {
  glm::dvec3 place{0}, normal{0};
};
[[nodiscard]] NearestOnFace nearestOnFace(const ClosedMesh::Face& face, const glm::dvec3& p);

}  // namespace simreel::sim
