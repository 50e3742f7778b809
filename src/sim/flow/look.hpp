#pragma once
#include "scene/value/fields.hpp"

#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Declares "colors", a colour map of the speed or the object's material. `stops`: becomes the map's linear
/// RGB stops, or empty for the material.
void describeColors(scene::Fields& fields, std::vector<glm::vec3>& stops);

}  // namespace simreel::sim
