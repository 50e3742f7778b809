#pragma once
#include "sim/garment/membrane.hpp"
#include "sim/garment/triangles.hpp"

#include <vector>

namespace simreel::sim {

/// Long-range attachments (Kim, Chentanez, Mueller 2012): a vertex is no farther from a pin than the cloth
/// between them is long and stretches. Faces that are relaxed once a substep carry a load over a few of
/// them only, however they are coloured; these feel the pin in the same substep, without any order among
/// them, and are slack in whatever the cloth does without being stretched: they pull only.
struct Attachment {
  unsigned vertex, pin;
  double length;      ///< m, the shortest way over the cloth at rest
  double compliance;  ///< m/N
};

/// m: of each vertex the shortest way over its piece to what is pinned, and the pin at which it ends;
/// infinite where none is.
struct WaysToPins {
  std::vector<double> lengths;
  std::vector<unsigned> pins;
};
/// By fronts that pass over the faces, exact in a plane from a straight row of pins and, but for the first
/// ring, from a single one.
[[nodiscard]] WaysToPins waysToPins(const ClothTriangles& cloth, const std::vector<bool>& pinned);

/// Those of cloth whose faces are relaxed once in `seconds`. The stiffness of an attachment is what the
/// faces lack of the fabric's: of all that hangs on a pin, a front at the distance s carries M(s), the mass
/// beyond, over its width b(s), so under its weight the vertex at d is lowered by g U(d) / k, U = integral
/// of M / b from 0 to d; with k_e <= k of the faces (stiffnessOf) the attachment carries the rest of the
/// vertex' weight there, m (1 - k_e / k) g: its compliance is U / (k m (1 - k_e / k)). That is exact for
/// rows hanging straight, whatever pulls them; k is along the way, the bias by shear. None where faces do
/// without.
[[nodiscard]] std::vector<Attachment> attachmentsOf(const ClothTriangles& cloth,
                                                    const std::vector<bool>& pinned,
                                                    const std::vector<MembraneElement>& membrane,
                                                    const std::vector<double>& masses,
                                                    const shader::FabricConstants& fabric, double seconds);

}  // namespace simreel::sim
