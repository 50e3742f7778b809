#pragma once
#include "scene/framing.hpp"
#include "scene/json/json_node.hpp"
#include "scene/scene.hpp"

#include <vector>

namespace simreel::scene {

/// True if the scene has none of "sun", "sky", "ground" and "lights".
[[nodiscard]] bool givesNoStage(const Node& scene);

/// Puts a scene without surroundings on a stage, as in product photography. The stage has a ground just
/// below everything (drawn, without collisions) that fades into a background of the same brightness, a key
/// light with soft shadows, fill light from the sky, and a rim light from behind. An object without a
/// material gets a palette colour by its index. Objects that shine get a dark stage. `framed`:
/// framedObjects(scene). If it is empty (a scene of 2D fields), the scene does not change.
void setStage(Scene& scene, const std::vector<Framed>& framed);

/// Moves and resizes the stage of a staged scene to fit the extents `framed`.
void moveStage(Scene& scene, const std::vector<Framed>& framed);

}  // namespace simreel::scene
