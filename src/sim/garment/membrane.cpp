#include "sim/garment/membrane.hpp"

#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace simreel::sim {

namespace {

/// Returns a weft direction in the plane perpendicular to the unit normal `n`; its length is arbitrary but
/// not 0.
glm::dvec3 weftWithoutUv(const glm::dvec3& n) {
  const glm::dvec3 x(1, 0, 0);
  const glm::dvec3 along = x - n * n.x;
  return glm::dot(along, along) > 0.01 ? along : glm::dvec3(0, 0, 1) - n * n.z;
}

/// Returns a multiple of dP/du of a face, or 0 if the uv are degenerate.
glm::dvec3 weftOfUv(const glm::dvec3& b, const glm::dvec3& c, glm::dvec2 ub, glm::dvec2 uc) {
  const double det = ub.x * uc.y - ub.y * uc.x;
  const double size = std::abs(ub.x * uc.y) + std::abs(ub.y * uc.x);
  if (!(std::abs(det) > 1e-6 * size) || !(std::abs(det) > 1e-20)) return glm::dvec3(0);
  return (b * uc.y - c * ub.y) * (det > 0 ? 1.0 : -1.0);
}

}  // namespace

std::vector<MembraneElement> membraneElements(const ClothTriangles& cloth, const Mesh& mesh) {
  std::vector<MembraneElement> elements;
  elements.reserve(cloth.faces.size());
  for (std::size_t f = 0; f < cloth.faces.size(); ++f) {
    const ClothTriangles::Face& face = cloth.faces[f];
    const glm::dvec3 a = cloth.points[face.corners[0]];
    const glm::dvec3 b = cloth.points[face.corners[1]] - a;
    const glm::dvec3 c = cloth.points[face.corners[2]] - a;
    const glm::dvec3 n = glm::cross(b, c) / (2 * face.area);
    glm::dvec3 weft(0);
    if (!mesh.uvs.empty()) {
      const auto uv = [&](std::size_t k) { return glm::dvec2(mesh.uvs[mesh.indices[3 * f + k]]); };
      weft = weftOfUv(b, c, uv(1) - uv(0), uv(2) - uv(0));
    }
    if (weft == glm::dvec3(0)) weft = weftWithoutUv(n);
    weft /= std::sqrt(glm::dot(weft, weft));
    const glm::dvec3 warp = glm::cross(n, weft);
    const double bu = glm::dot(b, weft);
    const double bv = glm::dot(b, warp);
    const double cu = glm::dot(c, weft);
    const double cv = glm::dot(c, warp);
    const double det = bu * cv - bv * cu;
    elements.push_back({cv / det, -bv / det, -cu / det, bu / det, face.area});
  }
  return elements;
}

FaceStrain strainOf(const MembraneElement& element, const glm::dvec3& a, const glm::dvec3& b,
                    const glm::dvec3& c) {
  const glm::dvec3 fu = (b - a) * element.p + (c - a) * element.q;
  const glm::dvec3 fv = (b - a) * element.r + (c - a) * element.s;
  const double weft = std::sqrt(glm::dot(fu, fu));
  const double warp = std::sqrt(glm::dot(fv, fv));
  return {weft, warp, weft * warp > 0 ? glm::dot(fu, fv) / (weft * warp) : 0};
}

FaceStiffness stiffnessOf(const MembraneElement& element, const shader::FabricConstants& fabric,
                          const glm::dvec3& inverseMasses, double seconds) {
  const auto& [p, q, r, s, area] = element;
  const glm::dvec3 squaresU((p + q) * (p + q), p * p, q * q);
  const glm::dvec3 squaresV((r + s) * (r + s), r * r, s * s);
  const double reach = constraintPart * seconds;
  const double scale = 0.5 * area * reach * reach;
  const double weft = scale * glm::dot(inverseMasses, squaresU);
  const double warp = scale * glm::dot(inverseMasses, squaresV);
  return {1 / (1 / static_cast<double>(fabric.weft) + weft),
          1 / (1 / static_cast<double>(fabric.warp) + warp),
          1 / (1 / static_cast<double>(fabric.shear) + weft + warp)};
}

double softeningSeconds(const ClothParameters& parameters, double seconds) {
  return parameters.keepsEnergy() ? seconds * std::sqrt(2 * faceSoftening) / constraintPart : seconds;
}

double membraneEnergy(const MembraneElement& element, const FaceStiffness& stiffness,
                      const FaceStrain& strain) {
  return 0.5 * element.area *
         (stiffness.weft * (strain.weft - 1) * (strain.weft - 1) +
          stiffness.warp * (strain.warp - 1) * (strain.warp - 1) +
          stiffness.shear * strain.shear * strain.shear);
}

}  // namespace simreel::sim
