#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/automata/rule/cell_rule.hpp"

#include <map>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// The defines of glsl/life/step.comp and active.comp that select a rule on bits: a formula, or neighbour
/// counts for birth and survival.
struct LifeRuleVariant {
  gl::Code<"FORMULA", ""> formula;
  gl::Range<"BORN", 0, 511> born;
  gl::Range<"SURVIVE", 0, 511> survive;
};
[[nodiscard]] LifeRuleVariant variantOf(const CellRule& rule);

struct LifeStep;

/// Distribution of the grid among the invocations of glsl/life/step.comp.
struct LifeTuning {
  int steps = 1;   ///< number of generations per pass
  int blocks = 1;  ///< number of adjacent 128-cell blocks in a row per invocation
  int rows = 16;   ///< number of rows per invocation
  glm::ivec2 group{32, 2};
  bool flat = false;  ///< true if strips are numbered row by row, so that narrow grids also fill workgroups
  /// Returns the tuning that was measured to be the fastest for the current device and a grid of this size,
  /// for any number of steps.
  [[nodiscard]] static LifeTuning best(glm::ivec2 size);
};

/// Advances a grid of bits and writes the result to another array. Compiles kernels on first use.
class LifeStepper {
 public:
  LifeStepper() = default;
  /// `rule` must be a rule on bits (CellRule::onBits).
  LifeStepper(const CellRule& rule, bool torus, glm::ivec2 size, const LifeTuning& tuning);

  /// Returns the maximum number of generations per pass: tuning.steps if rows consist of whole strips and
  /// there are at least that many rows, otherwise 1.
  [[nodiscard]] int maxSteps() const { return maxSteps_; }
  /// Returns the number of generations for the next pass if `due` generations are due: maxSteps() if it is
  /// not larger, otherwise 4 if possible, otherwise 1. Because there are few different values, few kernels
  /// are compiled.
  [[nodiscard]] int stepsOf(long due) const;
  /// Runs one pass. `steps` must be between 1 and maxSteps().
  void run(const gl::WordsArray& from, const gl::WordsArray& to, int steps);

 private:
  CellRule rule_;
  bool torus_ = true;
  glm::ivec2 size_{0, 0};
  LifeTuning tuning_;
  bool whole_ = false;
  int maxSteps_ = 1;
  std::map<int, gl::Kernel<LifeStep>> programs_;  ///< kernels by their number of steps
};

}  // namespace simreel::sim
