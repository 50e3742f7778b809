#include "sim/reaction/rule/rule_cost.hpp"

#include <cstddef>
#include <vector>

namespace simreel::sim {

namespace {

int costOfOp(RuleOp op) {
  switch (op) {
    case RuleOp::constant:
    case RuleOp::uniform:
    case RuleOp::species:
    case RuleOp::base:
    case RuleOp::sum:
      return 0;
    case RuleOp::sixfold:
    case RuleOp::reciprocal:
      return 8;
    case RuleOp::sqrt:
      return 12;
    case RuleOp::exp:
    case RuleOp::log:
    case RuleOp::sin:
    case RuleOp::cos:
    case RuleOp::noise:
    case RuleOp::random:
      return 20;
    case RuleOp::tanh:
    case RuleOp::power:
      return 45;
    case RuleOp::edges:
    case RuleOp::corners:
    case RuleOp::tips:
      return 4;
    default:
      return 1;
  }
}

}  // namespace

int costOfRule(const Rule& rule) {
  const RuleGraph& g = rule.graph;
  std::vector<bool> asked(static_cast<std::size_t>(g.size()));
  for (const int rate : rule.rates) asked[static_cast<std::size_t>(rate)] = true;
  for (const int next : rule.nexts)
    if (next >= 0) asked[static_cast<std::size_t>(next)] = true;
  int cost = 0;
  for (int i = g.size() - 1; i >= 0; --i) {
    if (!asked[static_cast<std::size_t>(i)] || g.isUniform(i)) continue;
    cost += costOfOp(g.at(i).op);
    for (const int argument : {g.at(i).a, g.at(i).b, g.at(i).c})
      if (argument >= 0) asked[static_cast<std::size_t>(argument)] = true;
  }
  return cost;
}

}  // namespace simreel::sim
