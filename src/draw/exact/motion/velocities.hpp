#pragma once
#include "draw/exact/motion/motion.hpp"

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

/// How fast what is drawn moves in the world, by the numbers of its triangles and instances: surfaces by
/// how far each point of a triangle has come since the frame before, instances by their own velocities.
class Velocities {
 public:
  /// Of a motion that has begun; `seconds` between the two frames; `part`: at which part of the way
  /// between them what is drawn stands.
  Velocities(Motion& motion, double seconds, float part)
      : motion_(motion), seconds_(seconds), part_(static_cast<double>(part)) {}

  /// Surface i of the frame has the numbers from `firstId` on, `triangles` at most.
  void addSurface(const sim::Surface& surface, std::size_t i, unsigned firstId, int triangles);
  /// Instances i, which have `each` numbers each.
  void addInstances(std::size_t i, unsigned firstId, unsigned each);
  /// Of the point of what has that number which lies at `place` (m): m/s. 0 for what does not move.
  [[nodiscard]] glm::vec3 at(unsigned number, const glm::dvec3& place) const;

 private:
  struct Mesh {
    unsigned firstId = 0, end = 0;
    glm::ivec2 row{0};  ///< triangles of a row, and vertices to the next; 0: all have indices
    std::vector<unsigned> indices;
    Motion::Way way;
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

/// The shares of a triangle's corners in the point of it that is nearest to its plane's foot below `place`:
/// each 0 to 1, sum 1. Of one without area: the first corner.
[[nodiscard]] glm::dvec3 sharesOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                  const glm::dvec3& place);

}  // namespace simreel::draw
