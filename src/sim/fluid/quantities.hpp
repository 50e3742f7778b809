#pragma once
#include "sim/fluid/plan.hpp"
#include "sim/fluid/pressure.hpp"

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Force of a fluid on obstacles per density and per cell of depth, in cells^3/s^2 (y points down).
struct FluidForce {
  glm::dvec2 pressure{0}, friction{0};
  [[nodiscard]] glm::dvec2 all() const { return pressure + friction; }
};

/// Returns the force on the measured obstacles. For each cell at a wall, adds the pressure times the length
/// of wall in the cell, computed from the openings of the cell's faces, and the friction from a parabola
/// through the wall's velocity and the velocities at two points away from the wall. `flow` holds the cells
/// including the ring.
[[nodiscard]] FluidForce forceOn(const FluidParameters& p, const FluidSolids& solids, double viscosity,
                                 std::span<const glm::vec4> flow);

/// Returns the values of FluidParameters::quantities() for a state, in the order of quantities(). `flow`
/// and `dye` hold the cells including the ring, in the kernels' element order.
[[nodiscard]] std::vector<double> measureFluid(const FluidPlan& plan, const FluidSolids& solids,
                                               std::span<const glm::vec4> flow,
                                               std::span<const glm::vec4> dye,
                                               const FluidPressure::Report& report, double time);

/// Number of cells that are not solid, and number of corners between four such cells; means are divided by
/// these numbers. `solid` has one byte per cell (FluidSolids::solid).
struct FluidCells {
  long open = 0, corners = 0;
};
[[nodiscard]] FluidCells openCells(glm::ivec2 size, const std::vector<std::uint8_t>& solid);

}  // namespace simreel::sim
