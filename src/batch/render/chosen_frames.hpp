#pragma once
#include "scene/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace simreel::batch {

/// Frames as --frames takes them, all of the scene where nothing is given. Warns of those beyond its end.
[[nodiscard]] std::vector<int> chosenFrames(const std::optional<std::string>& text,
                                            const scene::Scene& scene);
void warnBeyondEnd(int frame, const scene::Scene& scene);

}  // namespace simreel::batch
