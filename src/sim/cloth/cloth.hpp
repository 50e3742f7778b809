#pragma once
#include "sim/core/simulation.hpp"

#include <memory>

namespace simreel::sim {

/// Mass-spring cloth on the GPU: a grid of particles, 48 bytes each beside the index buffer.
[[nodiscard]] std::unique_ptr<Simulation> makeSheet(const scene::Object& object, const Setting& setting);
/// Throws what makeSheet would throw on any device.
void checkSheet(const scene::Object& object, const Setting& setting);

}  // namespace simreel::sim
