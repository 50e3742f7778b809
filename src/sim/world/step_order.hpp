#pragma once
#include "scene/scene.hpp"
#include "sim/core/port.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace simreel::sim {

/// Objects that step together: one object, or all members of a group.
struct StepNode {
  std::vector<std::size_t> objects;  ///< indices of objects in scene order; in a group, leading members
                                     ///< come first
  const PortInfo* group = nullptr;   ///< port of the group; null for a single object
};

/// Returns the order in which the objects of a scene are created and stepped. An object comes after those
/// whose end-of-frame state it reads (When::beforeStep). Otherwise the scene order applies, and groups come
/// as late as possible. Objects in a dependency cycle come last, in scene order; checkOrder() rejects them.
[[nodiscard]] std::vector<StepNode> stepOrder(std::span<const scene::Object> objects);

/// Reports objects in a dependency cycle, which would have to step before themselves.
void checkOrder(std::span<const scene::Object> objects, const scene::Report& report);

}  // namespace simreel::sim
