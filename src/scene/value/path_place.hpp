#pragma once
#include "scene/value/animated.hpp"
#include "scene/value/fields.hpp"

#include <string>

namespace simreel::scene {

/// Position relative to a path that an object finds during the simulation.
struct PathPlace {
  std::string object;
  Animated<float> progress = 0.0F;  ///< position on the path as a fraction of its length
  float height = 1.5F;              ///< height above the path in metres
  float side = 0;                   ///< offset in metres from the path to the right, seen in the direction
                                    ///< of travel
  void describe(Fields& fields);
};

}  // namespace simreel::scene
