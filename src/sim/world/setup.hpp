#pragma once
#include "scene/scene.hpp"
#include "sim/body/bones.hpp"
#include "sim/core/collider.hpp"

#include <functional>
#include <vector>

namespace simreel::sim {

/// Returns the shapes that cloths and particles of a scene collide with, in scene order, followed by the
/// capsules of its bodies; `bones` may be null to omit the capsules. Throws the errors of the bodies' file
/// reader.
[[nodiscard]] std::vector<ColliderShape> collidersOf(const scene::Scene& scene, const Bones* bones);

/// Returns the number of frames simulated before frame 0.
[[nodiscard]] int prerollOf(const scene::Scene& scene);

/// Returns the time of the first simulated frame in seconds (Setting::startTime).
[[nodiscard]] double startOf(const scene::Scene& scene);

/// Runs `work` for an object. A usage error that does not name the object gets the object's path in front.
void namingObject(const scene::Object& object, const std::function<void()>& work);

}  // namespace simreel::sim
