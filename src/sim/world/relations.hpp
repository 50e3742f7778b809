#pragma once
#include "scene/scene.hpp"

#include <span>

namespace simreel::sim {

/// Reports objects that need of others what none of them is: the field of a skin, a surface to fall onto.
void checkRelations(std::span<const scene::Object> objects, const scene::Report& report);

}  // namespace simreel::sim
