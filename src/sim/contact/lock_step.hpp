#pragma once
#include "sim/contact/contact.hpp"
#include "sim/contact/solid.hpp"
#include "sim/core/simulation.hpp"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace simreel::sim {

/// A simulation whose substeps go in step with those of others that it touches, Simulation::stepsPerFrame()
/// of them a frame.
class LockStep {
 public:
  static const PortInfo port;

  virtual ~LockStep() = default;
  /// As it is at the start.
  [[nodiscard]] virtual ContactPart contactPart() const = 0;
  virtual void beginFrame(double time) = 0;
  /// Up to where its particles would go if nothing held them up.
  virtual void predict(int substep) = 0;
  /// After predict(); what contact has pushed since is to keep out of colliders again.
  virtual void settle(int substep) = 0;
  /// Between predict() and finish().
  [[nodiscard]] virtual Contact::Part arrays() const = 0;
  virtual void finish() = 0;
  virtual void endFrame(double time) = 0;
  /// The positions and velocities of arrays() are again as they were at beginFrame().
  virtual void restored() {}
};

/// Port of cloths that particles may meet by name. It has no outlet: both join LockStep.
struct ContactCloth {
  static const PortInfo port;
};

/// Simulations in step, and their contact with each other and with solids.
class ContactGroup final : public StepGroup {
 public:
  /// `members` and `solids` outlive it; `members`, balls last, take `substeps` a frame of `frameSeconds`.
  ContactGroup(std::vector<LockStep*> members, std::vector<ContactSolid*> solids, int substeps,
               double frameSeconds, bool fast);
  /// Advances all members by the frame that starts at `time`, which the solids have stepped.
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
