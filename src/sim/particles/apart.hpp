#pragma once
#include "sim/particles/plan.hpp"

namespace simreel::sim {

/// Moves particles that overlap apart, before the first frame, each pair by equal parts. Velocities stay.
/// Cells of a grid are visited in order, so the result does not depend on the machine.
void moveApart(ParticleCloud& cloud, const shader::BallConstants& balls);

}  // namespace simreel::sim
