#include "sim/reaction/rule/graph.hpp"

#include "base/error.hpp"
#include "sim/reaction/rule/model.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace simreel::sim {

namespace {

constexpr int lowestNormal = -126;
constexpr int flushedQuantum = -96;

/// Returns the maximum q <= 0 for which the number is a multiple of 2^q.
int quantumOf(float number) {
  if (number == 0) return 0;
  const auto bits = std::bit_cast<std::uint32_t>(number);
  const int exponent = static_cast<int>(bits >> 23U & 255U) - 127 - 23;
  return std::min(exponent + std::countr_zero((bits & 0x7fffffU) | 0x800000U), 0);
}

}  // namespace

float computed(RuleOp op, float a, float b, float c) {
  switch (op) {
    case RuleOp::add:
      return a + b;
    case RuleOp::subtract:
      return a - b;
    case RuleOp::multiply:
      return a * b;
    case RuleOp::flush:
      return shader::reaction::grained(a, flushedGrain);
    case RuleOp::settle:
      return shader::reaction::grained(a, storedGrain);
    case RuleOp::reciprocal:
      return shader::exactReciprocal(a);
    case RuleOp::min:
      return std::min(a, b);
    case RuleOp::max:
      return std::max(a, b);
    case RuleOp::abs:
      return std::abs(a);
    case RuleOp::floor:
      return std::floor(a);
    case RuleOp::sqrt:
      return shader::exactSqrt(std::max(a, 0.0F));
    case RuleOp::exp:
      return shader::exactExp(a);
    case RuleOp::log:
      return shader::exactLog(std::max(a, 1e-30F));
    case RuleOp::sin:
      return shader::exactSin(a);
    case RuleOp::cos:
      return shader::exactCos(a);
    case RuleOp::tanh:
      return shader::reaction::exactTanh(a);
    case RuleOp::power:
      return shader::exactPow(a, b);
    case RuleOp::less:
      return a < b ? 1.0F : 0.0F;
    case RuleOp::lessEqual:
      return a <= b ? 1.0F : 0.0F;
    case RuleOp::equal:
      return a == b ? 1.0F : 0.0F;
    case RuleOp::choose:
      return a != 0 ? b : c;
    default:
      break;
  }
  SIMREEL_CHECK(false);
  return 0;
}

int RuleGraph::add(const RuleNode& node, int quantum, bool uniform) {
  const auto [at, isNew] = known_.emplace(node, size());
  if (isNew) {
    nodes_.push_back(node);
    quanta_.push_back(quantum);
    uniform_.push_back(uniform);
  }
  return at->second;
}

int RuleGraph::make(const RuleNode& node, int quantum) {
  bool constants = true, uniform = true;
  float values[3] = {0, 0, 0};
  const int arguments[3] = {node.a, node.b, node.c};
  for (int i = 0; i < 3; ++i) {
    if (arguments[i] < 0) continue;
    constants = constants && isConstant(arguments[i]);
    uniform = uniform && isUniform(arguments[i]);
    values[i] = at(arguments[i]).number;
  }
  if (constants) return constant(static_cast<double>(computed(node.op, values[0], values[1], values[2])));
  // Uniform values are computed on the CPU and uploaded as multiples of 2^-60.
  return add(node, uniform ? storedQuantum : std::max(quantum, -149), uniform);
}

int RuleGraph::constant(double value) {
  auto number = static_cast<float>(value);
  if (std::abs(number) < 1e-30F) number = 0;
  return add({RuleOp::constant, number}, quantumOf(number), true);
}

int RuleGraph::input(RuleOp op, int index) {
  const int quantum = op == RuleOp::x || op == RuleOp::y || op == RuleOp::z ? -1
                      : op == RuleOp::noise || op == RuleOp::random         ? -23
                                                                            : storedQuantum;
  return add({op, 0, index}, quantum, false);
}

// Stored values are multiples of 2^-60, and stencils are integer combinations of them.
int RuleGraph::stencil(RuleOp op, int argument) {
  if (isUniform(argument)) {
    const int factor = op == RuleOp::edges     ? edges_
                       : op == RuleOp::corners ? corners_
                       : op == RuleOp::tips    ? 8
                                               : 0;
    return product(constant(factor), argument);
  }
  return add({op, 0, 0, argument}, storedQuantum, false);
}

int RuleGraph::sum(int a, int b) {
  if (is(a, 0)) return b;
  if (is(b, 0)) return a;
  if (a > b) std::swap(a, b);
  return make({RuleOp::add, 0, 0, a, b}, std::min(quantum(a), quantum(b)));
}

int RuleGraph::difference(int a, int b) {
  if (is(b, 0)) return a;
  if (a == b) return constant(0);
  return make({RuleOp::subtract, 0, 0, a, b}, std::min(quantum(a), quantum(b)));
}

int RuleGraph::rawProduct(int a, int b) {
  if (is(a, 0) || is(b, 0)) return constant(0);
  if (is(a, 1)) return b;
  if (is(b, 1)) return a;
  if (a > b) std::swap(a, b);
  return make({RuleOp::multiply, 0, 0, a, b}, quantum(a) + quantum(b));
}

int RuleGraph::product(int a, int b) {
  const int raw = rawProduct(a, b);
  if (at(raw).op != RuleOp::multiply || quantum(raw) >= lowestNormal) return raw;
  return make({RuleOp::flush, 0, 0, raw}, flushedQuantum);
}

int RuleGraph::quotient(int a, int b) {
  return product(a, function(RuleOp::reciprocal, b));
}

int RuleGraph::function(RuleOp op, int a) {
  // If every nonzero result has at least the magnitude 2^m, the result is a multiple of 2^(m - 23).
  int q = quantum(a);
  if (op == RuleOp::reciprocal || op == RuleOp::exp)
    q = -123;  // the magnitude is at least 1e-30
  else if (op == RuleOp::sqrt)
    q = q / 2 - 25;
  else if (op == RuleOp::log)
    q = -48;
  else if (op == RuleOp::sin || op == RuleOp::cos)
    q = std::min(q, -45) - 24;
  else if (op == RuleOp::tanh)
    q -= 24;
  else if (op == RuleOp::floor)
    q = 0;
  const int node = make({op, 0, 0, a}, q);
  if (isConstant(node) || quantum(node) >= lowestNormal) return node;
  return make({RuleOp::flush, 0, 0, node}, flushedQuantum);
}

int RuleGraph::function(RuleOp op, int a, int b) {
  const bool decides = op == RuleOp::less || op == RuleOp::lessEqual || op == RuleOp::equal;
  return make({op, 0, 0, a, b}, decides               ? 0
                                : op == RuleOp::power ? -123
                                                      : std::min(quantum(a), quantum(b)));
}

int RuleGraph::choose(int condition, int then, int otherwise) {
  if (isConstant(condition)) return at(condition).number != 0 ? then : otherwise;
  if (then == otherwise) return then;
  return make({RuleOp::choose, 0, 0, condition, then, otherwise},
              std::min(quantum(then), quantum(otherwise)));
}

}  // namespace simreel::sim
