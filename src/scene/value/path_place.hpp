#pragma once
#include "scene/value/animated.hpp"
#include "scene/value/fields.hpp"

#include <string>

namespace simreel::scene {

/// A place by the path that an object has found, wherever that turns out to be.
struct PathPlace {
  std::string object;
  Animated<float> progress = 0.0F;  ///< fraction of the path's length
  float height = 1.5F;              ///< m over the path
  float side = 0;                   ///< m to the right of the way
  void describe(Fields& fields);
};

}  // namespace simreel::scene
