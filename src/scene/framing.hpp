#pragma once
#include "scene/scene.hpp"

namespace simreel::scene {

/// Moves a camera that the scene places nowhere so that it has everything in view that asks for it
/// (Parameters::framed), with a margin: what lies from above and in front, what is tall almost level and
/// from the side. Others stay.
void frameObjects(Scene& scene);

}  // namespace simreel::scene
