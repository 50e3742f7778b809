#pragma once
#include "draw/camera.hpp"
#include "scene/scene.hpp"

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::draw {

/// Returns `count` points that are spread evenly over an aperture of radius 1. If `blades` is 0, the
/// aperture is a disc. Otherwise it is a regular polygon with `blades` sides, inscribed in the disc, with a
/// corner at the top.
[[nodiscard]] std::vector<glm::vec2> openingPoints(int count, int blades);

/// A point of the lens through which a picture is drawn.
struct LensPoint {
  glm::vec3 aside{0};  ///< offset from the lens centre (m), perpendicular to the view direction
  float focus = 1;     ///< distance of the focal plane along the view direction (m); objects in this plane
                       ///< are sharp
};

/// Returns the lens points through which a frame is drawn. Returns only the centre if the camera has no
/// lens.
[[nodiscard]] std::vector<LensPoint> lensPoints(const scene::Camera& camera, const View& view,
                                                double seconds);

/// Returns how far a point of the picture moves if the eye moves on the lens. x: displacement of a point at
/// infinity. y: decrease of the displacement per nearness. Both are in pixels per radius of the lens. z:
/// side of the square, in radii of the lens, that one lens point stands for. Only for perspective views.
[[nodiscard]] glm::vec3 lensShift(const scene::Camera& camera, const View& view, glm::ivec2 size,
                                  float focus, double seconds);

}  // namespace simreel::draw
