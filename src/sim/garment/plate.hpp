#pragma once
#include "sim/garment/triangles.hpp"

#include <cstddef>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Second derivatives of a face as linear combinations of the surrounding vertices, with the same
/// coefficients for x, y and z. A quadratic is fitted to the corners of the face and to the third corners
/// of its three neighbours, unfolded into the face's rest plane. The derivatives are therefore exact on any
/// mesh if the cloth is bent to a quadratic. If the six points lie on a conic, or nearly so, the next
/// points are added and the fit uses least squares. At a border, the second derivative across the border is
/// 0 (natural boundary of a plate with Poisson's ratio 0). At a corner of the cloth, both are 0, and only
/// the twist remains.
struct PlateElement {
  struct Part {
    unsigned vertex;
    glm::dvec3 weights;  ///< weights of the derivatives xx, yy and sqrt(2) xy in the axes of the face, in
                         ///< 1/m^2
  };
  std::vector<Part> parts;  ///< parts in a fixed order, corners first; empty for a face without neighbours
  double area = 0;          ///< area in m^2
};

/// Border edge at which a pinned ghost point fixes the direction of the cloth across the edge. The ghost is
/// outside the middle of the edge at the distance `reach` (metres), in the face's rest plane.
struct ClampedEdge {
  unsigned face;
  std::size_t side;
  unsigned ghost;  ///< vertex index of the ghost point; ghost points follow the vertices
  double reach;
};

/// Returns one element per face. The energy is zero when the cloth is flat, whatever the shape of the mesh,
/// so a curved mesh starts bent. At a clamped edge, the derivative across the edge is taken towards the
/// ghost point.
[[nodiscard]] std::vector<PlateElement> plateElements(const ClothTriangles& cloth,
                                                      const std::vector<ClampedEdge>& clamps = {});

/// Returns the energy E = 1/2 sum D A |H|^2 in J, where A is the area of an element, |H|^2 = |xx|^2 +
/// |yy|^2 + 2 |xy|^2, and D is `bending` in N m.
[[nodiscard]] double plateEnergy(const std::vector<PlateElement>& elements, double bending,
                                 const std::vector<glm::dvec3>& points);

/// Off-diagonal entries (vertex j, K_ij) of row i of the matrix K of the energy E = 1/2 sum K_ij x_i.x_j.
using PlateRow = std::vector<std::pair<unsigned, double>>;

/// The rows of K = sum D A H H^T in N/m. To keep an explicit step stable, the elements around a vertex are
/// softened until the sum of the magnitudes in the vertex' row, times its inverse mass (1/kg), is at most
/// `maxSquaredFrequency` (1/s^2). This sum is an upper bound of all squared frequencies (Gershgorin).
/// `softened` is the number of softened elements.
struct PlateMatrix {
  PlateMatrix(const std::vector<PlateElement>& elements, double bending,
              const std::vector<double>& inverseMasses, double maxSquaredFrequency);
  std::vector<PlateRow> rows;
  std::vector<double> stiffnesses;  ///< bending stiffness of each element in N m
  int softened = 0;
};

/// Returns a bound (1/s^2) for the squared bending frequencies of the given fraction `share` of the
/// vertices; 1 stands for all vertices.
[[nodiscard]] double plateFrequencySquared(const std::vector<PlateElement>& elements, double bending,
                                           const std::vector<double>& inverseMasses, double share);

}  // namespace simreel::sim
