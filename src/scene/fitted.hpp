#pragma once
#include <glm/vec2.hpp>

namespace simreel::scene {

/// Interface of the parameters of objects whose default grid depends on the picture.
class Fitted {
 public:
  virtual ~Fitted() = default;
  /// Gives a default grid the aspect ratio of the picture (width and height in pixels) that shows it.
  /// Called for scenes since version 2, after all parameters have been read.
  virtual void fitPicture(glm::ivec2 picture) = 0;
};

}  // namespace simreel::scene
