#pragma once
#include "scene/expression/tree.hpp"
#include "sim/reaction/rule/graph.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace simreel::sim {

/// Domain of a rule's cells: a plane, a volume of layers, or the surface of a mesh.
enum class RuleSpace { plane, volume, mesh };

/// Source texts of a rule, as given by a scene.
struct RuleText {
  struct Species {
    std::string name, rate, start, next;
    bool diffuses = false;
  };
  struct Parameter {
    std::string name;
    bool isMapped = false;
    bool mayBeIdle = false;  ///< true if the parameter need not occur in an expression
    bool isField = false;    ///< true if the parameter takes its value in each cell from another object
  };
  struct Let {
    std::string name, text;
  };
  std::vector<Species> species;
  std::vector<Parameter> parameters;
  std::vector<Let> lets;
  std::string show;  ///< expression to show; if empty, the first species
  std::string tint;  ///< expression that colours a surface; empty if none exists
  RuleSpace space = RuleSpace::plane;
};

/// Error in one of the texts: the path of the text's member in the scene, and the range of wrong
/// characters.
struct RuleMistake {
  std::vector<std::string> path;
  std::size_t begin = 0, end = 1;
  std::string message;
};

/// Indices of a step's uniform values, as used by RuleOp::uniform.
struct UniformIndex {
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
  int parameters = 0;  ///< number of parameters

  [[nodiscard]] static int value(int parameter) { return fixedCount + parameter; }
  [[nodiscard]] int span(int parameter) const { return fixedCount + parameters + parameter; }
  /// Returns the index of D / (6 h^2) of a species.
  [[nodiscard]] int diffusion(int species) const { return fixedCount + 2 * parameters + species; }
  /// Returns the index of a species' value beyond an edge of the kind "fixed".
  [[nodiscard]] int edge(int species) const { return fixedCount + 2 * parameters + 8 + species; }
  [[nodiscard]] int count() const { return fixedCount + 2 * parameters + 16; }
};

/// Number of coordinate maps (x, y and z) on a mesh; they follow the maps of parameters.
inline constexpr int bindMaps = 3;

inline constexpr int maxSpecies = 8;
/// Maximum integer exponent for which powers are evaluated by multiplication, which also allows negative
/// bases. Other powers are exp(b log a), or 0 for bases up to 1e-30.
inline constexpr int greatestWholePower = 1024;
/// Maximum cost of a step with Euler's method, in additions or multiplications per cell.
inline constexpr int maxRuleCost = 4000;

/// Compiled rule: one graph of all its expressions.
struct Rule {
  RuleGraph graph;
  UniformIndex uniforms;
  std::vector<int> rates;     ///< node of each species' rate, including diffusion
  std::vector<int> nexts;     ///< for each species, the node of its next value; -1 if it has a rate
  std::vector<int> starts;    ///< nodes of the initial state
  int shown = -1, tint = -1;  ///< nodes of the shown value and of the colour; `tint` is -1 if there is no
                              ///< colour
  /// C-like text with one line per let and rate.
  std::string text;
  int cost = 0;
};

/// Compiles a rule. Throws RuleMistake.
[[nodiscard]] Rule compileRule(const RuleText& text);

}  // namespace simreel::sim
