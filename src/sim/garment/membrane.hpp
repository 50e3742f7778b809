#pragma once
#include "sim/cloth/parameters.hpp"
#include "sim/garment/triangles.hpp"

#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Stretch and shear of one face of a mesh (glsl/garment/membrane.glsl).
struct MembraneElement {
  double p, q, r, s;  ///< coefficients in 1/m of the deformation gradient of a face a, b, c: fu = (b - a) p
                      ///< + (c - a) q, fv = (b - a) r + (c - a) s
  double area;        ///< area in m^2
};

/// Returns one element per face. The weft runs along u, and the warp perpendicular to it in the plane of
/// the face. If the uv cannot be used, the weft runs along the mesh's x axis, or along z for faces
/// perpendicular to x.
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
/// `seconds`: 1 / (1 / k + A S h^2 / 2), where k is the fabric's stiffness, A the face's area, h is
/// constraintPart * seconds, and S is the sum over the corners of the inverse mass (1/kg) times the squared
/// gradient. The stored energy is computed with it. If `seconds` is 0, it is the fabric's stiffness.
[[nodiscard]] FaceStiffness stiffnessOf(const MembraneElement& element,
                                        const shader::FabricConstants& fabric,
                                        const glm::dvec3& inverseMasses, double seconds);

/// Returns the argument `seconds` of stiffnessOf() for a substep. Faces of cloth that keeps energy are
/// softer, with 1 / (1 / k + softening A S dt^2), so for them the result is longer than the substep.
[[nodiscard]] double softeningSeconds(const ClothParameters& parameters, double seconds);

/// Returns the energy A / 2 (weft (l - 1)^2 + warp (m - 1)^2 + shear s^2) in J, with the area A, the length
/// ratios l and m along weft and warp, and the sine s of the shear angle.
[[nodiscard]] double membraneEnergy(const MembraneElement& element, const FaceStiffness& stiffness,
                                    const FaceStrain& strain);

}  // namespace simreel::sim
