#pragma once
#include "scene/json/json_node.hpp"
#include "scene/scene.hpp"

namespace simreel::scene {

/// Sets the value of one -D override in the tree. Creates missing members along the path; a reader checks
/// their names later. Reports an error if the override would create an object, a light or a list item from
/// a single member. Places of new nodes lie in the text of the override. Reports errors to `diagnostics`.
void applyOverride(Node& scene, const Override& change, Diagnostics& diagnostics);

}  // namespace simreel::scene
