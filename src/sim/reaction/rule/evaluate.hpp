#pragma once
#include "sim/reaction/rule/program.hpp"

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Values beyond the edges of the grid. noFlux repeats the border cell, so the derivative across the edge
/// is zero. fixed uses a constant for each species; lets (named subexpressions) then behave as for noFlux.
enum class RuleBoundary { torus, noFlux, fixed };

/// Neighbours j of each cell i of a mesh, and the weights of u_j - u_i in the Laplacian at i. For each
/// group of four cells, `ranges` holds the start and end index of the group's links. A link has one
/// neighbour and one weight for each of the four cells; -1 and 0 pad cells with fewer neighbours.
struct RuleLinks {
  std::vector<glm::ivec2> ranges;
  std::vector<glm::ivec4> neighbours;
  std::vector<glm::vec4> weights;
};

/// Planes of one array, cell by cell, x fastest.
using RulePlanes = std::vector<std::vector<float>>;

/// Arrays of the CPU evaluation, which gives the same bits as the kernels. It serves as the CPU reference
/// and computes the initial state.
struct RuleField {
  glm::ivec2 size{0, 0};
  int depth = 1;  ///< number of layers in a volume; a plane stores them one after another
  RuleBoundary boundary = RuleBoundary::torus;
  std::vector<float> edges;  ///< value of each species beyond the edge, for the boundary `fixed`
  unsigned seed = 0;
  const RuleLinks* links = nullptr;  ///< neighbours of a mesh's cells; null for a grid
  RulePlanes stage, base, sum, lets, weights, next;

  [[nodiscard]] RulePlanes& array(RuleArray which);
  [[nodiscard]] int rows() const { return size.y * depth; }
  [[nodiscard]] bool isVolume() const { return depth > 1; }
};

/// Returns the uniform values of a pass, in the order of its list `uniforms`. `values` are indexed by
/// UniformIndex.
[[nodiscard]] std::vector<float> ruleUniformsOf(const RuleGraph& graph, const RulePass& pass,
                                                std::span<const float> values);

/// Evaluates a pass for all cells. `uniforms` is the result of ruleUniformsOf(); `step` is the number of
/// the step, which noise uses.
void evaluatePass(const RuleGraph& graph, const RulePass& pass, std::span<const float> uniforms,
                  unsigned step, RuleField& field);

/// Returns the initial state: the values of the rule's `starts` in each cell.
[[nodiscard]] RulePlanes evaluateStarts(const Rule& rule, std::span<const float> values, RuleField& field);

}  // namespace simreel::sim
