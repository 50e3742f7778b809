#pragma once
#include <string>
#include <string_view>

namespace simreel::serve {

/// Returns a scene as run (scene::sceneAsRun) without members that affect only the appearance of
/// simulations and not their states. These are colours and positions of fields, texts, and visibility. Used
/// for scene::simulationHash.
[[nodiscard]] std::string withoutAppearance(std::string_view asRun);

/// Returns the scene time in seconds up to which two scenes as run have equal states at every frame. If
/// they differ only in strokes and in keyframes that affect the state only at their own time, this is the
/// earliest such difference. A result of 0 or less means that no states are known to be equal. Infinity
/// means that all states are equal.
[[nodiscard]] double equalUntil(std::string_view before, std::string_view after);

}  // namespace simreel::serve
