#pragma once
#include "scene/json/json_node.hpp"
#include "scene/scene.hpp"

namespace simreel::scene {

/// Puts the value of one -D into the tree. Members that are not there are made on the way, for a reader to
/// check against what is declared, but neither objects nor items of lists: those are given as a whole. The
/// new nodes' places lie in the override's own text. Mistakes go to `diagnostics`.
void applyOverride(Node& scene, const Override& change, Diagnostics& diagnostics);

}  // namespace simreel::scene
