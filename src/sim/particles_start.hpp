#pragma once
#include "sim/particles_plan.hpp"

namespace simreel::sim {

/// The particles of a group about its own middle, unrotated and at rest as a whole: a ball, cube, Plummer
/// sphere in equilibrium or rotating disk, then the particle in the middle if there is one. Every random
/// number is an integer hash of (particle, group, seed). `gravity` and `softening` as in
/// ParticleParameters.
[[nodiscard]] ParticleCloud startGroup(const ParticleGroup& group, int groupIndex, int seed, float gravity,
                                       float softening);

/// Rotates the cloud, then moves it to the group's position and velocity.
void placeGroup(ParticleCloud& cloud, const ParticleGroup& group);

}  // namespace simreel::sim
