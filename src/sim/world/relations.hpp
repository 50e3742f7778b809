#pragma once
#include "scene/scene.hpp"

#include <span>
#include <string>
#include <vector>

namespace simreel::sim {

/// Reports objects that need of others what none of them is: the field of a skin, a surface to fall onto.
void checkRelations(std::span<const scene::Object> objects, const scene::Report& report);

/// One message for each, of the camera and the lights, that follows an object that finds no path.
[[nodiscard]] std::vector<std::string> followMistakes(const scene::Scene& scene);

}  // namespace simreel::sim
