#pragma once
#include "sim/core/carry_over.hpp"

#include <optional>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Position y that follows a position x like a critically damped spring, y'' = w^2 (x - y) - 2 w y' with w
/// = 2 / T. If x has constant velocity, y lags by the time T. x moves linearly from frame to frame; for
/// such x the equation is solved exactly, so y does not depend on how many frames lie between two times.
class Lag {
 public:
  /// `damping` is T in seconds and must be above 0. `frameSeconds` is the duration of a frame.
  Lag(double damping, double frameSeconds);

  /// Sets x of the next frame and advances y. In the first frame y starts at x with zero velocity.
  void follow(const glm::dvec3& x);
  /// Discards the position because the target has disappeared. The target's next position counts as its
  /// first.
  void lose() { known_ = 0; }
  /// Returns y; empty while there is no target.
  [[nodiscard]] std::optional<glm::vec3> place() const {
    return known_ == 0 ? std::nullopt : std::optional(glm::vec3(place_));
  }
  void visitCheckpointData(CarryOver& carry);

 private:
  double damping_, seconds_, rate_, decay_;
  int known_ = 0;  ///< number of previous positions of x that are known: 0 before the first frame and after
                   ///< lose(), otherwise 1
  glm::dvec3 target_{0}, place_{0}, speed_{0};
};

}  // namespace simreel::sim
