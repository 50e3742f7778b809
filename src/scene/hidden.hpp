#pragma once
#include "scene/json/diagnostics.hpp"
#include "scene/json/json_node.hpp"
#include "scene/scene.hpp"

namespace simreel::scene {

/// Warns if the ground that the scene gives, or an object that is drawn over the whole picture, hides what
/// is in the world. `root`: the scene's JSON tree.
void remarkHidden(const Node& root, const Scene& scene, Diagnostics& diagnostics);

}  // namespace simreel::scene
