#pragma once
#include <compare>
#include <cstdint>
#include <map>
#include <vector>

namespace simreel::sim {

/// What a node of a rule computes, all in single precision and each rounded once. Those of `exact...` are
/// functions of glsl/common/exact.glsl and glsl/reaction/functions.glsl.
enum class RuleOp : std::uint8_t {
  constant,  ///< `number`
  told,      ///< uniform: number `index` of what a step is told
  species,   ///< of this cell: species `index`
  weight,    ///< map `index` of this cell, 0 to 1
  base,      ///< species `index` at the step's beginning
  sum,       ///< what earlier stages of the step left for species `index`
  x,         ///< cells from the left edge to this cell's middle
  y,         ///< from the top; of a volume from the bottom
  z,         ///< from the first layer
  noise,     ///< of salt `index`: a number in [-1, 1) of cell and step
  random,    ///< of the cell
  sixfold,   ///< of the argument, 6 h^2 times the Laplacian: 4 edges + corners - 20 centre; of a volume 2
             ///< edges + corners - 24 centre; on a mesh, the Laplacian itself
  edges,     ///< sum of the four neighbours; of a volume of the six across faces; on a mesh of all
  corners,   ///< sum of the four at the corners; of a volume of the twelve across edges
  tips,      ///< sum of a volume's eight across corners
  across,    ///< right less left neighbour
  down,      ///< the one at y + 1 less the one at y - 1
  deep,      ///< the one at z + 1 less the one at z - 1
  add,
  subtract,
  multiply,
  flush,   ///< rounded to a multiple of 2^-96 where it is below 2^-73
  settle,  ///< rounded to a multiple of 2^-60 where it is below 2^-37: what is stored
  reciprocal,
  min,
  max,
  abs,
  floor,
  sqrt,
  exp,
  log,
  sin,
  cos,
  tanh,
  power,  ///< a^b for a >= 0
  less,   ///< 1 or 0
  lessEqual,
  equal,
  choose,  ///< a != 0 ? b : c
};

struct RuleNode {
  RuleOp op = RuleOp::constant;
  float number = 0;
  int index = 0;
  int a = -1, b = -1, c = -1;
  auto operator<=>(const RuleNode&) const =
      default;  // NOLINT(modernize-use-nullptr): of the comparison that it makes
};

/// The expressions of a rule as one graph: equal parts are there once, constants are folded, and products
/// that could be subnormal are flushed, since drivers disagree on those.
///
/// For that each node has a quantum q: its value is a multiple of 2^q. Those of a product add up, and one
/// with q >= -126 is 0 or a normal number. State is stored as multiples of 2^-60.
class RuleGraph {
 public:
  /// `edges`, `corners`: neighbours that those sum up.
  explicit RuleGraph(int edges = 4, int corners = 4) : edges_(edges), corners_(corners) {}
  int constant(double value);
  int told(int index) { return add({RuleOp::told, 0, index}, storedQuantum, true); }
  /// species, weight, base, sum, x, y, z, noise, random.
  int input(RuleOp op, int index);
  /// sixfold, edges, corners, tips, across, down, deep.
  int stencil(RuleOp op, int argument);
  int sum(int a, int b);
  int difference(int a, int b);
  int product(int a, int b);
  /// Not flushed: for what is added to a number and then settled.
  int rawProduct(int a, int b);
  int quotient(int a, int b);
  int settled(int a) { return add({RuleOp::settle, 0, 0, a}, storedQuantum, false); }
  /// abs, floor, sqrt, exp, log, sin, cos, tanh, reciprocal.
  int function(RuleOp op, int a);
  /// min, max, power, less, lessEqual, equal.
  int function(RuleOp op, int a, int b);
  int choose(int condition, int then, int otherwise);

  [[nodiscard]] const RuleNode& at(int node) const { return nodes_[static_cast<std::size_t>(node)]; }
  [[nodiscard]] int size() const { return static_cast<int>(nodes_.size()); }
  [[nodiscard]] bool isConstant(int node) const { return at(node).op == RuleOp::constant; }
  /// Whether it is the same in all cells.
  [[nodiscard]] bool isUniform(int node) const { return uniform_[static_cast<std::size_t>(node)]; }
  static constexpr int storedQuantum = -60;

 private:
  int add(const RuleNode& node, int quantum, bool uniform);
  /// Folded where all arguments are constants.
  int make(const RuleNode& node, int quantum);
  [[nodiscard]] int quantum(int node) const { return quanta_[static_cast<std::size_t>(node)]; }
  [[nodiscard]] bool is(int node, float number) const {
    return isConstant(node) && at(node).number == number;
  }

  int edges_, corners_;
  std::vector<RuleNode> nodes_;
  std::vector<int> quanta_;
  std::vector<bool> uniform_;
  std::map<RuleNode, int> known_;
};

/// One operation on numbers; not for inputs and stencils.
[[nodiscard]] float computed(RuleOp op, float a, float b, float c);

}  // namespace simreel::sim
