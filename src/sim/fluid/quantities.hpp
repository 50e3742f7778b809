#pragma once
#include "sim/fluid/plan.hpp"
#include "sim/fluid/pressure.hpp"

#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// FluidParameters::quantities() of a state, in that order. `flow` and `dye`: cells with their ring, as the
/// kernels hold them.
[[nodiscard]] std::vector<double> measureFluid(const FluidPlan& plan, std::span<const glm::vec4> flow,
                                               std::span<const glm::vec4> dye,
                                               const FluidPressure::Report& report);

/// Cells that are no obstacle, and corners between four such cells: what means are taken over.
struct FluidCells {
  long open = 0, corners = 0;
};
[[nodiscard]] FluidCells openCells(const FluidPlan& plan);

}  // namespace simreel::sim
