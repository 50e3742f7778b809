#pragma once
#include "sim/particles/plan.hpp"

#include <span>

namespace simreel::sim {

/// Additional mass at the centre of a group: another group or the attractor. It is treated as a Plummer
/// sphere.
struct Companion {
  float mass = 0;    ///< mass in kg
  float radius = 0;  ///< Plummer scale radius a in metres
};

/// Returns the particles of a group in the group's local space, relative to its centre and without its
/// velocity: a ball, a cube, a Plummer sphere in equilibrium or a rotating disk, followed by the central
/// particle if there is one. Every random number is an integer hash of (particle, group, seed). For
/// `gravity` and `softening`, see ParticleParameters. The rotation speed of a disk follows from its mass
/// and the masses of the companions.
[[nodiscard]] ParticleCloud startGroup(const ParticleGroup& group, int groupIndex, int seed, float gravity,
                                       float softening, std::span<const Companion> companions);

/// Rotates the cloud, then adds the group's position and velocity.
void placeGroup(ParticleCloud& cloud, const ParticleGroup& group);

}  // namespace simreel::sim
