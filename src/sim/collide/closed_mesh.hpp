#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <array>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// A mesh that encloses space: what is inside is known everywhere.
class ClosedMesh {
 public:
  /// Positions are multiplied by `scale`; those that are equal are one. A mesh that is turned inside out is
  /// turned round. Throws UserError(usage), `name` in its message, unless each edge has two faces that are
  /// turned alike, and where there is no space within.
  ClosedMesh(const std::string& name, const Mesh& mesh, float scale);

  /// A face that has an area: its corners (m), and as unit vectors its normal, those of the edges ab, bc
  /// and ca (the sum of both faces' normals) and of the corners (of all faces around, by their angles).
  struct Face {
    std::array<glm::vec3, 3> corners;
    std::array<glm::vec3, 7> normals;
  };
  std::vector<Face> faces;
  glm::dvec3 low{0}, high{0};  ///< m, around it
  double volume = 0;           ///< m^3
  double area = 0;             ///< m^2
};

}  // namespace simreel::sim
