#pragma once
#include <string>
#include <string_view>

namespace simreel::serve {

/// A scene as run (scene::sceneAsRun) without what shows its simulations and goes into no state of theirs:
/// colours of fields and where they lie, texts, whether things are seen. For scene::simulationHash.
[[nodiscard]] std::string withoutWhatShows(std::string_view asRun);

/// Scene time (s) up to which two scenes as run simulate the same, at every frame: where they differ in
/// nothing but strokes, and keyframes of values that nothing asks for before their time, that of the first
/// of those. 0 or less: nothing is known to be the same. Infinity: all of it.
[[nodiscard]] double secondsAlike(std::string_view before, std::string_view after);

}  // namespace simreel::serve
