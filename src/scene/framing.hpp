#pragma once
#include "scene/scene.hpp"

namespace simreel::scene {

/// Moves a camera that the scene places nowhere so that it has everything in view that asks for it
/// (Parameters::framed), from above and in front, with a margin. Others stay.
void frameObjects(Scene& scene);

}  // namespace simreel::scene
