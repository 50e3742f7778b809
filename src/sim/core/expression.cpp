#include "sim/core/expression.hpp"

#include "scene/json/words.hpp"
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

using scene::Operation;

double single(float (*function)(float), double x) {
  return static_cast<double>(function(static_cast<float>(x)));
}

/// Returns base^exponent. Integer exponents between -64 and 64 are computed by multiplication. For other
/// exponents, a negative base counts as 0.
double power(double base, double exponent) {
  const double whole = std::floor(exponent);
  if (whole == exponent && std::abs(whole) <= 64) {
    double product = 1;
    for (int i = 0; i < static_cast<int>(std::abs(whole)); ++i) product *= base;
    return whole < 0 ? 1 / product : product;
  }
  return static_cast<double>(
      shader::exactPow(static_cast<float>(std::max(base, 0.0)), static_cast<float>(exponent)));
}

double tanhOf(double x) {
  const double e = single(shader::exactExp, 2 * std::clamp(x, -20.0, 20.0));
  return 1 - 2 / (e + 1);
}

double computed(Operation operation, double a, double b, double c) {
  switch (operation) {
    case Operation::negate:
      return -a;
    case Operation::add:
      return a + b;
    case Operation::subtract:
      return a - b;
    case Operation::multiply:
      return a * b;
    case Operation::divide:
      return a / b;
    case Operation::power:
      return power(a, b);
    case Operation::less:
      return a < b ? 1 : 0;
    case Operation::lessEqual:
      return a <= b ? 1 : 0;
    case Operation::equal:
      return a == b ? 1 : 0;
    case Operation::notEqual:
      return a != b ? 1 : 0;
    case Operation::both:
      return a != 0 && b != 0 ? 1 : 0;
    case Operation::either:
      return a != 0 || b != 0 ? 1 : 0;
    case Operation::opposite:
      return a == 0 ? 1 : 0;
    case Operation::min:
      return std::min(a, b);
    case Operation::max:
      return std::max(a, b);
    case Operation::clamp:
      return std::min(std::max(a, b), c);
    case Operation::step:
      return b < a ? 0 : 1;
    case Operation::abs:
      return std::abs(a);
    case Operation::floor:
      return std::floor(a);
    case Operation::sqrt:
      return std::sqrt(std::max(a, 0.0));
    case Operation::exp:
      return single(shader::exactExp, a);
    case Operation::log:
      return single(shader::exactLog, std::max(a, 1e-30));
    case Operation::sin:
      return single(shader::exactSin, a);
    case Operation::cos:
      return single(shader::exactCos, a);
    case Operation::tanh:
      return tanhOf(a);
    case Operation::choose:
      return a != 0 ? b : c;
    default:
      return 0;
  }
}

double randomNumber(std::uint32_t element, double salt, std::uint32_t seed) {
  const auto bits = shader::hash3({element, static_cast<std::uint32_t>(salt), seed});
  return static_cast<double>(shader::signedUnit(bits.x));
}

}  // namespace

Expression::Expression(std::string_view text, const Place& place, const std::vector<std::string>& names,
                       std::span<const char* const> lookups) {
  const scene::ExpressionTree tree = scene::parseExpression(text, lookups);
  for (const scene::ExpressionTree::Node& from : tree.nodes) {
    if (from.operation >= Operation::laplacian && from.operation <= Operation::noise)
      throw scene::ExpressionMistake{from.begin, from.end, "this value cannot use neighbours and steps"};
    Node node{from.operation, from.number};
    std::copy(std::begin(from.arguments), std::end(from.arguments), node.arguments);
    if (from.operation == Operation::name) {
      node.place = place(from.name);
      if (node.place < 0)
        throw scene::ExpressionMistake{from.begin, from.end,
                                       fmt::format("unknown name {}; {}", scene::inQuotes(from.name),
                                                   scene::suggestion(from.name, names))};
    }
    nodes_.push_back(node);
  }
  results_.resize(nodes_.size());
}

double Expression::at(std::span<const double> values, std::uint32_t element, std::uint32_t seed) const {
  const auto argument = [&](const Node& node, int i) {
    return node.arguments[i] < 0 ? 0.0 : results_[static_cast<std::size_t>(node.arguments[i])];
  };
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Node& node = nodes_[i];
    double& result = results_[i];
    if (node.operation == Operation::number)
      result = node.number;
    else if (node.operation == Operation::name)
      result = values[static_cast<std::size_t>(node.place)];
    else if (node.operation == Operation::random)
      result = randomNumber(element, argument(node, 0), seed);
    else
      result = computed(node.operation, argument(node, 0), argument(node, 1), argument(node, 2));
  }
  return results_.back();
}

}  // namespace simreel::sim
