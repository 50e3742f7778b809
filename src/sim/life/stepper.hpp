#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/automata/rule/cell_rule.hpp"

#include <map>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Rule-dependent part of the variants of glsl/life/step.comp and active.comp, for rules on bits: a formula
/// or neighbour counts.
struct LifeRuleVariant {
  gl::Code<"FORMULA", ""> formula;
  gl::Range<"BORN", 0, 511> born;
  gl::Range<"SURVIVE", 0, 511> survive;
};
[[nodiscard]] LifeRuleVariant variantOf(const CellRule& rule);

struct LifeStep;

/// Partition of the grid among the invocations of glsl/life/step.comp.
struct LifeTuning {
  int steps = 1;   ///< number of generations in one pass
  int blocks = 1;  ///< number of 128-cell blocks side by side per invocation
  int rows = 16;   ///< number of rows per invocation
  glm::ivec2 group{32, 2};
  bool flat = false;  ///< true: strips are numbered row by row, so that narrow grids also fill workgroups
  /// Returns the fastest measured tuning for the current device and a grid of this size, for any number of
  /// steps.
  [[nodiscard]] static LifeTuning best(glm::ivec2 size);
};

/// Advances a grid of bits from one array to another. Compiles kernels on first use.
class LifeStepper {
 public:
  LifeStepper() = default;
  /// `rule` must be a rule on bits (CellRule::onBits).
  LifeStepper(const CellRule& rule, bool torus, glm::ivec2 size, const LifeTuning& tuning);

  /// Returns the maximum number of generations in one pass: tuning.steps if rows consist of whole strips
  /// and there are at least that many rows; else 1.
  [[nodiscard]] int maxSteps() const { return maxSteps_; }
  /// Returns the number of generations for the next pass if `due` are due: maxSteps(), else 4 if permitted,
  /// else 1. Few distinct values limit the number of compiled kernels.
  [[nodiscard]] int stepsOf(long due) const;
  /// Runs one pass; `steps` is in 1..maxSteps().
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
