#include "sim/life/stepper.hpp"

#include "gl/element_array.hpp"

#include <string>

namespace simreel::sim {

LifeTuning LifeTuning::best(glm::ivec2 size) {
  // Measured: llvmpipe with tools/bench/life.cpp.
  LifeTuning tuning = gl::memoryPath() == gl::MemoryPath::texel
                          ? LifeTuning{4, size.x % 256 == 0 ? 2 : 1, 64, {8, 4}}
                          : LifeTuning{2, 1, 32, {32, 2}};
  // Small grids: enough invocations before long strips.
  const int across = (size.x + 127) / 128 / tuning.blocks + 1;
  while (tuning.rows > 8 && size.y / tuning.rows * across < 256) tuning.rows /= 2;
  return tuning;
}

LifeStepper::LifeStepper(const LifeRule& rule, bool torus, glm::ivec2 size, const LifeTuning& tuning)
    : rule_(rule), torus_(torus), size_(size), tuning_(tuning) {
  whole_ = size.x % (128 * tuning.blocks) == 0;
  maxSteps_ = whole_ && size.y >= tuning.steps ? tuning.steps : 1;
}

void LifeStepper::run(const gl::WordsArray& from, const gl::WordsArray& to, int steps) {
  const int rowBlocks = (size_.x + 127) / 128;
  auto found = programs_.find(steps);
  if (found == programs_.end()) {
    gl::Defines defines = gl::kernelDefines(false);
    const auto define = [&](const char* name, int value) {
      defines.emplace_back(name, std::to_string(value));
    };
    define("BORN", rule_.born);
    define("SURVIVE", rule_.survives);
    define("STEPS", steps);
    define("BLOCKS", tuning_.blocks);
    define("ROWS", tuning_.rows);
    define("GROUP_X", tuning_.group.x);
    define("GROUP_Y", tuning_.group.y);
    if (torus_) define("TORUS", 1);
    if (whole_) define("WHOLE", 1);
    found = programs_.emplace(steps, gl::Program::compute("life/step.comp", defines)).first;
    found->second.set("size", size_);
    found->second.set("rowBlocks", rowBlocks);
  }
  from.bindInput(shader::life::cellsBinding);
  to.bindState(shader::life::nextCellsBinding);
  found->second.dispatch((rowBlocks + tuning_.blocks - 1) / tuning_.blocks,
                         (size_.y + tuning_.rows - 1) / tuning_.rows);
}

}  // namespace simreel::sim
