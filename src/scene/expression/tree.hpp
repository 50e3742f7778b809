#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::scene {

/// Operation of an expression node. Comparisons give 1 or 0; any value except 0 counts as true.
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
  both,      ///< logical and
  either,    ///< logical or
  opposite,  ///< logical not
  min,
  max,
  clamp,  ///< min(max(x, low), high)
  step,   ///< step(edge, x): 0 if x < edge, otherwise 1
  abs,
  floor,
  sqrt,
  exp,
  log,
  sin,
  cos,
  tanh,
  choose,      ///< if(condition, then, else); both branches are evaluated
  laplacian,   ///< Laplace operator on a grid; error of second order in the cell size
  ddx,         ///< d/dx by central difference, error of second order in the cell size; x grows to the right
  ddy,         ///< d/dy by central difference, error of second order in the cell size; y grows downwards
  ddz,         ///< d/dz by central difference between the layers of a volume; error of second order in the
               ///< cell size
  diffuse,     ///< diffuse(D, u): div(D grad u), error of second order in the cell size; conserves the sum
               ///< of u
  neighbours,  ///< sum over the 4 cells that share an edge with the cell; in a volume, over the 6 that
               ///< share a face
  corners,  ///< sum over the 4 cells that share only a corner with the cell; in a volume, over the 12 that
            ///< share only an edge
  around,   ///< sum over all 8 adjacent cells, 26 in a volume; on a mesh the same as `neighbours`
  noise,    ///< noise(k): pseudo-random number from -1 to 1, different in every cell and step
  random,   ///< random(k): pseudo-random number from -1 to 1, different in every cell, constant in time
};

/// Built-in function of the expression language.
struct ExpressionFunction {
  const char* name;
  Operation operation;
  int minimum, maximum;  ///< minimum and maximum number of arguments
  const char* doc;
};
[[nodiscard]] std::span<const ExpressionFunction> expressionFunctions();

/// Parsed expression. A node comes after its arguments, so the last node is the root.
struct ExpressionTree {
  struct Node {
    Operation operation = Operation::number;
    double number = 0;
    std::string name;
    int arguments[3] = {-1, -1, -1};  ///< indices of the argument nodes; -1 if unused
    std::size_t begin = 0, end = 0;   ///< byte range in the expression's text; `begin` is included, `end`
                                      ///< is not
  };
  std::vector<Node> nodes;

  [[nodiscard]] int root() const { return static_cast<int>(nodes.size()) - 1; }
  [[nodiscard]] const Node& at(int node) const { return nodes[static_cast<std::size_t>(node)]; }
  /// Returns the expression in C syntax: pow(u, 2.0), (a < b ? c : d).
  [[nodiscard]] std::string text() const;
};

/// Error in an expression. The byte range in the text includes `begin` but not `end`.
struct ExpressionMistake {
  std::size_t begin = 0, end = 0;
  std::string message;
};

/// Limits on an expression's size. They bound the memory that an untrusted scene can use.
inline constexpr std::size_t maxExpressionBytes = 16384;
inline constexpr std::size_t maxExpressionNodes = 2000;
inline constexpr int maxExpressionDepth = 64;  ///< maximum nesting depth of parentheses, signs and powers

/// True if expressions may use `name` as a variable: letters, digits and '_', no leading digit, and neither
/// a reserved word nor a function.
[[nodiscard]] bool isExpressionName(std::string_view name);

/// Parses an expression: sums, products, powers, comparisons, and, or, not, calls of expressionFunctions(),
/// numbers and names. Powers associate to the right and bind tighter than the sign: -a^2 = -(a^2). Throws
/// ExpressionMistake.
/// `lookups`: names of functions whose argument is a name, such as count(_Points). Such a call becomes a
/// name node with the text "count(_Points)".
[[nodiscard]] ExpressionTree parseExpression(std::string_view text,
                                             std::span<const char* const> lookups = {});

}  // namespace simreel::scene
