#pragma once
#include "scene/scene.hpp"

#include <memory>

namespace simreel::draw {

/// Returns a copy of everything in a scene that drawing needs. The objects have no parameters.
[[nodiscard]] std::unique_ptr<scene::Scene> copyForDrawing(const scene::Scene& scene);

/// Returns the scene as an overlay shows it, or null without an overlay: without ground, lamps, shadows and
/// film, before an even background. All qualities then give the same picture.
[[nodiscard]] std::unique_ptr<scene::Scene> overlaidScene(const scene::Scene& scene);

}  // namespace simreel::draw
