#pragma once
#include <glm/vec2.hpp>

namespace simreel::scene {

/// Interface of the parameters of objects that are drawn over the picture and need a part of it for
/// themselves, such as a colour bar.
class TakesRoom {
 public:
  virtual ~TakesRoom() = default;
  /// Returns the widths of the strips at the right and at the bottom, as fractions of the picture, in which
  /// nothing else is drawn by default. Returns 0 if the scene places the object.
  [[nodiscard]] virtual glm::vec2 room() const = 0;
};

}  // namespace simreel::scene
