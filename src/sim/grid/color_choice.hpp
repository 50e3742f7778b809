#pragma once
#include "scene/value/fields.hpp"

#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Declares "colors", a colour map by name, and "colorStops", a map of the scene's own. Returns the evenly
/// spaced linear RGB stops of the chosen map. `what`: plural of what is coloured, such as "particles".
[[nodiscard]] std::vector<glm::vec3> describeColors(scene::Fields& fields, const std::string& what);

}  // namespace simreel::sim
