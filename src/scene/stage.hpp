#pragma once
#include "scene/framing.hpp"
#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace simreel::scene {

/// Supplies the sun, sky, ground, lights and materials that a scene leaves out, in the manner of a product
/// photograph. A floor just below all objects fades into a background of the same brightness. A key light
/// casts soft shadows, which the light of the sky brightens. A lamp behind the objects outlines their
/// edges. Each object gets a colour of a small palette. Objects do not collide with the floor unless the
/// scene gives "ground". A field that is drawn behind all objects replaces the floor. `framed`: result of
/// framedObjects(scene). If it is empty (pictures of fields), nothing changes. Landscapes change only if
/// the scene gives a preset. `version`: version of the scene. Since version 2, dark stages have large soft
/// lamps that polished metal mirrors, and text over the picture is dark on bright stages.
void setStage(Scene& scene, const std::vector<Framed>& framed, int version);

/// Returns advice for a staged scene whose objects are hard to see on its stage. Returns an empty text if
/// there is no advice.
[[nodiscard]] std::string stageAdvice(const Scene& scene);

/// Returns advice for a scene whose camera is below the ground that the scene gives. Returns an empty text
/// if there is no advice.
[[nodiscard]] std::string groundAdvice(const Scene& scene);

/// Moves the floor and lights of a staged scene to fit the extents `framed`. Does not move a ground that
/// the scene gives.
void moveStage(Scene& scene, const std::vector<Framed>& framed);

/// Hides the stage's floor if the camera is below the floor at time 0, because the floor would then hide
/// everything. Does not hide a ground that the scene gives.
void openFloor(Scene& scene);

}  // namespace simreel::scene
