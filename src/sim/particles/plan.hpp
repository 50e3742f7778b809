#pragma once
#include "sim/collide/colliders.hpp"
#include "sim/contact/plan.hpp"
#include "sim/core/carry_over.hpp"
#include "sim/particles/parameters.hpp"

#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

struct Companion;

/// Particles at one moment: positions xyz in m, w mass in kg (0: not alive); velocities xyz in m/s, w age 0
/// to 1 (negative: not alive).
struct ParticleCloud {
  std::vector<glm::vec4> positions;
  std::vector<glm::vec4> velocities;
};

/// Everything of a particle simulation that is decided on the CPU: the first state, and what each substep
/// is told. Shared by the GPU simulation and its CPU twin. After the start nothing here depends on the
/// number of particles.
class ParticlePlan {
 public:
  /// Reads the groups' files. Throws UserError(usage) for a file that holds no usable particles or when
  /// there are more than `maxParticles` slots, or more `colliders` than the kernels hold where they
  /// collide; those of particles that do not are left out.
  ParticlePlan(ParticleParameters parameters, int seed, double frameSeconds, int maxParticles = 1 << 24,
               const std::vector<ColliderShape>& colliders = {});

  /// Slots: the groups' particles in order, then a ring of slots for each emitter.
  [[nodiscard]] int count() const { return count_; }
  /// Equal particles of a group, the one in its middle not counted.
  [[nodiscard]] int groupCount(std::size_t group) const;
  /// The groups' particles and empty slots.
  [[nodiscard]] ParticleCloud firstCloud() const;
  /// As cloths in contact see them at the start.
  [[nodiscard]] ContactPart contactPart() const;
  /// What the kick is told that finds the first accelerations, at `time` (s), and changes nothing else.
  [[nodiscard]] shader::ParticleStep prime(double time) const;
  /// The substeps of the frame that starts at `time` (s). Call in order: emitters go on where they were.
  [[nodiscard]] std::vector<shader::ParticleStep> frame(double time);
  void carryOver(CarryOver& carry) {
    carry.number("steps begun", done_);
    for (Ring& ring : rings_) {
      carry.number("born", ring.born);
      carry.number("first birth", ring.begin);
      carry.number("births begun", ring.started);
    }
  }

  [[nodiscard]] const ParticleParameters& parameters() const { return parameters_; }
  [[nodiscard]] double substepSeconds() const { return substepSeconds_; }
  /// The same in every step.
  [[nodiscard]] int colliderCount() const { return colliders_.count(); }

 private:
  [[nodiscard]] std::vector<Companion> companionsOf(std::size_t group) const;
  struct Ring {
    int first = 0;
    int size = 0;
    long long born = 0;    ///< so far
    double begin = 0;      ///< s, when the first one may be born
    bool started = false;  ///< begin is known
  };

  [[nodiscard]] shader::ParticleFields fields(double time) const;
  [[nodiscard]] shader::ParticleStep between(double start, double end) const;
  void births(shader::EmitterStep& step, const Emitter& emitter, Ring& ring, double start,
              double end) const;

  ParticleParameters parameters_;
  int seed_;
  double substepSeconds_;
  ColliderPlan colliders_;
  std::vector<ParticleCloud> files_;  ///< one for each group, empty unless it is a file
  std::vector<Ring> rings_;
  int count_ = 0;
  int done_ = 0;  ///< substeps so far
};

}  // namespace simreel::sim
