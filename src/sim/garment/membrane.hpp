#pragma once
#include "sim/cloth/parameters.hpp"
#include "sim/garment/triangles.hpp"

#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// The faces of a mesh as pieces of a fabric (glsl/garment/membrane.glsl).
struct MembraneElement {
  double p, q, r, s;  ///< 1/m: fu = (b - a) p + (c - a) q, fv = (b - a) r + (c - a) s
  double area;        ///< m^2
};

/// Weft runs along u, warp across it in the face's plane; where the mesh has no uv, or a face none of its
/// own, weft along the mesh's x, of faces that x leaves along z.
[[nodiscard]] std::vector<MembraneElement> membraneElements(const ClothTriangles& cloth, const Mesh& mesh);

/// How a face is deformed.
struct FaceStrain {
  double weft, warp;  ///< lengths as ratios to rest
  double shear;       ///< sine of the angle
};
[[nodiscard]] FaceStrain strainOf(const MembraneElement& element, const glm::dvec3& a, const glm::dvec3& b,
                                  const glm::dvec3& c);

/// N/m.
struct FaceStiffness {
  double weft, warp, shear;
};
/// What a face resists with where constraints are relaxed there and back once in `seconds`: 1 / (1 / k + A
/// S h^2 / 2), h being constraintPart of these, S the sum of its corners' inverse masses (1/kg) times the
/// squares of its gradients. That is what it stores energy by; with 0 s what the fabric says.
[[nodiscard]] FaceStiffness stiffnessOf(const MembraneElement& element,
                                        const shader::FabricConstants& fabric,
                                        const glm::dvec3& inverseMasses, double seconds);

/// What to give stiffnessOf for the seconds of a substep: of cloth that keeps energy a face is softer,
/// 1 / (1 / k + softening A S dt^2).
[[nodiscard]] double softeningSeconds(const ClothParameters& parameters, double seconds);

/// E = A / 2 (weft (l - 1)^2 + warp (m - 1)^2 + shear s^2), J.
[[nodiscard]] double membraneEnergy(const MembraneElement& element, const FaceStiffness& stiffness,
                                    const FaceStrain& strain);

}  // namespace simreel::sim
