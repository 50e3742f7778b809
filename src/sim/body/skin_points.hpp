#pragma once
#include "sim/body/motion.hpp"

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Points that are attached to the skin of a body, on the CPU: each follows the nearest place of the
/// nearest face, by that place's barycentric coordinates, and keeps its distance from it in the face's own
/// axes, which turn with it. The skin is that of glsl/body/model.glsl in doubles.
class SkinPoints {
 public:
  /// As of Bones::heldBySkin. The first of several that are as near.
  SkinPoints(const std::string& body, std::shared_ptr<const BodyMotion> motion,
             std::span<const glm::dvec3> points, double time);
  [[nodiscard]] std::vector<glm::dvec3> at(double time) const;

 private:
  struct Place {
    std::array<unsigned, 3> corners;
    glm::dvec3 shares;  ///< barycentric
    glm::dvec3 offset;  ///< m, in the axes of the face
  };
  std::shared_ptr<const BodyMotion> motion_;
  std::vector<Place> places_;
};

}  // namespace simreel::sim
