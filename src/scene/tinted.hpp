#pragma once
#include <optional>

#include <glm/vec3.hpp>

namespace simreel::scene {

/// Interface of the parameters of objects that may have a natural colour.
class HasTint {
 public:
  virtual ~HasTint() = default;
  /// Returns the linear RGB colour that the object has on a stage if it has no material. Returns nullopt if
  /// the object takes a colour of the stage's palette.
  [[nodiscard]] virtual std::optional<glm::vec3> tint() const = 0;
};

}  // namespace simreel::scene
