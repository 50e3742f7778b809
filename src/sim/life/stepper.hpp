#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/automata/rule/cell_rule.hpp"

#include <map>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// What glsl/life/step.comp and active.comp want of a rule on bits, a part of their variants: a formula, or
/// counts.
struct LifeRuleVariant {
  gl::Code<"FORMULA", ""> formula;
  gl::Range<"BORN", 0, 511> born;
  gl::Range<"SURVIVE", 0, 511> survive;
};
[[nodiscard]] LifeRuleVariant variantOf(const CellRule& rule);

struct LifeStep;

/// How the kernel glsl/life/step.comp cuts the grid.
struct LifeTuning {
  int steps = 1;   ///< generations in one pass
  int blocks = 1;  ///< of 128 cells side by side, owned by an invocation
  int rows = 16;   ///< that an invocation goes down
  glm::ivec2 group{32, 2};
  bool flat = false;  ///< strips are numbered row by row, so that narrow grids fill a group, too
  /// What measured best on the present device for grids of this size, with any number of steps.
  [[nodiscard]] static LifeTuning best(glm::ivec2 size);
};

/// Advances a grid of bits from one array to the other. Programs are made when first used.
class LifeStepper {
 public:
  LifeStepper() = default;
  /// `rule`: one on bits (CellRule::onBits).
  LifeStepper(const CellRule& rule, bool torus, glm::ivec2 size, const LifeTuning& tuning);

  /// Generations in one pass at most: tuning.steps where rows are whole multiples of the strips and there
  /// are as many rows; else 1.
  [[nodiscard]] int maxSteps() const { return maxSteps_; }
  /// Generations of the next pass where `due` are due: maxSteps(), else 4 where that allows them, else 1,
  /// so that few programs are made.
  [[nodiscard]] int stepsOf(long due) const;
  /// `steps` from 1 to maxSteps().
  void run(const gl::WordsArray& from, const gl::WordsArray& to, int steps);

 private:
  CellRule rule_;
  bool torus_ = true;
  glm::ivec2 size_{0, 0};
  LifeTuning tuning_;
  bool whole_ = false;
  int maxSteps_ = 1;
  std::map<int, gl::Kernel<LifeStep>> programs_;  ///< by steps
};

}  // namespace simreel::sim
