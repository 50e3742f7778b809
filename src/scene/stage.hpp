#pragma once
#include "scene/framing.hpp"
#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace simreel::scene {

/// Supplies what a scene leaves out of sun, sky, ground, lights and materials, as a product photograph has
/// it: a floor just below everything that fades into a background of its own brightness, a key light with
/// soft shadows, light of the sky to fill them, a lamp behind for a rim, and a colour of a small palette
/// for each object. Objects do not collide with the floor unless the scene gives "ground". `framed`:
/// framedObjects(scene); without any (pictures of fields), and for landscapes unless the scene gives a
/// preset, nothing changes. `version`: the scene's; since version 2, dark stages have large soft lamps that
/// polished metal mirrors, and writing on the screen is dark on bright stages.
void setStage(Scene& scene, const std::vector<Framed>& framed, int version);

/// Returns advice for a staged scene whose objects are hard to see on its stage; empty: none.
[[nodiscard]] std::string stageAdvice(const Scene& scene);

/// Returns advice for a scene whose camera is below the ground that the scene gives; empty: none.
[[nodiscard]] std::string groundAdvice(const Scene& scene);

/// Moves the stage of a staged scene to these objects. A ground that the scene gives stays.
void moveStage(Scene& scene, const std::vector<Framed>& framed);

/// Leaves the stage's own floor out if the camera is below it at the start, where the floor would hide
/// everything. A ground that the scene gives stays.
void openFloor(Scene& scene);

}  // namespace simreel::scene
