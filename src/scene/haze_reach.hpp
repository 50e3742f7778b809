#pragma once
#include "scene/scene.hpp"

namespace simreel::scene {

/// Extends the ground to where the haze hides it, unless the scene gives the distances at which the ground
/// fades. The ground's edge is then invisible.
void extendGroundIntoHaze(Scene& scene);
/// Extends the depth range of a perspective camera beyond the ground of extendGroundIntoHaze().
void extendViewIntoHaze(Scene& scene);

}  // namespace simreel::scene
