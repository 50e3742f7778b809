#pragma once
#include "scene/scene.hpp"
#include "sim/body/bones.hpp"
#include "sim/core/collider.hpp"

#include <vector>

namespace simreel::sim {

/// Returns the shapes that cloths and particles of a scene collide with, in the scene's order, then the
/// capsules of its bodies, which are omitted if `bones` is null. Throws the errors of the bodies' file
/// reader.
[[nodiscard]] std::vector<ColliderShape> collidersOf(const scene::Scene& scene, const Bones* bones);

/// Returns the number of frames simulated before frame 0.
[[nodiscard]] int prerollOf(const scene::Scene& scene);

/// Returns the time of the first simulated frame in seconds (Setting::startTime).
[[nodiscard]] double startOf(const scene::Scene& scene);

}  // namespace simreel::sim
