#pragma once
#include "draw/camera.hpp"
#include "scene/scene.hpp"

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::draw {

/// So many points, spread evenly over an opening of radius 1: a disc, or a polygon of so many sides in it,
/// a corner on top.
[[nodiscard]] std::vector<glm::vec2> openingPoints(int count, int blades);

/// Through which point of the lens a picture is seen.
struct LensPoint {
  glm::vec3 aside{0};  ///< m from its middle, square to the line of sight
  float focus = 1;     ///< m along the line of sight: what lies there does not move
};

/// The points through which a frame is drawn: the middle alone where the camera has no lens.
[[nodiscard]] std::vector<LensPoint> lensPoints(const scene::Camera& camera, const View& view,
                                                double seconds);

}  // namespace simreel::draw
