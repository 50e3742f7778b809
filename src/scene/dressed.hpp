#pragma once
#include "scene/scene.hpp"

#include <optional>

namespace simreel::scene {

/// Interface of the parameters of objects that bring a finish of their own.
class Dressed {
 public:
  virtual ~Dressed() = default;
  /// Returns the finish that the object has on a stage: roughness, translucency, sheen, clear coat, and
  /// normals with their `textureScale`. Keys of the scene's material replace parts of this finish. Returns
  /// nullopt if the object uses the stage's finish.
  [[nodiscard]] virtual std::optional<Material> look() const = 0;
};

}  // namespace simreel::scene
