#pragma once
#include "sim/core/simulation.hpp"
#include "sim/touch/touch.hpp"

#include <memory>

namespace simreel::sim {

/// Creates a mass-spring cloth on the GPU: a grid of particles with 48 bytes per particle, plus the index
/// buffer.
[[nodiscard]] std::unique_ptr<Simulation> makeSheet(const scene::Object& object, const Setting& setting);
/// Throws those errors of makeSheet() that do not depend on the device.
void checkSheet(const scene::Object& object, const Setting& setting);

/// Returns the scene objects that a cloth collides with in addition to its analytic colliders, and the wind
/// around it.
template <class Plan>
Touch::Wanted touchedBy(const Plan& plan) {
  const auto& p = plan.parameters();
  return {.walls = p.walls,
          .wind = p.air ? p.air->fluid : "",
          .margin = p.margin,
          .colliders = plan.colliderCount(),
          .substeps = plan.substeps(),
          .substepSeconds = plan.substepSeconds()};
}

}  // namespace simreel::sim
