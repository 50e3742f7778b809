#pragma once
#include "scene/scene.hpp"
#include "scene/stage_presets.hpp"

#include <glm/vec3.hpp>

namespace simreel::scene {

/// Adds the stage's lamps that the scene does not replace by lamps of the same name: "rim" behind the
/// objects and, for a dark stage whose sun the scene leaves out, the rectangles "fill" beside the camera
/// and "softbox" above. `soft`: false for no rectangles.
void addStageLamps(Scene& scene, const StageLook& look, bool soft);

/// Space of a stage: the sphere around its objects and unit vectors.
struct StageSpace {
  glm::vec3 middle;  ///< metres
  float radius;      ///< metres
  glm::vec3 back;    ///< horizontal direction to the automatic camera
  glm::vec3 right;   ///< horizontal direction to that camera's right
};

/// Moves the stage's lamps to their places in the space.
void moveStageLamps(Scene& scene, const StageLook& look, const StageSpace& space);

}  // namespace simreel::scene
