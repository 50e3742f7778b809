#pragma once
#include <glm/vec3.hpp>

namespace simreel::scene {

/// Interface of the parameters of objects that write or draw over the picture, such as text.
class HasInk {
 public:
  virtual ~HasInk() = default;
  /// Sets the linear RGB colour of the text and lines unless the scene gives one.
  virtual void ink(const glm::vec3& color) = 0;
};

}  // namespace simreel::scene
