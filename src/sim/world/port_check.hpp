#pragma once
#include "scene/scene.hpp"

#include <span>
#include <string>
#include <vector>

namespace simreel::sim {

/// Reports what objects name wrongly of each other, at the place where they name it: an object that is not
/// there, or one that does not provide what is wanted; and providers too many, providers that nothing
/// takes, and objects that would have to step before themselves (scene::Kinds::check).
void checkPorts(std::span<const scene::Object> objects, const scene::Report& report);

/// Returns the mistakes that only the whole scene shows, as lines that begin with a path: names that
/// cameras and lights follow, and objects that find nothing to take.
[[nodiscard]] std::vector<std::string> portMistakes(const scene::Scene& scene);

/// Remarks on objects that others pass by, a line each.
[[nodiscard]] std::vector<std::string> portRemarks(const scene::Scene& scene);

}  // namespace simreel::sim
