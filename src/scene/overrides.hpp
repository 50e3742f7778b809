#pragma once
#include <span>

#include "scene/diagnostics.hpp"
#include "scene/scene.hpp"

namespace simreel::scene {

/// "path=value", as messages name it.
[[nodiscard]] std::string overrideText(const Override& override_);

/// Puts each override's value into the tree, in order; later ones win. Missing objects on the way are made: whether
/// their names are known is checked when the tree is read. Mistakes go to the diagnostics.
void applyOverrides(Node& root, std::span<const Override> overrides, Diagnostics& diagnostics);

}  // namespace simreel::scene
