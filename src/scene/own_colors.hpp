#pragma once
#include "scene/json/diagnostics.hpp"
#include "scene/json/json_node.hpp"
#include "scene/scene.hpp"

#include <span>

namespace simreel::scene {

/// Interface of the parameters of objects whose colours do not come from their material.
class HasOwnColors {
 public:
  virtual ~HasOwnColors() = default;
  /// Returns the source of the object's colours for messages, such as: its "map". The material's colour
  /// then has no effect. Returns nullptr if the material colours the object.
  [[nodiscard]] virtual const char* coloredBy() const = 0;
  /// True if these colours replace the material's texture and skin, too.
  [[nodiscard]] virtual bool replacesTextures() const { return false; }
};

/// Warns about the colour, texture and skin that the colours of an object replace. `node`: the object's
/// JSON node.
void remarkColors(const Node& node, const Object& object, Diagnostics& diagnostics);

/// Shows the colours of a field with states (life) on a skin whose look the scene leaves out, because the
/// other looks are for smooth fields. `node`: JSON node of all objects.
void keepStateColors(const Node& node, std::span<Object> objects);

}  // namespace simreel::scene
