#pragma once
#include "scene/json_node.hpp"
#include "scene/scene.hpp"

#include <vector>

namespace simreel::scene {

/// Whether a scene says nothing of its surroundings: none of "sun", "sky", "ground", "lights".
[[nodiscard]] bool givesNoStage(const Node& scene);

/// Puts a scene that says nothing of its surroundings on a stage, as products are photographed: a ground
/// just below everything (to be seen, not touched) that fades into a background of its own brightness, a
/// key light with soft shadows, the sky's light to fill them, a lamp behind for a rim, and of each object
/// without a material a colour of a small palette by its number. What shines gets a dark one. `boxes`:
/// framedBoxes(scene); where there are none (pictures of fields) nothing changes.
void setStage(Scene& scene, const std::vector<Box>& boxes);

}  // namespace simreel::scene
