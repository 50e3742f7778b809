#pragma once
#include "scene/scene.hpp"
#include "scene/stage_presets.hpp"

#include <glm/vec3.hpp>

namespace simreel::scene {

/// Adds the stage's lamps, except those that the scene replaces by lamps of the same name. "rim" is behind
/// the objects. A dark stage whose sun the scene leaves out also gets two area lights: "fill" next to the
/// camera and "softbox" above. `soft`: false to leave out the area lights.
void addStageLamps(Scene& scene, const StageLook& look, bool soft);

/// Sphere around the objects of a stage, and two horizontal unit vectors.
struct StageSpace {
  glm::vec3 middle;  ///< centre of the sphere in metres
  float radius;      ///< radius of the sphere in metres
  glm::vec3 back;    ///< horizontal direction from the objects to the automatically placed camera
  glm::vec3 right;   ///< horizontal direction to the right of that camera
};

/// Moves the stage's lamps to their positions relative to `space`.
void moveStageLamps(Scene& scene, const StageLook& look, const StageSpace& space);

}  // namespace simreel::scene
