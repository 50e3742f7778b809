#pragma once
#include "sim/garment/triangles.hpp"

#include <cstddef>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// The second derivatives of a face, as sums over the vertices around it: each of x, y and z of a vertex by
/// itself. They are those of the quadratic that fits the face's corners and the three of its neighbours,
/// which are laid into its plane at rest; so they are exact where the cloth is bent to a quadratic, on any
/// mesh. Where six points lie on a conic, or almost, the next ones are fitted too, by least squares.
/// Beyond a border nothing bends: there the second derivative across it is 0 (a plate's natural border, nu
/// = 0), of a corner both, which leaves its twist.
struct PlateElement {
  struct Part {
    unsigned vertex;
    glm::dvec3 weights;  ///< 1/m^2, of xx, yy and sqrt(2) xy in axes of the face's own
  };
  std::vector<Part> parts;  ///< in a fixed order, the corners first; none: a face by itself
  double area = 0;          ///< m^2
};

/// An edge of a border across which the cloth's direction is held: by a point that is pinned beyond it,
/// `reach` (m) out of the edge's middle in the face's plane at rest.
struct ClampedEdge {
  unsigned face;
  std::size_t side;
  unsigned ghost;  ///< its number, after those of the vertices
  double reach;
};

/// One for each face. The cloth is flat at rest whatever the mesh is: what is curved there is bent. At a
/// clamped edge the derivative across it is that towards its ghost.
[[nodiscard]] std::vector<PlateElement> plateElements(const ClothTriangles& cloth,
                                                      const std::vector<ClampedEdge>& clamps = {});

/// E = 1/2 sum D A |H|^2 with |H|^2 = |xx|^2 + |yy|^2 + 2 |xy|^2, J; `bending` D in N m.
[[nodiscard]] double plateEnergy(const std::vector<PlateElement>& elements, double bending,
                                 const std::vector<glm::dvec3>& points);

/// Of a row of the energy's matrix K, E = 1/2 sum K_ij x_i.x_j: what else than i itself, by vertex.
using PlateRow = std::vector<std::pair<unsigned, double>>;

/// The rows of D sum A H H^T, N/m. So that an explicit step stays stable, the elements around a vertex are
/// softened until the row's sum of magnitudes times the vertex' inverse mass (1/kg) is at most
/// `mostSquaredFrequency` (1/s^2), a bound of all frequencies (Gershgorin). `softened` counts those
/// elements.
struct PlateMatrix {
  PlateMatrix(const std::vector<PlateElement>& elements, double bending,
              const std::vector<double>& inverseMasses, double mostSquaredFrequency);
  std::vector<PlateRow> rows;
  std::vector<double> stiffnesses;  ///< N m, of each element
  int softened = 0;
};

/// The bound on squared frequencies (1/s^2) that the given share of what bends keeps to: 1 for all of it.
[[nodiscard]] double plateFrequencySquared(const std::vector<PlateElement>& elements, double bending,
                                           const std::vector<double>& inverseMasses, double share);

}  // namespace simreel::sim
