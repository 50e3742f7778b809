#pragma once
#include "sim/garment/membrane.hpp"
#include "sim/garment/triangles.hpp"

#include <vector>

namespace simreel::sim {

/// Long-range attachments (Kim, Chentanez, Mueller 2012): limit the distance of a vertex from a pin to the
/// length of the cloth between them, plus its stretch. Faces that are relaxed once per substep carry a load
/// over only a few of them, whatever their colouring. Attachments transfer the pin's force within one
/// substep and independently of each other. They only pull, so they are slack as long as the cloth between
/// is not stretched.
struct Attachment {
  unsigned vertex, pin;
  double length;      ///< length of the shortest path over the cloth at rest in metres
  double compliance;  ///< compliance in m/N
};

/// Shortest path of each vertex over its piece to a pinned vertex (metres; infinite if the piece has no
/// pinned vertex), and that pinned vertex.
struct WaysToPins {
  std::vector<double> lengths;
  std::vector<unsigned> pins;
};
/// Computes the paths by fronts that propagate across faces. Exact in a plane for a straight row of pins
/// and, except for the first ring, for a single pin.
[[nodiscard]] WaysToPins waysToPins(const ClothTriangles& cloth, const std::vector<bool>& pinned);

/// Returns the attachments of a cloth whose faces are relaxed once per substep of `seconds`. An attachment
/// supplies the stiffness that its faces lack.
///
/// Of the weight that hangs on a pin, a front at the distance s carries M(s), the mass beyond it, over its
/// width b(s). Under its weight the vertex at distance d sinks by g U(d) / k, U = integral of M / b from 0
/// to d. If the faces have the stiffness k_e <= k (stiffnessOf), the attachment carries the rest of the
/// vertex' weight, m (1 - k_e / k) g, so its compliance is U / (k m (1 - k_e / k)). That is exact for rows
/// that hang straight under any load. k is the stiffness along the path, including shear for a path on the
/// bias. Vertices whose faces are stiff enough get no attachment.
[[nodiscard]] std::vector<Attachment> attachmentsOf(const ClothTriangles& cloth,
                                                    const std::vector<bool>& pinned,
                                                    const std::vector<MembraneElement>& membrane,
                                                    const std::vector<double>& masses,
                                                    const shader::FabricConstants& fabric, double seconds);

}  // namespace simreel::sim
