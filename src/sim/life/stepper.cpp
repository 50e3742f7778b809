#include "sim/life/stepper.hpp"

#include "gl/element_array.hpp"
#include "sim/automata/engine/bit_formula.hpp"

#include <string>

namespace simreel::sim {

void defineRule(gl::Defines& defines, const CellRule& rule) {
  if (rule.family == CellRule::Family::map) {
    defines.emplace_back("FORMULA", bitFormula(rule));
    return;
  }
  defines.emplace_back("BORN", std::to_string(rule.counts.born));
  defines.emplace_back("SURVIVE", std::to_string(rule.counts.survives));
}

LifeTuning LifeTuning::best(glm::ivec2 size) {
  // Measured: llvmpipe with tools/bench/life.cpp.
  const bool small = size.x <= (1 << 20) / size.y;
  LifeTuning tuning =
      gl::memoryPath() == gl::MemoryPath::texel
          ? LifeTuning{small ? 16 : 4, !small && size.x % 256 == 0 ? 2 : 1, 64, {8, 1}, true}
          : LifeTuning{2, 1, 32, {32, 2}};
  // Small grids: enough invocations before long strips.
  const int enough = tuning.flat ? 32 : 256;
  const int across = (size.x + 127) / 128 / tuning.blocks + (tuning.flat ? 0 : 1);
  while (tuning.rows > (tuning.flat ? 16 : 8) && size.y / tuning.rows * across < enough) tuning.rows /= 2;
  return tuning;
}

LifeStepper::LifeStepper(const CellRule& rule, bool torus, glm::ivec2 size, const LifeTuning& tuning)
    : rule_(rule), torus_(torus), size_(size), tuning_(tuning) {
  whole_ = size.x % (128 * tuning.blocks) == 0;
  maxSteps_ = whole_ && size.y >= tuning.steps ? tuning.steps : 1;
}

int LifeStepper::stepsOf(long due) const {
  for (const int steps : {maxSteps_, 4})
    if (steps <= maxSteps_ && steps <= due) return steps;
  return 1;
}

void LifeStepper::run(const gl::WordsArray& from, const gl::WordsArray& to, int steps) {
  const int rowBlocks = (size_.x + 127) / 128;
  auto found = programs_.find(steps);
  if (found == programs_.end()) {
    gl::Defines defines = gl::kernelDefines(false);
    const auto define = [&](const char* name, int value) {
      defines.emplace_back(name, std::to_string(value));
    };
    defineRule(defines, rule_);
    define("STEPS", steps);
    define("BLOCKS", tuning_.blocks);
    define("ROWS", tuning_.rows);
    define("GROUP_X", tuning_.group.x);
    define("GROUP_Y", tuning_.group.y);
    if (tuning_.flat) define("FLAT", 1);
    if (torus_) define("TORUS", 1);
    if (whole_) define("WHOLE", 1);
    found = programs_.emplace(steps, gl::Program::compute("life/step.comp", defines)).first;
    found->second.set("size", size_);
    found->second.set("rowBlocks", rowBlocks);
  }
  from.bindInput(shader::life::cellsBinding);
  to.bindState(shader::life::nextCellsBinding);
  const int across = (rowBlocks + tuning_.blocks - 1) / tuning_.blocks;
  const int down = (size_.y + tuning_.rows - 1) / tuning_.rows;
  if (tuning_.flat)
    found->second.dispatch(across * down, 1);
  else
    found->second.dispatch(across, down);
}

}  // namespace simreel::sim
