#pragma once
#include "scene/value/fields.hpp"

#include <optional>

namespace simreel::scene {

/// Interface of the parameters of objects of which an automatic camera shows only a part, unless the scene
/// has other objects.
class FramedInPart {
 public:
  virtual ~FramedInPart() = default;
  /// Returns the extent of the whole object, or nullopt if Parameters::framed() always applies.
  [[nodiscard]] virtual std::optional<Box> framedWhole() const = 0;
};

}  // namespace simreel::scene
