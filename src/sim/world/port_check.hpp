#pragma once
#include "scene/scene.hpp"

#include <span>
#include <string>
#include <vector>

namespace simreel::sim {

/// Reports wrong references between objects, each with its JSON path in the scene: a name without an
/// object, an object that does not provide the port, too many providers, providers that nothing uses, and
/// objects that would have to step before themselves (scene::Kinds::check).
void checkPorts(std::span<const scene::Object> objects, const scene::Report& report);

/// Returns the errors that only the whole scene reveals, as lines that begin with a JSON path: unknown
/// names that cameras and lights follow, and objects whose required provider is missing.
[[nodiscard]] std::vector<std::string> portMistakes(const scene::Scene& scene);

/// Returns one warning line for each object that other objects ignore, for example a cloth without contact.
[[nodiscard]] std::vector<std::string> portRemarks(const scene::Scene& scene);

}  // namespace simreel::sim
