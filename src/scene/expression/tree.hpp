#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::scene {

/// What a node of an expression computes. Comparisons give 1 or 0; what is not 0 is true.
enum class Operation : std::uint8_t {
  number,
  name,
  negate,
  add,
  subtract,
  multiply,
  divide,
  power,
  less,
  lessEqual,
  equal,
  notEqual,
  both,      ///< and
  either,    ///< or
  opposite,  ///< not
  min,
  max,
  clamp,  ///< min(max(x, low), high)
  step,   ///< step(edge, x): 0 where x < edge, else 1
  abs,
  floor,
  sqrt,
  exp,
  log,
  sin,
  cos,
  tanh,
  choose,      ///< if(condition, then, else); both are computed
  laplacian,   ///< the continuous operator on a grid, to second order of the spacing
  ddx,         ///< d/dx by the difference of the two neighbours, to second order; x grows to the right
  ddy,         ///< the same of y, which grows downwards
  ddz,         ///< the same of z, from layer to layer of a volume
  diffuse,     ///< diffuse(D, u): div(D grad u), to second order; keeps the sum of u
  neighbours,  ///< sum of the four that share an edge; of a volume's six that share a face
  corners,     ///< sum of the four that share a corner; of a volume's twelve that share an edge
  around,      ///< sum of all that touch: 8, of a volume 26; on a mesh of those that share an edge
  noise,       ///< noise(k): another number of -1 to 1 in every cell and step
  random,      ///< random(k): another number of -1 to 1 in every cell
};

/// A function that expressions may call.
struct ExpressionFunction {
  const char* name;
  Operation operation;
  int least, most;  ///< arguments
  const char* doc;
};
[[nodiscard]] std::span<const ExpressionFunction> expressionFunctions();

/// An expression as it was parsed. Nodes stand after their arguments; the last one is the whole.
struct ExpressionTree {
  struct Node {
    Operation operation = Operation::number;
    double number = 0;
    std::string name;
    int arguments[3] = {-1, -1, -1};  ///< nodes
    std::size_t begin = 0, end = 0;   ///< bytes of the text
  };
  std::vector<Node> nodes;

  [[nodiscard]] int root() const { return static_cast<int>(nodes.size()) - 1; }
  [[nodiscard]] const Node& at(int node) const { return nodes[static_cast<std::size_t>(node)]; }
  /// As C would have it: pow(u, 2.0), (a < b ? c : d).
  [[nodiscard]] std::string text() const;
};

/// What is wrong with an expression, at bytes begin to end of its text.
struct ExpressionMistake {
  std::size_t begin = 0, end = 0;
  std::string message;
};

/// What a hostile expression may make us hold.
inline constexpr std::size_t maxExpressionBytes = 16384;
inline constexpr std::size_t maxExpressionNodes = 2000;
inline constexpr int maxExpressionDepth = 64;  ///< of parentheses, signs and powers within each other

/// Whether an expression may use it as a name: letters, digits and '_', not a digit first, no word of its
/// own.
[[nodiscard]] bool isExpressionName(std::string_view name);

/// Parses sums, products, powers (a^b, from right to left, before the sign: -a^2 = -(a^2)), comparisons,
/// and, or, not, calls of expressionFunctions(), numbers and names. Throws ExpressionMistake.
///
/// `lookups`: functions of a name, such as count(_Points): each call is a name node "count(_Points)".
[[nodiscard]] ExpressionTree parseExpression(std::string_view text,
                                             std::span<const char* const> lookups = {});

}  // namespace simreel::scene
