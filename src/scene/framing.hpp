#pragma once
#include "scene/scene.hpp"

#include <vector>

namespace simreel::scene {

/// What of an object a camera should have in view.
struct Framed {
  Box box;
  std::vector<glm::vec3> points = {};  ///< m, its outermost ones; empty: those of the box
};

/// Nothing of an object that does not ask for it (Parameters::framed).
[[nodiscard]] std::optional<Framed> framedOf(const Object& object);
/// Of each object that asks for it, as its parameters tell.
[[nodiscard]] std::vector<Framed> framedObjects(const Scene& scene);
/// The least box around all of them; there is one at least.
[[nodiscard]] Box boxAround(const std::vector<Framed>& framed);

/// Moves a camera that the scene places nowhere so that it has all of them in view, with a margin: what
/// lies from above and in front, what is tall almost level and from the side. On a stage from a corner, by
/// a longer lens, with what is seen in the middle of the picture. Others stay.
void frameObjects(Scene& scene, const std::vector<Framed>& framed);

/// Unit, from what stands on a stage to the camera.
[[nodiscard]] glm::vec3 stageBack(const Box& box);

}  // namespace simreel::scene
