#include "scene/expression/tree.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

using ExpressionNode = ExpressionTree::Node;

/// Returns the precedence of an operation, from 1 (weakest) to 9 (calls and numbers).
int bindingOf(Operation operation) {
  switch (operation) {
    case Operation::either:
      return 1;
    case Operation::both:
      return 2;
    case Operation::equal:
    case Operation::notEqual:
      return 3;
    case Operation::less:
    case Operation::lessEqual:
      return 4;
    case Operation::add:
    case Operation::subtract:
      return 5;
    case Operation::multiply:
    case Operation::divide:
      return 6;
    case Operation::negate:
    case Operation::opposite:
      return 7;
    default:
      return 9;
  }
}

const char* signOf(Operation operation) {
  switch (operation) {
    case Operation::either:
      return " || ";
    case Operation::both:
      return " && ";
    case Operation::equal:
      return " == ";
    case Operation::notEqual:
      return " != ";
    case Operation::less:
      return " < ";
    case Operation::lessEqual:
      return " <= ";
    case Operation::add:
      return " + ";
    case Operation::subtract:
      return " - ";
    case Operation::multiply:
      return " * ";
    case Operation::divide:
      return " / ";
    default:
      return nullptr;
  }
}

const char* functionName(Operation operation) {
  if (operation == Operation::power) return "pow";
  for (const ExpressionFunction& function : expressionFunctions())
    if (function.operation == operation) return function.name;
  return "";
}

/// Appends the text of node `index` to `out`, in parentheses if its precedence is below `outer`.
void writeTree(const ExpressionTree& tree, int index, int outer, std::string& out) {
  const ExpressionNode& node = tree.at(index);
  if (node.operation == Operation::number) {
    const std::string digits = fmt::format("{}", node.number);
    out += digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
    return;
  }
  if (node.operation == Operation::name) {
    out += node.name;
    return;
  }
  const int own = bindingOf(node.operation);
  if (own < outer) out += '(';
  if (node.operation == Operation::negate || node.operation == Operation::opposite) {
    out += node.operation == Operation::negate ? '-' : '!';
    writeTree(tree, node.arguments[0], own + 1, out);
  } else if (node.operation == Operation::choose) {
    out += '(';
    writeTree(tree, node.arguments[0], 2, out);
    out += " ? ";
    writeTree(tree, node.arguments[1], 1, out);
    out += " : ";
    writeTree(tree, node.arguments[2], 1, out);
    out += ')';
  } else if (const char* sign = signOf(node.operation)) {
    writeTree(tree, node.arguments[0], own, out);
    out += sign;
    writeTree(tree, node.arguments[1], own + 1, out);
  } else {
    out += functionName(node.operation);
    out += '(';
    for (int i = 0; i < 3 && node.arguments[i] >= 0; ++i) {
      if (i > 0) out += ", ";
      writeTree(tree, node.arguments[i], 0, out);
    }
    out += ')';
  }
  if (own < outer) out += ')';
}

}  // namespace

std::span<const ExpressionFunction> expressionFunctions() {
  static constexpr ExpressionFunction functions[] = {
      {"min", Operation::min, 2, 8, "least"},
      {"max", Operation::max, 2, 8, "greatest"},
      {"clamp", Operation::clamp, 3, 3, "clamp(x, low, high)"},
      {"step", Operation::step, 2, 2, "step(edge, x): 0 where x < edge, else 1"},
      {"abs", Operation::abs, 1, 1, ""},
      {"floor", Operation::floor, 1, 1, ""},
      {"sqrt", Operation::sqrt, 1, 1, "0 below 1e-30"},
      {"exp", Operation::exp, 1, 1, "limited to exp(-69) to exp(69)"},
      {"log", Operation::log, 1, 1, "below 1e-30 the logarithm of 1e-30"},
      {"sin", Operation::sin, 1, 1, "up to 1e4 radians"},
      {"cos", Operation::cos, 1, 1, "up to 1e4 radians"},
      {"tanh", Operation::tanh, 1, 1, ""},
      {"if", Operation::choose, 3, 3, "if(condition, then, else)"},
      {"laplacian", Operation::laplacian, 1, 1, "d2/dx2 + d2/dy2 (+ d2/dz2), 9 (19) points, second order"},
      {"ddx", Operation::ddx, 1, 1, "d/dx to the right, second order"},
      {"ddy", Operation::ddy, 1, 1, "d/dy downwards, second order"},
      {"ddz", Operation::ddz, 1, 1, "d/dz from layer to layer of a volume, second order"},
      {"diffuse", Operation::diffuse, 2, 2, "diffuse(D, u): div(D grad u), second order"},
      {"neighbours", Operation::neighbours, 1, 1, "sum of the four cells beside; of six in a volume"},
      {"corners", Operation::corners, 1, 1,
       "sum of the four cells at the corners; of twelve across edges in a volume"},
      {"around", Operation::around, 1, 1,
       "sum of the 8 cells around, of 26 in a volume; on a mesh as neighbours"},
      {"noise", Operation::noise, 1, 1, "noise(k): -1 to 1, new in each cell and step"},
      {"random", Operation::random, 1, 1, "random(k): -1 to 1, new in each cell"},
  };
  return functions;
}

bool isExpressionName(std::string_view name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  if (name.empty() || name.size() > 64 || !letter(name[0])) return false;
  if (!std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9'); }))
    return false;
  constexpr std::array<std::string_view, 10> words = {"and", "or", "not", "x",     "y",
                                                      "t",   "pi", "pow", "width", "height"};
  if (std::find(words.begin(), words.end(), name) != words.end()) return false;
  const auto functions = expressionFunctions();
  return std::none_of(functions.begin(), functions.end(),
                      [&](const ExpressionFunction& function) { return name == function.name; });
}

std::string ExpressionTree::text() const {
  std::string out;
  if (!nodes.empty()) writeTree(*this, root(), 0, out);
  return out;
}

}  // namespace simreel::scene
