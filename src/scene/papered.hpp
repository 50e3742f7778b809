#pragma once
#include <string>

namespace simreel::scene {

/// Interface of the parameters of objects that may be drawn in the colours of a simulated field.
class HasFieldSkin {
 public:
  virtual ~HasFieldSkin() = default;
  /// Returns the name of the object whose field is shown on this object if the material has no "skin".
  /// Returns an empty string if there is no such object. `object`: name of this object.
  [[nodiscard]] virtual std::string fieldShown(const std::string& object) const = 0;
};

}  // namespace simreel::scene
