#pragma once
#include "scene/scene.hpp"

namespace simreel::sim {

/// Simulation whose parameters can change during a run.
class Retunable {
 public:
  virtual ~Retunable() = default;
  /// Adopts the parameters `now` (of the same kind) if they differ only in values that are read anew each
  /// frame and that determine no array or kernel. The simulation continues from its current state.
  /// Otherwise returns false without any change; the simulation must then be recreated.
  [[nodiscard]] virtual bool retune(const scene::Parameters& now) = 0;
};

}  // namespace simreel::sim
