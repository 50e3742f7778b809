#include "sim/world/lag.hpp"

#include "base/ieee.hpp"

namespace simreel::sim {

Lag::Lag(double damping, double frameSeconds)
    : damping_(damping),
      seconds_(frameSeconds),
      rate_(2 / damping),
      decay_(ieee::exp(-rate_ * frameSeconds)) {}

// If x has the velocity v, then z = y - (x - v T) obeys z'' = -w^2 z - 2 w z'. From the initial values z0
// and z0', after the time h, z = (z0 + (z0' + w z0) h) e^-wh and z' = (z0' - w (z0' + w z0) h) e^-wh.
void Lag::follow(const glm::dvec3& x) {
  if (known_ == 0) {
    known_ = 1;
    target_ = place_ = x;
    speed_ = glm::dvec3(0);
    return;
  }
  const glm::dvec3 steady = (x - target_) / seconds_;
  const glm::dvec3 off = place_ - (target_ - steady * damping_);
  const glm::dvec3 offSpeed = speed_ - steady;
  const glm::dvec3 pull = offSpeed + rate_ * off;
  place_ = x - steady * damping_ + (off + pull * seconds_) * decay_;
  speed_ = steady + (offSpeed - rate_ * seconds_ * pull) * decay_;
  target_ = x;
}

void Lag::visitCheckpointData(CarryOver& carry) {
  carry.number("known", known_);
  for (glm::dvec3* each : {&target_, &place_, &speed_})
    for (int i = 0; i < 3; ++i) carry.number("lag", (*each)[i]);
}

}  // namespace simreel::sim
