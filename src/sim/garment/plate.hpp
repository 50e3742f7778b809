#pragma once
#include "sim/garment/triangles.hpp"

#include <cstddef>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Second derivatives of a face as linear combinations of the surrounding vertices, the same for x, y and
/// z. A quadratic is fitted to the corners of the face and the third corners of its three neighbours,
/// unfolded into the face's rest plane. The derivatives are therefore exact on any mesh if the cloth is
/// bent to a quadratic. If the six points lie on a conic, or nearly so, the next ones join a least-squares
/// fit. At a border the second derivative across it is 0 (natural boundary of a plate, nu = 0). At a corner
/// both are 0, which leaves the twist.
struct PlateElement {
  struct Part {
    unsigned vertex;
    glm::dvec3 weights;  ///< 1/m^2; weights of xx, yy and sqrt(2) xy in axes of the face
  };
  std::vector<Part> parts;  ///< in a fixed order, the corners first; empty for a face without neighbours
  double area = 0;          ///< area in m^2
};

/// Border edge across which the direction of the cloth is held by a pinned ghost point. The ghost lies
/// outside the middle of the edge at the distance `reach` (metres), in the face's rest plane.
struct ClampedEdge {
  unsigned face;
  std::size_t side;
  unsigned ghost;  ///< its vertex index; ghosts follow the vertices
  double reach;
};

/// Returns one element per face. The cloth is flat at rest whatever the mesh's shape, so a curved mesh
/// starts bent. At a clamped edge the derivative across it points towards its ghost.
[[nodiscard]] std::vector<PlateElement> plateElements(const ClothTriangles& cloth,
                                                      const std::vector<ClampedEdge>& clamps = {});

/// Returns E = 1/2 sum D A |H|^2 with |H|^2 = |xx|^2 + |yy|^2 + 2 |xy|^2, in J; `bending` is D in N m.
[[nodiscard]] double plateEnergy(const std::vector<PlateElement>& elements, double bending,
                                 const std::vector<glm::dvec3>& points);

/// Off-diagonal entries (vertex j, K_ij) of one row of the energy's matrix K, E = 1/2 sum K_ij x_i.x_j.
using PlateRow = std::vector<std::pair<unsigned, double>>;

/// The rows of K = D sum A H H^T in N/m. To keep an explicit step stable, the elements around a vertex are
/// softened until the row's sum of magnitudes times the vertex' inverse mass (1/kg) is at most
/// `mostSquaredFrequency` (1/s^2), an upper bound of all squared frequencies (Gershgorin). `softened`
/// counts the softened elements.
struct PlateMatrix {
  PlateMatrix(const std::vector<PlateElement>& elements, double bending,
              const std::vector<double>& inverseMasses, double mostSquaredFrequency);
  std::vector<PlateRow> rows;
  std::vector<double> stiffnesses;  ///< bending stiffness of each element in N m
  int softened = 0;
};

/// Returns the bound (1/s^2) that the given share of the vertices' squared bending frequencies does not
/// exceed; share 1: all vertices.
[[nodiscard]] double plateFrequencySquared(const std::vector<PlateElement>& elements, double bending,
                                           const std::vector<double>& inverseMasses, double share);

}  // namespace simreel::sim
