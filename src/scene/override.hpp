#pragma once
#include "scene/json/json_node.hpp"
#include "scene/scene.hpp"

namespace simreel::scene {

/// Sets the value of one -D override in the tree. Creates missing members on the way; a reader checks their
/// names later. Does not create objects, lights or list items from a part: they must be given as a whole.
/// Places of new nodes lie in the override's own text. Reports errors to `diagnostics`.
void applyOverride(Node& scene, const Override& change, Diagnostics& diagnostics);

}  // namespace simreel::scene
