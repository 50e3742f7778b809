#pragma once
#include "scene/scene.hpp"
#include "sim/core/port.hpp"

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Port of the scene itself: size and camera of the picture to which the frames are drawn.
struct ShownPicture {
  static const PortInfo port;

  glm::ivec2 size{1280, 720};             ///< width and height in pixels
  const scene::Camera* camera = nullptr;  ///< null if the simulation is not part of a scene
};

/// Returns the picture of the scene, or a default if there is no scene.
[[nodiscard]] inline ShownPicture shownPicture(const Links* links) {
  const ShownPicture* picture = links == nullptr ? nullptr : links->get<ShownPicture>();
  return picture == nullptr ? ShownPicture() : *picture;
}

}  // namespace simreel::sim
