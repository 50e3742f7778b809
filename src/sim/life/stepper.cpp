#include "sim/life/stepper.hpp"

#include "gl/element_array.hpp"
#include "sim/automata/engine/bit_formula.hpp"

namespace simreel::sim {

struct LifeStep {
  static constexpr auto file = "life/step.comp";
  struct Variant {
    LifeRuleVariant rule;
    gl::Range<"STEPS", 1, 16> steps;
    gl::Range<"BLOCKS", 1, 4> blocks;
    gl::Range<"ROWS", 1, 256> rows;
    gl::Range<"GROUP_X", 1, 64> groupX;
    gl::Range<"GROUP_Y", 1, 8> groupY;
    gl::Flag<"FLAT"> flat;
    gl::Flag<"TORUS"> torus;
    gl::Flag<"WHOLE"> whole;
  };
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"rowBlocks", int> rowBlocks;
  gl::In<"cells"> cells;
  gl::Out<"newCells"> next;
};

LifeRuleVariant variantOf(const CellRule& rule) {
  LifeRuleVariant variant;
  if (rule.family == CellRule::Family::map) {
    variant.formula = bitFormula(rule);
  } else {
    variant.born = static_cast<int>(rule.counts.born);
    variant.survive = static_cast<int>(rule.counts.survives);
  }
  return variant;
}

LifeTuning LifeTuning::best(glm::ivec2 size) {
  // The values were measured on llvmpipe with tools/bench/life.cpp.
  const bool small = size.x <= (1 << 20) / size.y;
  LifeTuning tuning =
      gl::memoryPath() == gl::MemoryPath::texel
          ? LifeTuning{small ? 16 : 4, !small && size.x % 256 == 0 ? 2 : 1, 64, {8, 1}, true}
          : LifeTuning{2, 1, 32, {32, 2}};
  // On small grids, a sufficient number of invocations is more important than long strips.
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
  if (found == programs_.end())
    found = programs_
                .emplace(steps, gl::Kernel<LifeStep>(gl::kernelDefines(false), {.rule = variantOf(rule_),
                                                                                .steps = steps,
                                                                                .blocks = tuning_.blocks,
                                                                                .rows = tuning_.rows,
                                                                                .groupX = tuning_.group.x,
                                                                                .groupY = tuning_.group.y,
                                                                                .flat = tuning_.flat,
                                                                                .torus = torus_,
                                                                                .whole = whole_}))
                .first;
  const int across = (rowBlocks + tuning_.blocks - 1) / tuning_.blocks;
  const int down = (size_.y + tuning_.rows - 1) / tuning_.rows;
  found->second.dispatch(tuning_.flat ? glm::ivec2(across * down, 1) : glm::ivec2(across, down),
                         {.size = size_, .rowBlocks = rowBlocks, .cells = from, .next = to});
}

}  // namespace simreel::sim
