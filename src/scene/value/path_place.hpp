#pragma once
#include "scene/value/animated.hpp"
#include "scene/value/fields.hpp"

#include <string>

namespace simreel::scene {

/// Position relative to a path that an object finds during the simulation.
struct PathPlace {
  std::string object;
  Animated<float> progress = 0.0F;  ///< fraction of the path's length
  float height = 1.5F;              ///< metres above the path
  float side = 0;                   ///< metres to the right of the direction of travel
  void describe(Fields& fields);
};

}  // namespace simreel::scene
