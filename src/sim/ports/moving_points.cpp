#include "sim/ports/moving_points.hpp"

namespace simreel::sim {

constinit const PortInfo MovingPoints::port = {
    .name = "moving points",
    .lacks = ", which has no velocities to draw",
    .none = "nothing in the scene moves as points; add particles",
};

}  // namespace simreel::sim
