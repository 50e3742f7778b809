#pragma once
#include "sim/reaction/rule/program.hpp"

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// What lies beyond the edges of the grid. noFlux: the cell beside it again, so the derivative across the
/// edge is zero. fixed: a number of its own for each species; lets are as for noFlux.
enum class RuleBoundary { torus, noFlux, fixed };

/// Which cells of a mesh are neighbours, and what weight u_j - u_i has in the Laplacian at i: for each four
/// cells, where their links begin and end; a link has a neighbour of each of the four, and weights; -1 and
/// 0 where one has less of them.
struct RuleLinks {
  std::vector<glm::ivec2> ranges;
  std::vector<glm::ivec4> neighbours;
  std::vector<glm::vec4> weights;
};

/// Planes of one array, cell by cell, x fastest.
using RulePlanes = std::vector<std::vector<float>>;

/// Where passes are computed on the CPU, with the bits of the kernels: the twin, and the first state.
struct RuleField {
  glm::ivec2 size{0, 0};
  int depth = 1;  ///< layers of a volume; planes have one after the other
  RuleBoundary boundary = RuleBoundary::torus;
  std::vector<float> edges;  ///< of species, for fixed
  unsigned seed = 0;
  const RuleLinks* links = nullptr;  ///< of a mesh
  RulePlanes stage, base, sum, lets, weights, next;

  [[nodiscard]] RulePlanes& array(RuleArray which);
  [[nodiscard]] int rows() const { return size.y * depth; }
  [[nodiscard]] bool isVolume() const { return depth > 1; }
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
