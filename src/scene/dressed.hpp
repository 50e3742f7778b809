#pragma once
#include "scene/scene.hpp"

#include <optional>

namespace simreel::scene {

/// Interface of the parameters of objects that define a finish.
class HasFinish {
 public:
  virtual ~HasFinish() = default;
  /// Returns the finish that the object has on a stage: roughness, translucency, sheen, clear coat, and
  /// normals with their `textureScale`. Keys of the scene's material override parts of this finish. Returns
  /// nullopt if the object uses the finish of the stage.
  [[nodiscard]] virtual std::optional<Material> look() const = 0;
};

}  // namespace simreel::scene
