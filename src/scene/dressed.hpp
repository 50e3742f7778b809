#pragma once
#include "scene/scene.hpp"

#include <optional>

namespace simreel::scene {

/// Interface of parameters of objects that have a look of their own.
class Dressed {
 public:
  virtual ~Dressed() = default;
  /// Returns the finish that the object has on a stage: roughness, translucency, sheen, clear coat, and
  /// normals with their `textureScale`. The scene's own material keys replace them. nullopt: the stage's.
  [[nodiscard]] virtual std::optional<Material> look() const = 0;
};

}  // namespace simreel::scene
