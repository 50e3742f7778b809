#pragma once
#include "scene/value/fields.hpp"

#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Declares "colors", the name of a colour map, and "colorStops", a map defined by the scene. Returns the
/// evenly spaced linear RGB stops of the chosen map. `what` is the plural of the coloured things, such as
/// "particles".
[[nodiscard]] std::vector<glm::vec3> describeColors(scene::Fields& fields, const std::string& what);

}  // namespace simreel::sim
