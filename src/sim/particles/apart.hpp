#pragma once
#include "sim/particles/plan.hpp"

namespace simreel::sim {

/// Moves overlapping particles apart before the first frame. Both particles of a pair move by the same
/// distance, and their velocities do not change. The pairs are processed in the order of grid cells, so the
/// result does not depend on the machine.
void moveApart(ParticleCloud& cloud, const shader::BallConstants& balls);

}  // namespace simreel::sim
