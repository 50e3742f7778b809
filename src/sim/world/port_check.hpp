#pragma once
#include "scene/scene.hpp"

#include <span>
#include <string>
#include <vector>

namespace simreel::sim {

/// Reports wrong references between objects, each with its JSON path in the scene: a name without an
/// object, an object that does not provide the port, too many providers, providers that nothing uses,
/// objects whose required provider is missing, and objects that would have to step before themselves
/// (scene::Kinds::check). `hasGround`: true if the scene has a ground that collides.
void checkPorts(std::span<const scene::Object> objects, bool hasGround, const scene::Report& report);

/// Returns the errors of the names that cameras and lights follow, as lines that begin with a JSON path.
[[nodiscard]] std::vector<std::string> portMistakes(const scene::Scene& scene);

/// Returns one warning line for each object that other objects ignore, for example a cloth without contact.
[[nodiscard]] std::vector<std::string> portRemarks(const scene::Scene& scene);

}  // namespace simreel::sim
