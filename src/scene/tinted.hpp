#pragma once
#include <optional>

#include <glm/vec3.hpp>

namespace simreel::scene {

/// Parameters of what may have a colour by nature.
class Tinted {
 public:
  virtual ~Tinted() = default;
  /// Linear RGB that a stage gives it where it has no material; none: one of the stage's palette.
  [[nodiscard]] virtual std::optional<glm::vec3> tint() const = 0;
};

}  // namespace simreel::scene
