#pragma once
#include "sim/core/carry_over.hpp"

#include <optional>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// A place y that goes after a place x as a critically damped spring pulls it, y'' = w^2 (x - y) - 2 w y',
/// w = 2 / T: what x does steadily y does T later. x goes straight from one frame to the next, and for such
/// x the equation is solved exactly, so that y does not depend on how many frames there are meanwhile.
class Lag {
 public:
  /// `damping`: T (s), above 0. `frameSeconds`: from one frame to the next.
  Lag(double damping, double frameSeconds);

  /// Where x is in the next frame; in the first one y is there, too, and at rest.
  void follow(const glm::dvec3& x);
  /// Of what is not there any more: the next place is the first one again.
  void lose() { known_ = 0; }
  /// Nothing while x is not there.
  [[nodiscard]] std::optional<glm::vec3> place() const {
    return known_ == 0 ? std::nullopt : std::optional(glm::vec3(place_));
  }
  void carryOver(CarryOver& carry);

 private:
  double damping_, seconds_, rate_, decay_;
  int known_ = 0;  ///< whether there was a frame
  glm::dvec3 target_{0}, place_{0}, speed_{0};
};

}  // namespace simreel::sim
