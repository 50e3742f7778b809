#pragma once
#include "sim/particles/plan.hpp"

#include <span>

namespace simreel::sim {

/// A mass that sits in the middle of a group besides its own: another group, or the attractor. Taken as a
/// Plummer sphere.
struct Companion {
  float mass = 0;    ///< kg
  float radius = 0;  ///< m, Plummer's a
};

/// The particles of a group about its own middle, unrotated and at rest as a whole: a ball, cube, Plummer
/// sphere in equilibrium or rotating disk, then the particle in the middle if there is one. Every random
/// number is an integer hash of (particle, group, seed). `gravity` and `softening` as in
/// ParticleParameters. Disks turn as fast as their own mass and the companions' ask for.
[[nodiscard]] ParticleCloud startGroup(const ParticleGroup& group, int groupIndex, int seed, float gravity,
                                       float softening, std::span<const Companion> companions);

/// Rotates the cloud, then moves it to the group's position and velocity.
void placeGroup(ParticleCloud& cloud, const ParticleGroup& group);

}  // namespace simreel::sim
