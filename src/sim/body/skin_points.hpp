#pragma once
#include "sim/body/motion.hpp"

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Points attached to the skin of a body, on the CPU. Each point follows the closest point of the nearest
/// face by barycentric coordinates. It keeps its offset from that point along the axes of the face, which
/// rotate with the face. Uses the skinning of glsl/body/model.glsl in double precision.
class SkinPoints {
 public:
  /// Attaches `points` at `time` (see Bones::heldBySkin()). If several faces are equally near, the first
  /// one is used.
  SkinPoints(const std::string& body, std::shared_ptr<const BodyMotion> motion,
             std::span<const glm::dvec3> points, double time);
  [[nodiscard]] std::vector<glm::dvec3> at(double time) const;

 private:
  struct Place {
    std::array<unsigned, 3> corners;
    glm::dvec3 shares;  ///< barycentric coordinates
    glm::dvec3 offset;  ///< offset in metres, in the axes of the face
  };
  std::shared_ptr<const BodyMotion> motion_;
  std::vector<Place> places_;
};

}  // namespace simreel::sim
