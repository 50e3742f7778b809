#pragma once
#include "sim/contact/contact.hpp"
#include "sim/contact/solid.hpp"
#include "sim/core/simulation.hpp"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace simreel::sim {

/// Simulation that advances in lock step with the simulations that it touches. A frame has
/// Simulation::stepsPerFrame() substeps.
class LockStep {
 public:
  static const PortInfo port;

  virtual ~LockStep() = default;
  /// Returns the contact surface in the initial state.
  [[nodiscard]] virtual ContactPart contactPart() const = 0;
  virtual void beginFrame(double time) = 0;
  /// Computes the positions that the vertices would reach in the substep without contact.
  virtual void predict(int substep) = 0;
  /// Called after predict() and contact. Moves vertices that contact has pushed into colliders back out of
  /// the colliders.
  virtual void settle(int substep) = 0;
  /// Returns the arrays for contact; valid between predict() and finish().
  [[nodiscard]] virtual Contact::Part arrays() const = 0;
  virtual void finish() = 0;
  virtual void endFrame(double time) = 0;
  /// Called after the positions and velocities of arrays() were reset to their contents at beginFrame().
  virtual void restored() {}
};

/// Port of cloths that particles can collide with by name. The cloth and the particles interact through
/// LockStep, so no object provides an interface for this port.
struct ContactCloth {
  static const PortInfo port;
};

/// Group of simulations in lock step, with the contact between them and with solids.
class ContactGroup final : public StepGroup {
 public:
  /// `members` and `solids` must outlive the group. `members` take `substeps` substeps per frame of
  /// `frameSeconds` seconds; particles must be the last members.
  ContactGroup(std::vector<LockStep*> members, std::vector<ContactSolid*> solids, int substeps,
               double frameSeconds, bool fast);
  /// Advances all members by the frame that starts at `time`. The solids must already have stepped this
  /// frame.
  void step(double time, const Watch& watch) override;

 private:
  [[nodiscard]] std::vector<Contact::Part> parts() const;
  void substeps(const Watch& watch);

  std::vector<LockStep*> members_;
  std::vector<ContactSolid*> solids_;
  int substeps_;
  Contact contact_;
};

}  // namespace simreel::sim
