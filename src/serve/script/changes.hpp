#pragma once
#include <string>
#include <string_view>

namespace simreel::serve {

/// Returns a scene as run (scene::sceneAsRun) without members that only affect how simulations look and no
/// state: colours and positions of fields, texts, visibility. Used for scene::simulationHash.
[[nodiscard]] std::string withoutWhatShows(std::string_view asRun);

/// Returns the scene time in seconds up to which two scenes as run have equal states at every frame. If
/// they differ only in strokes and in keyframes of values that are evaluated at their own time, this is the
/// earliest such difference. 0 or less: nothing is known to be equal. Infinity: all states are equal.
[[nodiscard]] double secondsAlike(std::string_view before, std::string_view after);

}  // namespace simreel::serve
