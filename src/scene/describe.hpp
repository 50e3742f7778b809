#pragma once
#include "scene/fields.hpp"
#include "scene/scene.hpp"

namespace simreel::scene {

/// Describes every section of a scene but its objects.
void describeScene(Fields& fields, Scene& scene);

/// Format of scene files this program reads.
inline constexpr int sceneVersion = 1;

}  // namespace simreel::scene
