#pragma once
#include "sim/core/port.hpp"

namespace simreel::sim {

/// Port of what others touch: shapes, meshes, bodies, water, cloths in contact. It has no outlet: colliders
/// reach those that touch them by ports of their own.
struct Touchable {
  static const PortInfo port;
};

/// Port of objects that publish a path (sim/core/path.hpp), which a camera or a light may follow.
struct Way {
  static const PortInfo port;
};

/// Port of every object: a camera may look at its middle.
struct Middle {
  static const PortInfo port;
};

}  // namespace simreel::sim
