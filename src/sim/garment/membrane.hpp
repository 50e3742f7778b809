#pragma once
#include "sim/cloth/parameters.hpp"
#include "sim/garment/triangles.hpp"

#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Stretch and shear of one face of a mesh (glsl/garment/membrane.glsl).
struct MembraneElement {
  double p, q, r, s;  ///< coefficients in 1/m: fu = (b - a) p + (c - a) q, fv = (b - a) r + (c - a) s
  double area;        ///< area in m^2
};

/// Returns one element per face. Weft runs along u, warp perpendicular to it in the face's plane. Without
/// usable uv, weft runs along the mesh's x axis, or along z for faces perpendicular to x.
[[nodiscard]] std::vector<MembraneElement> membraneElements(const ClothTriangles& cloth, const Mesh& mesh);

/// Deformation of a face.
struct FaceStrain {
  double weft, warp;  ///< lengths along weft and warp as ratios to the rest lengths
  double shear;       ///< sine of the shear angle
};
[[nodiscard]] FaceStrain strainOf(const MembraneElement& element, const glm::dvec3& a, const glm::dvec3& b,
                                  const glm::dvec3& c);

/// Stiffnesses of a face in N/m.
struct FaceStiffness {
  double weft, warp, shear;
};
/// Returns the effective stiffness of a face whose constraints are relaxed forward and back once in
/// `seconds`: 1 / (1 / k + A S h^2 / 2), where h is constraintPart * seconds and S the sum of the corners'
/// inverse masses (1/kg) times their squared gradients. The stored energy follows from it. With 0 seconds
/// it is the fabric's stiffness.
[[nodiscard]] FaceStiffness stiffnessOf(const MembraneElement& element,
                                        const shader::FabricConstants& fabric,
                                        const glm::dvec3& inverseMasses, double seconds);

/// Returns the `seconds` argument of stiffnessOf() for a substep. Faces of cloth that keeps energy are
/// softer, 1 / (1 / k + softening A S dt^2), so the result is longer than the substep.
[[nodiscard]] double softeningSeconds(const ClothParameters& parameters, double seconds);

/// Returns E = A / 2 (weft (l - 1)^2 + warp (m - 1)^2 + shear s^2) in J.
[[nodiscard]] double membraneEnergy(const MembraneElement& element, const FaceStiffness& stiffness,
                                    const FaceStrain& strain);

}  // namespace simreel::sim
