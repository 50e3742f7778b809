#pragma once
#include "scene/json/diagnostics.hpp"
#include "scene/json/json_node.hpp"
#include "scene/scene.hpp"

namespace simreel::scene {

/// Warns if the ground given by the scene, or an object drawn over the whole picture, hides other objects
/// or a field behind them. `root`: the scene's JSON tree.
void warnHidden(const Node& root, const Scene& scene, Diagnostics& diagnostics);

}  // namespace simreel::scene
