#pragma once
#include "scene/scene.hpp"
#include "sim/body/bones.hpp"
#include "sim/core/collider.hpp"

#include <vector>

namespace simreel::sim {

/// What a scene's cloths and particles collide with, in the scene's order, then the capsules of its bodies.
/// Without `bones` those are left out. Throws what their files' reader does.
[[nodiscard]] std::vector<ColliderShape> collidersOf(const scene::Scene& scene, const Bones* bones);

/// Frames that are simulated before frame 0.
[[nodiscard]] int prerollOf(const scene::Scene& scene);

/// Setting::startTime.
[[nodiscard]] double startOf(const scene::Scene& scene);

}  // namespace simreel::sim
