#pragma once
#include "sim/fluid/part.hpp"

#include <array>

/// Interfaces of the fluid's kernels. The interfaces of the pressure solver are in solver_interfaces.hpp.
namespace simreel::sim {

struct FluidPush {
  static constexpr auto file = "fluid/push.comp";
  FluidPart part;
  gl::In<"flow"> flow;
  gl::Out<"nextFlow"> next;
  gl::InOut<"ControlBlock"> control;
  gl::InOut<"KeptBlock"> kept;
};

struct FluidCarry {
  static constexpr auto file = "fluid/carry.comp";
  FluidPart part;
  gl::In<"flow"> flow;
  gl::Out<"nextFlow"> next;
};

struct FluidCorrect {
  static constexpr auto file = "fluid/correct.comp";
  FluidPart part;
  gl::In<"flow"> flow;
  gl::In<"carried"> carried;
  gl::In<"dye"> dye;
  gl::InOut<"nextFlow"> next;
  gl::InOut<"KeptBlock"> kept;
};

struct FluidFastest {
  static constexpr auto file = "fluid/fastest.comp";
  FluidPart part;
  gl::In<"flow"> flow;
  gl::InOut<"ControlBlock"> control;
};

struct FluidOpenVariant {
  gl::Switch<"IN_THE_OPEN"> open;
};

struct FluidProject {
  static constexpr auto file = "fluid/project.comp";
  using Variant = FluidOpenVariant;
  FluidPart part;
  gl::Uniform<"tilesStart", int> tilesStart = {};
  gl::Uniform<"number", unsigned> number;
  gl::Uniform<"lostSpeed", float> lostSpeed;
  gl::Uniform<"heatStart", int> heatStart;
  gl::In<"flow"> flow;
  gl::In<"pool"> pool;
  gl::InOut<"nextFlow"> next;
  gl::InOut<"KeptBlock"> kept;
  gl::InOut<"SettlingBlock"> settling;
  gl::InOut<"HeatBlock"> heat;
  gl::InOut<"ControlBlock"> control;
  gl::InOut<"StatusBlock"> status;
};

struct FluidProjectOpen {
  static constexpr auto file = "fluid/project_open.comp";
  FluidPart part;
  gl::Uniform<"tilesStart", int> tilesStart = {};
  gl::InOut<"flow"> flow;
  gl::In<"pool"> pool;
  gl::InOut<"KeptBlock"> kept;
};

struct FluidSettle {
  static constexpr auto file = "fluid/settle.comp";
  FluidPart part;
  gl::Uniform<"tilesStart", int> tilesStart = {};
  gl::Uniform<"heatStart", int> heatStart;
  gl::InOut<"flow"> flow;
  gl::In<"SettlingBlock"> settling;
  gl::In<"HeatBlock"> heat;
};

struct FluidCheck {
  static constexpr auto file = "fluid/check.comp";
  struct Variant {
    gl::Flag<"WAYS"> ways;
  };
  FluidPart part;
  gl::Uniform<"number", unsigned> number;
  gl::Uniform<"lostSpeed", float> lostSpeed;
  gl::In<"flow"> flow;
  gl::Out<"WayBlock"> ways;
  gl::InOut<"ControlBlock"> control;
  gl::InOut<"StatusBlock"> status;
};

struct FluidDyePass {
  static constexpr auto file = "fluid/dye/pass.comp";
  using Variant = FluidOpenVariant;
  FluidPart part;
  gl::Uniform<"tilesStart", int> tilesStart = {};
  gl::In<"flow"> flow;
  gl::In<"dye"> dye;
  gl::Out<"nextDye"> next;
};

struct FluidDyeStrips {
  static constexpr auto file = "fluid/dye/strips.comp";
  struct Variant {
    gl::Range<"PASSES", 1, 2> passes;
    gl::Flag<"SUBGROUPS"> subgroups;
  };
  FluidPart part;
  gl::Uniform<"rows", int> rows;
  gl::In<"flow"> flow;
  gl::In<"WayBlock"> ways;
  gl::In<"dye"> dye;
  gl::Out<"nextDye"> next;
};

struct FluidPaint {
  static constexpr auto file = "fluid/paint.comp";
  using Brushes = std::array<shader::FluidBrush, shader::maxBrushes>;
  FluidPart part;
  gl::Uniform<"firstBrush", int> firstBrush;
  gl::Uniform<"endBrush", int> endBrush;
  gl::Uniform<"box", glm::ivec4> box;
  gl::Block<"BrushBlock", Brushes> brushes;
  gl::In<"stamps"> stamps;
  gl::In<"flow"> flow;
  gl::In<"dye"> dye;
  gl::Out<"nextFlow"> nextFlow;
  gl::Out<"nextDye"> nextDye;
};

struct FluidPaintBack {
  static constexpr auto file = "fluid/paint_back.comp";
  FluidPart part;
  gl::Uniform<"box", glm::ivec4> box;
  gl::In<"flow"> flow;
  gl::In<"dye"> dye;
  gl::Out<"nextFlow"> nextFlow;
  gl::Out<"nextDye"> nextDye;
};

/// Part of a kernel interface: members common to the kernels that compute the displayed values from the
/// state.
struct FluidDisplayPart {
  FluidPart part;
  gl::Uniform<"stopCount", int> stopCount;
  gl::Uniform<"low", float> low;
  gl::Uniform<"perRange", float> perRange;
  gl::Uniform<"obstacleColor", glm::vec3> obstacleColor;
  gl::In<"flow"> flow;
  gl::In<"stops"> stops;
  gl::Out<"shown"> shown;
};

struct FluidDisplay {
  static constexpr auto file = "fluid/look/show.comp";
  FluidDisplayPart part;
  gl::Uniform<"brightness", float> brightness;
  gl::Uniform<"paper", glm::vec3> paper;
  gl::In<"dye"> dye;
};

struct FluidLines {
  static constexpr auto file = "fluid/look/lines.comp";
  FluidDisplayPart part;
  gl::Uniform<"lineDetail", int> lineDetail;
  gl::Uniform<"linePerDetail", float> linePerDetail;
  gl::Uniform<"linePhase", float> linePhase;
};

struct FluidSums {
  static constexpr auto file = "fluid/tally.comp";
  FluidPart part;
  gl::In<"flow"> flow;
  gl::In<"dye"> dye;
  gl::In<"ControlBlock"> control;
  gl::Out<"laneSums"> laneSums;
};

}  // namespace simreel::sim
