#pragma once
#include "scene/scene.hpp"

#include <cstddef>

#include <glm/vec2.hpp>

namespace simreel::scene {

class Diagnostics;
struct Node;

/// Layout of panels in a picture: rows of cells of one size.
struct PanelGrid {
  int columns = 1;
  int gap = 0;  ///< distance between neighbouring cells in pixels
  glm::ivec2 cell{0};
  /// Returns the first pixel of panel i.
  [[nodiscard]] glm::ivec2 corner(std::size_t i) const {
    const auto at = static_cast<int>(i);
    return glm::ivec2(at % columns, at / columns) * (cell + gap);
  }
};

/// Returns the layout whose cells contain the largest square.
[[nodiscard]] PanelGrid panelGrid(glm::ivec2 picture, std::size_t panels);
/// Returns the size in pixels of the part of the picture that a camera fills: a panel, or the picture.
[[nodiscard]] glm::ivec2 viewSize(const Scene& scene);
/// Returns the camera of a panel. The scene's own camera must have been placed.
[[nodiscard]] Camera cameraOf(const Panel& panel, const Camera& camera);

/// Checks the names of the objects that panels show.
void checkShown(const Node& root, const Scene& scene, Diagnostics& diagnostics);

}  // namespace simreel::scene
