#pragma once
#include "scene/json_node.hpp"
#include "scene/scene.hpp"

namespace simreel::scene {

/// Puts the value of one -D into the tree, creating missing members on the way. The new nodes' places
/// lie in the override's own text. Mistakes go to `diagnostics`.
void applyOverride(Node& scene, const Override& change, Diagnostics& diagnostics);

}  // namespace simreel::scene
