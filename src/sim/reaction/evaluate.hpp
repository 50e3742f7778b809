#pragma once
#include "sim/reaction/program.hpp"

#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// What lies beyond the edges of the grid. noFlux: the cell beside it again, so the derivative across the
/// edge is zero. fixed: a number of its own for each species; lets are as for noFlux.
enum class RuleBoundary { torus, noFlux, fixed };

/// Planes of one array, cell by cell, x fastest.
using RulePlanes = std::vector<std::vector<float>>;

/// Where passes are computed on the CPU, with the bits of the kernels: the twin, and the first state.
struct RuleField {
  glm::ivec2 size{0, 0};
  RuleBoundary boundary = RuleBoundary::torus;
  std::vector<float> edges;  ///< of species, for fixed
  unsigned seed = 0;
  RulePlanes stage, base, sum, lets, weights, next;

  [[nodiscard]] RulePlanes& array(RuleArray which);
};

/// The numbers of a pass that are the same in all cells, by its list `told`; `values`: by ToldPlaces.
[[nodiscard]] std::vector<float> toldOf(const RuleGraph& graph, const RulePass& pass,
                                        std::span<const float> values);

/// Runs a pass over all cells: `told` from toldOf, `step`: number of the step, for noise.
void evaluatePass(const RuleGraph& graph, const RulePass& pass, std::span<const float> told, unsigned step,
                  RuleField& field);

/// The first state: what `starts` of the rule are in each cell.
[[nodiscard]] RulePlanes evaluateStarts(const Rule& rule, std::span<const float> values, RuleField& field);

}  // namespace simreel::sim
