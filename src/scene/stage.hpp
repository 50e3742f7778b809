#pragma once
#include "scene/framing.hpp"
#include "scene/json/json_node.hpp"
#include "scene/scene.hpp"

#include <vector>

namespace simreel::scene {

/// Whether a scene says nothing of its surroundings: none of "sun", "sky", "ground", "lights".
[[nodiscard]] bool givesNoStage(const Node& scene);

/// Puts a scene that says nothing of its surroundings on a stage, as products are photographed: a ground
/// just below everything (to be seen, not touched) that fades into a background of its own brightness, a
/// key light with soft shadows, the sky's light to fill them, a lamp behind for a rim, and of each object
/// without a material a colour of a small palette by its number. What shines gets a dark one. `framed`:
/// framedObjects(scene); where there are none (pictures of fields) nothing changes.
void setStage(Scene& scene, const std::vector<Framed>& framed);

/// Moves the stage of a scene that stands on one to where these are.
void moveStage(Scene& scene, const std::vector<Framed>& framed);

}  // namespace simreel::scene
