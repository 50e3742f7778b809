#pragma once
#include "sim/reaction/rule/rule.hpp"

#include <optional>
#include <vector>

namespace simreel::sim {

/// Time integration method: Euler, Heun (1900), or the classical Runge-Kutta method of order 4 (Kutta
/// 1901).
enum class RuleMethod { euler, heun, rk4 };

/// Arrays that passes read and write; each consists of planes of cells.
enum class RuleArray { stage, base, sum, lets, weights, next };

struct RulePlane {
  RuleArray array = RuleArray::stage;
  int plane = 0;
  auto operator<=>(const RulePlane&) const =
      default;  // NOLINT(modernize-use-nullptr): false positive in the generated comparison
};

/// One dispatch over all cells.
struct RulePass {
  struct Output {
    RulePlane plane;
    int node;
  };
  /// Plane that node `node` of the graph reads, directly or through a stencil.
  struct Read {
    int node;
    RuleOp op;  ///< a stencil, or `species` to read the cell itself
    RulePlane plane;
  };
  std::vector<Read> reads;
  std::vector<int> nodes;     ///< nodes to compute; arguments precede the nodes that use them
  std::vector<int> uniforms;  ///< uniform nodes, whose values the CPU computes
  std::vector<Output> outputs;
  bool usesTime = false;  ///< true if uniform values change from step to step
  bool usesNoise = false;

  /// Returns the index of a node in `uniforms`, or -1 if it is not uniform.
  [[nodiscard]] int placeOf(int node) const;
};

/// Passes of a step. Each stage consists of passes that store those lets (named subexpressions) that
/// stencils read, followed by the main pass of the stage.
struct RuleProgram {
  struct Stage {
    std::vector<int> passes;
    double time = 0;    ///< time within the step, as a fraction of the step
    bool last = false;  ///< true if the outputs of the pass are the new state
  };
  std::vector<RulePass> passes;
  std::vector<Stage> stages;
  /// Passes that compute the shown value and the tint value, unless these are species.
  std::vector<int> showing;
  int lets = 0;      ///< number of let planes
  RulePlane shown;   ///< plane of the shown value, among the species (stage) or the lets
  RulePlane tint{};  ///< plane of the value that colours the surface; equal to `shown` if there is no tint
  bool sums = false;
};

/// Creates the passes of a rule; adds the nodes of the integration stages to the rule's graph.
[[nodiscard]] RuleProgram programOf(Rule& rule, RuleMethod method);

}  // namespace simreel::sim
