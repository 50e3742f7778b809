#pragma once
#include <glm/vec3.hpp>

namespace simreel::scene {

/// Interface of parameters of objects that are written over the picture.
class Inked {
 public:
  virtual ~Inked() = default;
  /// Sets the linear RGB colour of the writing unless the scene gives one.
  virtual void ink(const glm::vec3& color) = 0;
};

}  // namespace simreel::scene
