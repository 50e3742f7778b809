#pragma once
#include "gl/element_array.hpp"
#include "sim/core/port.hpp"

namespace simreel::sim {

/// Port of objects that are points with velocities, such as particles.
struct MovingPoints {
  static const PortInfo port;

  const gl::Vec4Array* positions = nullptr;   ///< x, y, z: place in metres
  const gl::Vec4Array* velocities = nullptr;  ///< x, y, z: m/s; w is negative for points that do not live
  int count = 0;
  float size = 0;   ///< diameter of a point in metres
  float speed = 0;  ///< greatest speed at the start in m/s
};

}  // namespace simreel::sim
