#pragma once
#include "sim/fluid/part.hpp"

/// Interfaces of the kernels of the pressure solver.
namespace simreel::sim {

/// Part of a kernel interface: members of glsl/fluid/solver/levels.glsl.
struct FluidLevelPart {
  gl::Block<"LevelBlock", shader::FluidLevelPlace> level;
  gl::In<"pool"> pool;
  gl::In<"raisedPool"> raised;
  gl::In<"weights"> weights;
};
struct FluidTiles {
  gl::Choice<"IN_THE_OPEN", 0, 1, 2> open;  // Tiles that the kernel processes: 0 for the tiles that are not
                                            // open, 1 for the open tiles, 2 for both.
};
struct FluidTileGroups {
  gl::Choice<"IN_THE_OPEN", 0, 1, 2> open;
  gl::Flag<"TILE_A_GROUP"> tileAGroup;
};

struct FluidDescend {
  static constexpr auto file = "fluid/solver/descend.comp";
  using Variant = FluidTileGroups;
  FluidLevelPart part;
  gl::Out<"PoolOutBlock"> poolOut;
  gl::Out<"RaisedOutBlock"> raisedOut;
};

struct FluidAscend {
  static constexpr auto file = "fluid/solver/ascend.comp";
  using Variant = FluidTileGroups;
  FluidLevelPart part;
  gl::Out<"RaisedOutBlock"> raisedOut;
};

struct FluidResidual {
  static constexpr auto file = "fluid/solver/residual.comp";
  using Variant = FluidTileGroups;
  FluidLevelPart part;
  gl::Out<"PoolOutBlock"> poolOut;
  gl::InOut<"ControlBlock"> control;
};

struct FluidBottom {
  static constexpr auto file = "fluid/solver/bottom.comp";
  using Variant = FluidTiles;
  FluidLevelPart part;
  gl::Out<"RaisedOutBlock"> raisedOut;
};

struct FluidDivergence {
  static constexpr auto file = "fluid/solver/divergence.comp";
  FluidPart part;
  gl::Uniform<"rhsStart", int> rhsStart;
  gl::In<"flow"> flow;
  gl::Out<"PoolOutBlock"> poolOut;
  gl::InOut<"ControlBlock"> control;
};

struct FluidDecide {
  static constexpr auto file = "fluid/solver/decide.comp";
  struct Variant {
    gl::Flag<"JUDGE"> judge;
  };
  gl::Uniform<"dispatches", int> dispatches;
  gl::Uniform<"first", int> first;
  gl::Uniform<"tolerance", float> tolerance;
  gl::Uniform<"maxSpeed", float> maxSpeed;
  gl::InOut<"StatusBlock"> status;
  gl::InOut<"ControlBlock"> control;
};

struct FluidCoarse {
  static constexpr auto file = "fluid/solver/coarse.comp";
  static constexpr std::size_t maximum =
      4;  // Maximum number of multigrid levels that coarse.comp processes.
  struct Variant {
    gl::Flag<"SUBGROUPS"> subgroups;
  };
  gl::Uniforms<"levels", glm::ivec4, maximum> levels;
  gl::Uniform<"levelCount", int> levelCount;
  gl::Uniform<"rhsStart", int> rhsStart;
  gl::Uniform<"upStart", int> upStart;
  gl::In<"PoolBlock"> pool;
  gl::In<"weights"> weights;
  gl::Out<"RaisedOutBlock"> raisedOut;
};

struct FluidDown {
  static constexpr auto file = "fluid/solver/down.comp";
  static constexpr std::size_t maximum = 3;  // Maximum number of multigrid levels that down.comp processes.
  struct Variant {
    gl::Range<"LEVELS", 1, maximum> levels;
  };
  gl::Uniforms<"levels", glm::ivec4, maximum + 1> levels;
  gl::Uniform<"rhsStart", int> rhsStart;
  gl::Uniform<"wayStart", int> wayStart;
  gl::In<"PoolBlock"> pool;
  gl::In<"weights"> weights;
  gl::Out<"PoolOutBlock"> poolOut;
  gl::Out<"RaisedOutBlock"> raisedOut;
};

struct FluidUp {
  static constexpr auto file = "fluid/solver/up.comp";
  static constexpr std::size_t maximum = 4;  // Maximum number of multigrid levels that up.comp processes.
  struct Variant {
    gl::Range<"LEVELS", 1, maximum> levels;
  };
  gl::Uniforms<"levels", glm::ivec4, maximum + 1> levels;
  gl::Uniform<"rhsStart", int> rhsStart;
  gl::Uniform<"wayStart", int> wayStart;
  gl::In<"PoolBlock"> pool;
  gl::In<"RaisedBlock"> raised;
  gl::In<"weights"> weights;
  gl::Out<"RaisedOutBlock"> raisedOut;
};

}  // namespace simreel::sim
