#pragma once
#include "scene/scene.hpp"

#include <vector>

namespace simreel::scene {

/// Of each object that asks for it, what a camera should have in view (Parameters::framed).
[[nodiscard]] std::vector<Box> framedBoxes(const Scene& scene);
/// The least box around all of them; there is one at least.
[[nodiscard]] Box boxAround(const std::vector<Box>& boxes);

/// Moves a camera that the scene places nowhere so that it has the boxes in view, with a margin: what lies
/// from above and in front, what is tall almost level and from the side. On a stage from a corner, by a
/// longer lens, with what is seen in the middle of the picture. Others stay.
void frameObjects(Scene& scene, const std::vector<Box>& boxes);

/// Unit, from what stands on a stage to the camera.
[[nodiscard]] glm::vec3 stageBack(const Box& box);

}  // namespace simreel::scene
