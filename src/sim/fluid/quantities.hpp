#pragma once
#include "sim/fluid/plan.hpp"
#include "sim/fluid/pressure.hpp"

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Force (cells^3/s^2, y down) of a fluid on obstacles: over its density, a cell deep.
struct FluidForce {
  glm::dvec2 pressure{0}, friction{0};
  [[nodiscard]] glm::dvec2 all() const { return pressure + friction; }
};

/// On the obstacles that are measured: in each cell at a wall its pressure on the wall's part of it, as the
/// faces' openings have it, and the friction of what a parabola through the wall and two points off it
/// says. `flow`: cells with their ring.
[[nodiscard]] FluidForce forceOn(const FluidParameters& p, const FluidSolids& solids, double viscosity,
                                 std::span<const glm::vec4> flow);

/// FluidParameters::quantities() of a state, in that order. `flow` and `dye`: cells with their ring, as the
/// kernels hold them.
[[nodiscard]] std::vector<double> measureFluid(const FluidPlan& plan, const FluidSolids& solids,
                                               std::span<const glm::vec4> flow,
                                               std::span<const glm::vec4> dye,
                                               const FluidPressure::Report& report, double time);

/// Cells that are no obstacle, and corners between four such cells: what means are taken over. `solid`: a
/// byte a cell, as FluidSolids has them.
struct FluidCells {
  long open = 0, corners = 0;
};
[[nodiscard]] FluidCells openCells(glm::ivec2 size, const std::vector<std::uint8_t>& solid);

}  // namespace simreel::sim
