#pragma once
#include "scene/json/json_node.hpp"
#include "scene/scene.hpp"

namespace simreel::scene {

/// Sets the value of one -D override in the tree. Creates missing members along the path. A reader checks
/// the names of these members later. Reports an error to `diagnostics` if the override would create an
/// object, a light or a list item from a single member. Places of new nodes lie in the text of the
/// override.
void applyOverride(Node& scene, const Override& change, Diagnostics& diagnostics);

}  // namespace simreel::scene
