#pragma once
#include "scene/value/fields.hpp"

namespace simreel::scene {

/// Interface of the parameters of objects whose default place is beside the other objects, such as text.
class SetApart {
 public:
  virtual ~SetApart() = default;
  /// Moves the object above `others`, the box around the other objects in metres. Does nothing if the scene
  /// gives the object's place.
  virtual void standAbove(const Box& others) = 0;
};

}  // namespace simreel::scene
