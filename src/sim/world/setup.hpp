#pragma once
#include "scene/scene.hpp"
#include "sim/body/bones.hpp"
#include "sim/core/collider.hpp"

#include <cstddef>
#include <vector>

namespace simreel::sim {

/// What a scene's cloths and particles collide with, in the scene's order, then the capsules of its bodies.
/// Without `bones` those are left out. Throws what their files' reader does.
[[nodiscard]] std::vector<ColliderShape> collidersOf(const scene::Scene& scene, const Bones* bones);

/// Meshes that others fall onto and bodies come first, what is made of others' fields after the rest, and
/// last who collides with solids; within each the scene's order. Who falls finds the heights of the frame's
/// beginning and end, who reads a field that of its end, who meets walls those of its end.
[[nodiscard]] std::vector<std::size_t> stepOrder(const scene::Scene& scene);

/// Frames that are simulated before frame 0.
[[nodiscard]] int prerollOf(const scene::Scene& scene);

/// Setting::startTime.
[[nodiscard]] double startOf(const scene::Scene& scene);

}  // namespace simreel::sim
