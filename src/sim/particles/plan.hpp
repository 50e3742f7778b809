#pragma once
#include "sim/collide/colliders.hpp"
#include "sim/contact/plan.hpp"
#include "sim/core/carry_over.hpp"
#include "sim/particles/parameters.hpp"

#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

struct Companion;

/// State of particles at one time. Positions: xyz in m, w the mass in kg (0 if not alive). Velocities: xyz
/// in m/s, w the age as a fraction of life from 0 to 1 (negative if not alive).
struct ParticleCloud {
  std::vector<glm::vec4> positions;
  std::vector<glm::vec4> velocities;
};

/// The part of a particle simulation that the CPU computes: the initial state and the uniform data of each
/// substep. The GPU simulation and its CPU reference both use it. After the start, the cost does not depend
/// on the number of particles.
class ParticlePlan {
 public:
  /// Reads the groups' files. Throws UserError(usage) for a file without usable particles, for more than
  /// `maxParticles` slots, and for more `colliders` than the kernels support. Ignores the colliders if the
  /// particles do not collide.
  ParticlePlan(ParticleParameters parameters, int seed, double frameSeconds, int maxParticles = 1 << 24,
               const std::vector<ColliderShape>& colliders = {});

  /// Returns the number of slots: the particles of all groups in order, followed by a ring buffer of slots
  /// for each emitter.
  [[nodiscard]] int count() const { return count_; }
  /// Returns the number of particles in a group that have equal mass, that is, without the central
  /// particle.
  [[nodiscard]] int groupCount(std::size_t group) const;
  /// Returns the initial state: the particles of the groups, followed by empty slots for the emitters.
  [[nodiscard]] ParticleCloud firstCloud() const;
  /// Returns the mass in kg of a particle of nominal size, taken from the first group, else from the first
  /// emitter.
  [[nodiscard]] float massReference() const;
  /// Returns the maximum speed in m/s of the particles in `cloud` and of newly emitted particles.
  [[nodiscard]] float fastestAtStart(const ParticleCloud& cloud) const;
  /// Returns the description of the particles for contact with cloths.
  [[nodiscard]] ContactPart contactPart() const;
  /// Returns the step data for a kick of zero length at `time` (seconds), used to compute the initial
  /// accelerations.
  [[nodiscard]] shader::ParticleStep prime(double time) const;
  /// Returns the data of the substeps of the frame that starts at `time` (seconds). Frames must be
  /// requested in order, because emitters continue from the previous frame.
  [[nodiscard]] std::vector<shader::ParticleStep> frame(double time);
  void visitCheckpointData(CarryOver& carry) {
    carry.number("steps begun", done_);
    for (Ring& ring : rings_) {
      carry.number("born", ring.born);
      carry.number("first birth", ring.begin);
      carry.number("births begun", ring.started);
    }
  }

  /// Returns true if the particles are balls that turn.
  [[nodiscard]] bool rolls() const { return parameters_.contact && parameters_.contact->rolls; }
  /// Returns the constants of contact that do not change with time.
  [[nodiscard]] const shader::BallConstants& ballConstants() const { return balls_; }
  /// Returns the most impacts of one ball in a substep. An impulse that has passed through this many pairs
  /// is below a tenth, unless the limit of 8 applies.
  [[nodiscard]] int ballImpacts() const;
  [[nodiscard]] const ParticleParameters& parameters() const { return parameters_; }
  [[nodiscard]] double substepSeconds() const { return substepSeconds_; }
  /// Returns the number of colliders, which is the same in every step.
  [[nodiscard]] int colliderCount() const { return colliders_.count(); }

 private:
  [[nodiscard]] shader::BallConstants planBalls() const;
  [[nodiscard]] std::vector<Companion> companionsOf(std::size_t group) const;
  struct Ring {
    int first = 0;
    int size = 0;
    long long born = 0;    ///< number of particles born so far
    double begin = 0;      ///< time in seconds from which births are counted
    bool started = false;  ///< true once `begin` is set
  };

  [[nodiscard]] shader::ParticleFields fields(double time) const;
  [[nodiscard]] shader::ParticleStep between(double start, double end) const;
  void births(shader::EmitterStep& step, const Emitter& emitter, Ring& ring, double start,
              double end) const;

  ParticleParameters parameters_;
  int seed_;
  double substepSeconds_;
  ColliderPlan colliders_;
  std::vector<ParticleCloud> files_;  ///< content of each group's file; empty for groups without a file
  std::vector<Ring> rings_;
  shader::BallConstants balls_;
  int count_ = 0;
  int done_ = 0;  ///< number of substeps of all frames requested so far
};

}  // namespace simreel::sim
