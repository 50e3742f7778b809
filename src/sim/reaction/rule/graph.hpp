#pragma once
#include <compare>
#include <cstdint>
#include <map>
#include <vector>

namespace simreel::sim {

/// Operations of a rule's nodes, all in single precision with one rounding each. For functions other than
/// basic arithmetic, see the functions named exact... in glsl/common/exact.glsl, and
/// glsl/reaction/functions.glsl.
enum class RuleOp : std::uint8_t {
  constant,  ///< the constant `number`
  uniform,   ///< uniform value number `index` of a step
  species,   ///< value of species `index` in this cell
  weight,    ///< value of map number `index` in this cell, 0 to 1
  base,      ///< value of species `index` in this cell at the beginning of the step
  sum,       ///< sum for species `index` that earlier stages of the step have stored
  x,         ///< distance in cells from the left edge to this cell's centre
  y,         ///< distance in cells from the top edge; in a volume from the bottom
  z,         ///< distance in cells from the first layer
  noise,     ///< random number in [-1, 1) that depends on cell and step; `index` is the salt
  random,    ///< random number in [-1, 1) that depends on the cell
  sixfold,   ///< Laplacian of the argument times 6 h^2 (cell distance h): 4 edges + corners - 20 centre; in
             ///< a volume 2 edges + corners - 24 centre; on a mesh the Laplacian without a factor
  edges,     ///< sum of the four edge neighbours; in a volume of the six face neighbours; on a mesh of all
             ///< neighbours
  corners,   ///< sum of the four corner neighbours; in a volume of the twelve edge neighbours
  tips,      ///< sum of the eight corner neighbours in a volume
  across,    ///< value of the right neighbour minus value of the left neighbour
  down,      ///< value of the neighbour at y + 1 minus value of the neighbour at y - 1
  deep,      ///< value of the neighbour at z + 1 minus value of the neighbour at z - 1
  add,
  subtract,
  multiply,
  flush,   ///< rounds to a multiple of 2^-96 if the magnitude is below 2^-73
  settle,  ///< rounds to a multiple of 2^-60 if the magnitude is below 2^-37; applied to stored values
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
  power,  ///< power a^b for a >= 0
  less,   ///< 1 if a < b, otherwise 0
  lessEqual,
  equal,
  choose,  ///< b if a != 0, otherwise c
};

struct RuleNode {
  RuleOp op = RuleOp::constant;
  float number = 0;
  int index = 0;
  int a = -1, b = -1, c = -1;
  auto operator<=>(const RuleNode&) const =
      default;  // NOLINT(modernize-use-nullptr): false positive in the generated comparison
};

/// Expressions of a rule as one graph. Equal subexpressions are one node, constants are folded, and
/// products that could be subnormal are flushed, because drivers treat subnormals differently.
///
/// To detect such products, each node has a quantum q: its value is a multiple of 2^q. The quantum of a
/// product is the sum of the factors' quanta, and a value with q >= -126 is 0 or a normal number. Stored
/// state consists of multiples of 2^-60.
class RuleGraph {
 public:
  /// `edges` and `corners` are the numbers of neighbours that the stencils of these names sum.
  explicit RuleGraph(int edges = 4, int corners = 4) : edges_(edges), corners_(corners) {}
  int constant(double value);
  int uniform(int index) { return add({RuleOp::uniform, 0, index}, storedQuantum, true); }
  /// Adds an input: species, weight, base, sum, x, y, z, noise or random.
  int input(RuleOp op, int index);
  /// Adds a stencil: sixfold, edges, corners, tips, across, down or deep.
  int stencil(RuleOp op, int argument);
  int sum(int a, int b);
  int difference(int a, int b);
  int product(int a, int b);
  /// Adds a product without a flush, for use as a summand of a value that is settled afterwards.
  int rawProduct(int a, int b);
  int quotient(int a, int b);
  int settled(int a) { return add({RuleOp::settle, 0, 0, a}, storedQuantum, false); }
  /// Adds abs, floor, sqrt, exp, log, sin, cos, tanh or reciprocal.
  int function(RuleOp op, int a);
  /// Adds min, max, power, less, lessEqual or equal.
  int function(RuleOp op, int a, int b);
  int choose(int condition, int then, int otherwise);

  [[nodiscard]] const RuleNode& at(int node) const { return nodes_[static_cast<std::size_t>(node)]; }
  [[nodiscard]] int size() const { return static_cast<int>(nodes_.size()); }
  [[nodiscard]] bool isConstant(int node) const { return at(node).op == RuleOp::constant; }
  /// Returns true if the node has the same value in all cells.
  [[nodiscard]] bool isUniform(int node) const { return uniform_[static_cast<std::size_t>(node)]; }
  static constexpr int storedQuantum = -60;

 private:
  int add(const RuleNode& node, int quantum, bool uniform);
  /// Adds a node. If all arguments are constants, adds the constant result instead.
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

/// Computes one operation on numbers; not for inputs and stencils.
[[nodiscard]] float computed(RuleOp op, float a, float b, float c);

}  // namespace simreel::sim
