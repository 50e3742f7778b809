#pragma once
#include "draw/exact/motion/motion.hpp"

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

/// World velocities of drawn objects, by primitive id. The velocity of a point on a surface is its
/// displacement since the previous frame, divided by the frame time. Instances have stored velocities.
class Velocities {
 public:
  /// `motion`: must have begun the frame (Motion::begin()). `seconds`: time between the two frames. `part`:
  /// interpolation parameter of the drawn moment (0 at the previous frame, 1 at the current one).
  Velocities(Motion& motion, double seconds, float part)
      : motion_(motion), seconds_(seconds), part_(static_cast<double>(part)) {}

  /// Adds surface i of the frame, with at most `triangles` ids from `firstId` on.
  void addSurface(const sim::Surface& surface, std::size_t i, unsigned firstId, int triangles);
  /// Adds instances i of the frame, with ids from `firstId` on and `each` ids per instance.
  void addInstances(std::size_t i, unsigned firstId, unsigned each);
  /// Returns the velocity (m/s) of the point at `place` (m) on the primitive with id `number`; 0 if the
  /// primitive does not move.
  [[nodiscard]] glm::vec3 at(unsigned number, const glm::dvec3& place) const;

 private:
  struct Mesh {
    unsigned firstId = 0, end = 0;
    glm::ivec2 row{0};  ///< for grids: triangles per row, and vertices from one row to the next; 0 for
                        ///< meshes with indices
    std::vector<unsigned> indices;
    Motion::Displacement way;
  };
  struct Cloud {
    unsigned firstId = 0, each = 1;
    std::vector<glm::vec4> velocities;
  };
  [[nodiscard]] glm::vec3 onMesh(const Mesh& mesh, unsigned triangle, const glm::dvec3& place) const;

  Motion& motion_;
  double seconds_, part_;
  std::vector<Mesh> meshes_;
  std::vector<Cloud> clouds_;
};

/// Returns the barycentric weights of a point of the triangle (a, b, c): the point nearest to the
/// projection of `place` onto the triangle's plane. Each weight is 0 to 1, and their sum is 1. For
/// degenerate triangles, returns the weights of the first corner.
[[nodiscard]] glm::dvec3 barycentricWeights(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                            const glm::dvec3& place);

}  // namespace simreel::draw
