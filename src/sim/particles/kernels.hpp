#pragma once
#include "gl/kernel/kernel.hpp"
#include "sim/particles/parameters.hpp"
#include "sim/touch/touch.hpp"

namespace simreel::sim {

/// Part of a kernel interface: inputs common to all particle kernels (glsl/particles/kernel.glsl).
struct ParticlePart {
  gl::Block<"StepBlock", shader::ParticleStep> step;
  TouchPart touch;
  gl::InOut<"StatusBlock"> status;
  gl::InOut<"positions"> positions;
  gl::InOut<"velocities"> velocities;
  gl::InOut<"spins"> spins = {};  ///< of balls that turn
};
struct ParticleFields {
  gl::Switch<"ATTRACTOR"> attractor;
  gl::Switch<"TURBULENCE"> turbulence;
};
struct ParticleSolids {
  TouchVariant touch;
  gl::Switch<"SOLIDS"> solids;  // true if there are collider shapes or meshes
  gl::Flag<"ROLLS"> rolls;      // true for balls that turn
};

struct ParticleKick {
  static constexpr auto file = "particles/kick.comp";
  struct Variant {
    gl::Flag<"WIND"> wind;
    ParticleFields fields;
  };
  ParticlePart part;
  gl::InOut<"accelerations"> accelerations;
};

/// Interface of the kernel that computes a substep of mutually attracting particles, without the second
/// kick.
struct ParticleDrift {
  static constexpr auto file = "particles/drift.comp";
  using Variant = ParticleSolids;
  ParticlePart part;
  gl::InOut<"accelerations"> accelerations;
};

/// Kernel for a whole substep of particles that do not attract each other.
struct ParticleWhole {
  static constexpr auto file = "particles/step.comp";
  struct Variant {
    ParticleSolids solids;
    ParticleFields fields;
  };
  ParticlePart part;
  gl::InOut<"accelerations"> accelerations;
};

struct ParticleBirth {
  static constexpr auto file = "particles/birth.comp";
  struct Variant {
    ParticleSolids solids;
    ParticleFields fields;
    gl::Flag<"ATTRACTS"> attracts;
  };
  ParticlePart part;
  gl::InOut<"accelerations"> accelerations;
};

struct ParticleKeep {
  static constexpr auto file = "particles/keep.comp";
  gl::Uniform<"count", int> count;
  gl::In<"starts"> starts;
  gl::Out<"positions"> positions;
};

struct ParticleSettle {
  static constexpr auto file = "particles/settle.comp";
  using Variant = ParticleSolids;
  ParticlePart part;
  gl::In<"starts"> starts;
};

}  // namespace simreel::sim
