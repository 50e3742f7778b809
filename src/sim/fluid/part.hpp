#pragma once
#include "gl/kernel/kernel.hpp"
#include "sim/fluid/plan.hpp"

namespace simreel::sim {

/// Part of a kernel interface: members of glsl/fluid/grid.glsl, except the cells.
struct FluidPart {
  gl::Block<"FluidBlock", shader::FluidStep> step;
  gl::Uniform<"size", glm::ivec2> size;
  gl::Block<"SolidBlock", shader::FluidSolidSet> solids;
  gl::Uniform<"solidsStart", int> solidsStart;
  gl::In<"weights"> weights;
};

}  // namespace simreel::sim
