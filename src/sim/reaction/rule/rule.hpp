#pragma once
#include "scene/expression/tree.hpp"
#include "sim/reaction/rule/graph.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace simreel::sim {

/// What a rule's cells fill: a plane, a volume of layers of planes, or the surface of a mesh.
enum class RuleSpace { plane, volume, mesh };

/// Texts of a rule, as a scene gives them.
struct RuleText {
  struct Species {
    std::string name, rate, start, next;
    bool diffuses = false;
  };
  struct Parameter {
    std::string name;
    bool isMapped = false;
    bool mayBeIdle = false;  ///< no expression need have it
    bool isField = false;    ///< another object's values, cell by cell
  };
  struct Let {
    std::string name, text;
  };
  std::vector<Species> species;
  std::vector<Parameter> parameters;
  std::vector<Let> lets;
  std::string show;  ///< empty: the first species
  std::string tint;  ///< what colours a surface of that; empty: nothing
  RuleSpace space = RuleSpace::plane;
};

/// A mistake in one of them: the members that lead to it in a scene, and the bytes of the text.
struct RuleMistake {
  std::vector<std::string> path;
  std::size_t begin = 0, end = 1;
  std::string message;
};

/// Numbers that steps are told, by their place in RuleOp::told.
struct ToldPlaces {
  enum : int {
    dt,
    halfDt,
    sixthDt,
    perLaplacian,
    perGradient,
    spacing,
    time,
    width,
    height,
    depth,
    fixedCount
  };
  int parameters = 0;  ///< how many

  [[nodiscard]] static int value(int parameter) { return fixedCount + parameter; }
  [[nodiscard]] int span(int parameter) const { return fixedCount + parameters + parameter; }
  /// D / (6 h^2) of a species.
  [[nodiscard]] int diffusion(int species) const { return fixedCount + 2 * parameters + species; }
  /// What a species is beyond a fixed edge.
  [[nodiscard]] int edge(int species) const { return fixedCount + 2 * parameters + 8 + species; }
  [[nodiscard]] int count() const { return fixedCount + 2 * parameters + 16; }
};

/// On a mesh, maps of places come after those of parameters: x, y and z.
inline constexpr int placeMaps = 3;

inline constexpr int maxSpecies = 8;
/// Whole exponents up to it are products, of negative numbers, too; other powers are exp(b log a), of what
/// is not above 1e-30 zero.
inline constexpr int greatestWholePower = 1024;
/// Of a step with Euler's method, in additions or multiplications a cell.
inline constexpr int maxRuleCost = 4000;

/// A rule understood: one graph of all its expressions.
struct Rule {
  RuleGraph graph;
  ToldPlaces told;
  std::vector<int> rates;     ///< a node for each species, diffusion included
  std::vector<int> nexts;     ///< what a species becomes, that has no rate then; -1: it has one
  std::vector<int> starts;    ///< the first state
  int shown = -1, tint = -1;  ///< the second -1: nothing
  /// As C would have it, a line for each let and rate.
  std::string text;
  int cost = 0;
};

/// Throws RuleMistake.
[[nodiscard]] Rule understandRule(const RuleText& text);

}  // namespace simreel::sim
