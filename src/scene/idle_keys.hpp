#pragma once
#include "scene/json/diagnostics.hpp"
#include "scene/json/json_node.hpp"
#include "scene/scene.hpp"

namespace simreel::scene {

/// Warns about keys of objects that change nothing in this scene: the anchor of a single line of text that
/// an automatic camera centres, and "doubleSided" of a closed solid that is seen from outside. The scene
/// must be complete.
void warnIdleKeys(const Node& root, const Scene& scene, Diagnostics& diagnostics);

}  // namespace simreel::scene
