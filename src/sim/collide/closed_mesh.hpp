#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <array>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Mesh that encloses a volume, so that inside and outside are defined everywhere.
class ClosedMesh {
 public:
  /// Multiplies positions by `scale` and merges equal positions. Flips a mesh whose faces point inwards.
  /// Throws UserError(usage), naming `name`, unless each edge has exactly two consistently oriented faces
  /// and the mesh encloses a volume.
  ClosedMesh(const std::string& name, const Mesh& mesh, float scale);

  /// Face with a nonzero area: its corners (metres) and seven unit normals. They are the normals of the
  /// face, of the edges ab, bc and ca (sums of both faces' normals), and of the corners (sums over the
  /// surrounding faces, weighted by angle).
  struct Face {
    std::array<glm::vec3, 3> corners;
    std::array<glm::vec3, 7> normals;
  };
  std::vector<Face> faces;
  glm::dvec3 low{0}, high{0};  ///< bounds in metres
  double volume = 0;           ///< enclosed volume in m^3
  double area = 0;             ///< surface area in m^2
};

}  // namespace simreel::sim
