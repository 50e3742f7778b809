#pragma once
#include "scene/scene.hpp"

namespace simreel::sim {

/// Simulation whose parameters can change during a run.
class Retunable {
 public:
  virtual ~Retunable() = default;
  /// Adopts the parameters `now` (of the same kind) if they differ from the current ones only in values
  /// that are read in every frame and that determine no array and no kernel. The simulation then continues
  /// from its current state. Otherwise returns false and changes nothing; the simulation must then be
  /// recreated.
  [[nodiscard]] virtual bool retune(const scene::Parameters& now) = 0;
};

}  // namespace simreel::sim
