#pragma once
#include "scene/scene.hpp"

#include <span>
#include <string>
#include <vector>

namespace simreel::sim {

/// Reports objects that need of others what none of them is: the field of a skin, a solid with walls.
void checkRelations(std::span<const scene::Object> objects, const scene::Report& report);

/// One message for each of the camera and the lights that follows an object that finds no path, and for
/// each object that asks for something to touch where there is nothing.
[[nodiscard]] std::vector<std::string> relationMistakes(const scene::Scene& scene);

/// Whether a cloth of the scene is in contact.
[[nodiscard]] bool hasClothsInContact(const scene::Scene& scene);
/// A line for each cloth that particles fall through, though nobody said so.
[[nodiscard]] std::vector<std::string> relationRemarks(const scene::Scene& scene);

}  // namespace simreel::sim
