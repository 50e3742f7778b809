// Fuzzes the reader of rules. A valid rule must define a result for every neighbourhood, so all paths
// through its decision diagram must end in a state.
#include "base/error.hpp"
#include "fuzz/reader.hpp"
#include "sim/automata/file/rule_file.hpp"

#include <algorithm>
#include <vector>

namespace simreel::fuzz {
namespace {

void readRule(std::string_view bytes) {
  const sim::CellRule rule = sim::parseRuleFile(bytes, "fuzz.rule");
  SIMREEL_CHECK(rule.states >= 2 && rule.states <= 256 && rule.tree != nullptr);
  const auto states = static_cast<std::size_t>(rule.states);
  SIMREEL_CHECK(rule.colors.empty() || rule.colors.size() == states);
  const sim::RuleTree& tree = *rule.tree;
  SIMREEL_CHECK(tree.neighbours == 4 || tree.neighbours == 8);
  std::vector<std::uint32_t> nodes = {tree.root};
  for (int depth = 0; depth <= tree.neighbours; ++depth) {
    std::vector<std::uint32_t> next;
    for (const std::uint32_t node : nodes) {
      SIMREEL_CHECK(node + states <= tree.items.size());
      const auto first = tree.items.begin() + static_cast<std::ptrdiff_t>(node);
      next.insert(next.end(), first, first + static_cast<std::ptrdiff_t>(states));
    }
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    nodes = std::move(next);
  }
  for (const std::uint32_t state : nodes) SIMREEL_CHECK(state < states);
}

const Reader ruleReader("rule", readRule);

}  // namespace
}  // namespace simreel::fuzz
