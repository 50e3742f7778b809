#pragma once
#include "sim/garment/membrane.hpp"
#include "sim/garment/triangles.hpp"

#include <vector>

namespace simreel::sim {

/// Long-range attachment (Kim, Chentanez, Mueller 2012): limits the distance of a vertex from a pin to the
/// length of the cloth between them, plus the stretch of that cloth. Faces that are relaxed once per
/// substep carry a load over only a few faces, whatever their colouring. Attachments transfer the pin's
/// force within one substep and independently of each other. They only pull, so they are slack as long as
/// the cloth between vertex and pin is not stretched.
struct Attachment {
  unsigned vertex, pin;
  double length;      ///< length in metres of the shortest path over the undeformed cloth
  double compliance;  ///< compliance in m/N
};

/// For each vertex, the length in metres of the shortest path over its connected piece of cloth to a pinned
/// vertex, and the index of that pinned vertex. The length is infinite if the piece has no pinned vertex.
struct PathsToPins {
  std::vector<double> lengths;
  std::vector<unsigned> pins;
};
/// Computes the paths by fronts that propagate across faces. The result is exact in a plane for a straight
/// row of pins and, except for the first ring of vertices, for a single pin.
[[nodiscard]] PathsToPins waysToPins(const ClothTriangles& cloth, const std::vector<bool>& pinned);

/// Returns the attachments of a cloth whose faces are relaxed once per substep of `seconds`. An attachment
/// supplies the stiffness that the faces lack.
///
/// Consider the weight that hangs from a pin. The mass beyond the distance s from the pin is M(s), and it
/// is carried over the width b(s). With the gravity g and the stiffness k, the vertex at the distance d
/// sinks by g U(d) / k, where U is the integral of M / b from 0 to d. If the faces have the stiffness k_e
/// <= k (stiffnessOf), the attachment carries the remaining part of the weight of the vertex of mass m, m
/// (1 - k_e / k) g, so its compliance is U / (k m (1 - k_e / k)). That is exact for rows that hang straight
/// under any load. k is the stiffness along the path; on the bias, it includes shear. Vertices whose faces
/// are stiff enough get no attachment.
[[nodiscard]] std::vector<Attachment> attachmentsOf(const ClothTriangles& cloth,
                                                    const std::vector<bool>& pinned,
                                                    const std::vector<MembraneElement>& membrane,
                                                    const std::vector<double>& masses,
                                                    const shader::FabricConstants& fabric, double seconds);

}  // namespace simreel::sim
