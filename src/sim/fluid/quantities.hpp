#pragma once
#include "sim/fluid/plan.hpp"
#include "sim/fluid/pressure.hpp"

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Force (cells^3/s^2, y down) of a fluid on obstacles, divided by the density, for a depth of one cell.
struct FluidForce {
  glm::dvec2 pressure{0}, friction{0};
  [[nodiscard]] glm::dvec2 all() const { return pressure + friction; }
};

/// Returns the force on the measured obstacles. In each cell at a wall, adds the pressure times the wall's
/// part of the cell, from the faces' openings, and the friction from a parabola through the wall's velocity
/// and two points away from the wall. `flow`: cells with their ring.
[[nodiscard]] FluidForce forceOn(const FluidParameters& p, const FluidSolids& solids, double viscosity,
                                 std::span<const glm::vec4> flow);

/// Returns the values of FluidParameters::quantities() for a state, in that order. `flow` and `dye`: cells
/// with their ring, in the kernels' element order.
[[nodiscard]] std::vector<double> measureFluid(const FluidPlan& plan, const FluidSolids& solids,
                                               std::span<const glm::vec4> flow,
                                               std::span<const glm::vec4> dye,
                                               const FluidPressure::Report& report, double time);

/// Numbers of cells that are not solid, and of corners between four such cells: the divisors of means.
/// `solid`: one byte per cell (FluidSolids::solid).
struct FluidCells {
  long open = 0, corners = 0;
};
[[nodiscard]] FluidCells openCells(glm::ivec2 size, const std::vector<std::uint8_t>& solid);

}  // namespace simreel::sim
