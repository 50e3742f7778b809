#pragma once
#include "scene/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace simreel::batch {

/// Returns the frames that an argument of --frames selects, or all frames of the scene if `text` is
/// nullopt. Warns about frames after the scene's end.
[[nodiscard]] std::vector<int> chosenFrames(const std::optional<std::string>& text,
                                            const scene::Scene& scene);
void warnBeyondEnd(int frame, const scene::Scene& scene);

}  // namespace simreel::batch
