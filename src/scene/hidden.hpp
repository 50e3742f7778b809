#pragma once
#include "scene/json/diagnostics.hpp"
#include "scene/json/json_node.hpp"
#include "scene/scene.hpp"

namespace simreel::scene {

/// True if a colour bar explains a field that is drawn behind all objects.
[[nodiscard]] bool explainsBehind(const Node& root, const Scene& scene);

/// Warns if the ground given by the scene, or an object drawn over the whole picture, hides other objects
/// or a field behind them, if a scene of fields draws none, and about colour bars of fields that are not
/// drawn and objects that fall through the ground. `root`: the scene's JSON tree.
void warnHidden(const Node& root, const Scene& scene, Diagnostics& diagnostics);

}  // namespace simreel::scene
