#pragma once
#include "gl/element_array.hpp"
#include "sim/core/port.hpp"

namespace simreel::sim {

/// Port of objects that consist of points with velocities, such as particles.
struct MovingPoints {
  static const PortInfo port;

  const gl::Vec4Array* positions = nullptr;   ///< xyz: position in metres
  const gl::Vec4Array* velocities = nullptr;  ///< xyz: velocity in m/s; w is negative for points that are
                                              ///< not alive
  int count = 0;
  float size = 0;   ///< diameter of a point in metres
  float speed = 0;  ///< maximum initial speed in m/s
};

}  // namespace simreel::sim
