#pragma once
#include "sim/core/simulation.hpp"
#include "sim/life/plan.hpp"

#include <memory>
#include <string>

namespace simreel::sim {

/// Creates an automaton with more than two states, one byte per cell.
[[nodiscard]] std::unique_ptr<Simulation> makeLifeStates(LifePlan plan, const std::string& name,
                                                         const Setting& setting);

}  // namespace simreel::sim
