#pragma once
#include "sim/core/port.hpp"

namespace simreel::sim {

/// Port of objects to collide with: shapes, meshes, bodies, water, cloths in contact. It has no outlet,
/// because colliders have ports of their own.
struct Touchable {
  static const PortInfo port;
};

/// Port of objects that publish a path (sim/core/path.hpp), which a camera or a light may follow.
struct Way {
  static const PortInfo port;
};

/// Port of every object: its centre, which a camera may look at.
struct Middle {
  static const PortInfo port;
};

}  // namespace simreel::sim
