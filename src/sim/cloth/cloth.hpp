#pragma once
#include "sim/core/simulation.hpp"
#include "sim/touch/touch.hpp"

#include <memory>

namespace simreel::sim {

/// Mass-spring cloth on the GPU: a grid of particles, 48 bytes each beside the index buffer.
[[nodiscard]] std::unique_ptr<Simulation> makeSheet(const scene::Object& object, const Setting& setting);
/// Throws what makeSheet would throw on any device.
void checkSheet(const scene::Object& object, const Setting& setting);

/// What a cloth meets beside its shapes, and the wind around it, of the plan of a sheet or a mesh.
template <class Plan>
Touch::Wanted touchedBy(const Plan& plan) {
  const auto& p = plan.parameters();
  return {.walls = p.walls,
          .wind = p.hasAir ? p.air.fluid : "",
          .margin = p.margin,
          .colliders = plan.colliderCount(),
          .substeps = plan.substeps(),
          .substepSeconds = plan.substepSeconds()};
}

}  // namespace simreel::sim
