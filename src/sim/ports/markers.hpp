#pragma once
#include "sim/core/port.hpp"

namespace simreel::sim {

/// Port of objects that others can collide with: shapes, meshes, bodies, water, cloths in contact. It
/// provides no interface, because each kind of collider has another port for that.
struct Touchable {
  static const PortInfo port;
};

/// Port of objects that publish a path (sim/core/path.hpp) for cameras and lights to follow.
struct PathPort {
  static const PortInfo port;
};

/// Port of every object for its centre, at which a camera may aim.
struct CentrePort {
  static const PortInfo port;
};

}  // namespace simreel::sim
