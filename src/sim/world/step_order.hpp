#pragma once
#include "scene/scene.hpp"
#include "sim/core/port.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace simreel::sim {

/// Objects that step as one: a single one, or all that joined a group.
struct StepNode {
  std::vector<std::size_t> objects;  ///< in scene order; of a group those that lead it come first
  const PortInfo* group = nullptr;   ///< null: a single object
};

/// Order in which the objects of a scene are made and stepped. An object comes after those whose state at
/// the end of the frame it takes (When::beforeStep); otherwise the scene's order holds, and groups come as
/// late as they can. Objects in a circle come last, in the scene's order; checkOrder refuses them.
[[nodiscard]] std::vector<StepNode> stepOrder(std::span<const scene::Object> objects);

/// Reports objects that would have to step before themselves.
void checkOrder(std::span<const scene::Object> objects, const scene::Report& report);

}  // namespace simreel::sim
