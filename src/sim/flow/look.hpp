#pragma once
#include "scene/value/fields.hpp"

#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Declares "colors", which selects either a colour map of the speed or the object's material. `stops`
/// receives the linear RGB stops of the map; it is empty if the material is selected.
void describeColors(scene::Fields& fields, std::vector<glm::vec3>& stops);

}  // namespace simreel::sim
