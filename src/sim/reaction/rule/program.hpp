#pragma once
#include "sim/reaction/rule/rule.hpp"

#include <optional>
#include <vector>

namespace simreel::sim {

/// How a step goes. Heun 1900 and the classical Runge-Kutta method of order 4 (Kutta 1901).
enum class RuleMethod { euler, heun, rk4 };

/// What passes read and write: planes of cells.
enum class RuleArray { stage, base, sum, lets, weights, next };

struct RulePlane {
  RuleArray array = RuleArray::stage;
  int plane = 0;
  auto operator<=>(const RulePlane&) const =
      default;  // NOLINT(modernize-use-nullptr): of the comparison that it makes
};

/// One sweep over all cells.
struct RulePass {
  struct Output {
    RulePlane plane;
    int node;
  };
  /// A stencil of a plane, or the plane itself, which node `node` of the graph is.
  struct Read {
    int node;
    RuleOp op;  ///< sixfold, edges, corners, across, down, deep; species: the cell itself
    RulePlane plane;
  };
  std::vector<Read> reads;
  std::vector<int> nodes;  ///< that are computed, arguments first
  std::vector<int> told;   ///< uniform nodes, computed on the CPU
  std::vector<Output> outputs;
  bool usesTime = false;  ///< what is told changes from step to step
  bool usesNoise = false;

  /// Its place among `told`; -1: it is none.
  [[nodiscard]] int placeOf(int node) const;
};

/// The passes of a step. Each stage has those of the lets that a stencil is laid over, then its own.
struct RuleProgram {
  struct Stage {
    std::vector<int> passes;
    double time = 0;    ///< of the step, in steps
    bool last = false;  ///< its outputs are the new state
  };
  std::vector<RulePass> passes;
  std::vector<Stage> stages;
  /// Passes of what is shown or tints it, as far as that is no species.
  std::vector<int> showing;
  int lets = 0;      ///< planes
  RulePlane shown;   ///< a species (stage) or one of lets
  RulePlane tint{};  ///< the same; what is shown where nothing tints it
  bool sums = false;
};

/// Adds the nodes of the stages to the rule's graph.
[[nodiscard]] RuleProgram programOf(Rule& rule, RuleMethod method);

}  // namespace simreel::sim
