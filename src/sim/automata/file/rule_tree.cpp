#include "sim/automata/file/rule_tree.hpp"

#include <algorithm>
#include <bit>
#include <bitset>
#include <map>
#include <unordered_map>
#include <utility>

namespace simreel::sim {

namespace {

using Bits = std::vector<std::uint64_t>;

/// Returns the table inputs in the order of a rule tree. -1 means that there is no input, so that any state
/// matches.
std::vector<int> treeOrder(TableShape shape) {
  switch (shape) {
    case TableShape::vonNeumann:
      return {1, 4, 2, 3, 0};
    case TableShape::moore:
      return {8, 2, 6, 4, 1, 7, 3, 5, 0};
    case TableShape::hexagonal:
      return {6, -1, -1, 3, 1, 5, 2, 4, 0};
    case TableShape::oneDimensional:
      return {-1, 1, 2, -1, 0};
  }
  return {};
}

/// Builds the diagram from the top down. A node corresponds to the set of transitions that can still apply.
/// Equal sets become one node, and so do nodes with equal children.
class TreeBuilder {
 public:
  TreeBuilder(const std::vector<RuleTransition>& table, TableShape shape, int states)
      : table_(table), order_(treeOrder(shape)), states_(static_cast<std::size_t>(states)) {
    const std::size_t words = (table.size() + 63) / 64;
    const Bits none(words);
    applies_.assign(order_.size(), std::vector<Bits>(states_, none));
    certain_.assign(order_.size() + 1, none);
    std::bitset<256> every;
    for (std::size_t s = 0; s < states_; ++s) every.set(s);
    for (std::size_t r = 0; r < table.size(); ++r) mark(certain_[order_.size()], r);
    // Tables use few different sets of states, so transitions are grouped by set.
    for (std::size_t depth = order_.size(); depth-- > 0;) {
      std::unordered_map<std::bitset<256>, Bits> having;
      for (std::size_t r = 0; r < table.size(); ++r) {
        const auto input = static_cast<std::size_t>(std::max(order_[depth], 0));
        const std::bitset<256> fits = order_[depth] < 0 ? every : table[r].inputs[input] & every;
        mark(having.try_emplace(fits, none).first->second, r);
        if (fits == every && has(certain_[depth + 1], r)) mark(certain_[depth], r);
      }
      for (const auto& [fits, rows] : having)
        for (std::size_t s = 0; s < states_; ++s)
          for (std::size_t w = 0; fits[s] && w < words; ++w) applies_[depth][s][w] |= rows[w];
    }
  }

  std::shared_ptr<const RuleTree> build() {
    Bits all((table_.size() + 63) / 64);
    for (std::size_t r = 0; r < table_.size(); ++r) all[r / 64] |= std::uint64_t{1} << (r % 64);
    tree_->neighbours = static_cast<int>(order_.size()) - 1;
    tree_->root = node(0, std::move(all));
    return tooLarge_ ? nullptr : std::move(tree_);
  }

 private:
  static void mark(Bits& set, std::size_t i) { set[i / 64] |= std::uint64_t{1} << (i % 64); }
  static bool has(const Bits& set, std::size_t i) { return (set[i / 64] >> (i % 64) & 1U) != 0; }

  /// Removes the transitions after the first one that applies whatever the remaining inputs are.
  void shorten(std::size_t depth, Bits& set) const {
    for (std::size_t w = 0; w < set.size(); ++w)
      if (const std::uint64_t sure = set[w] & certain_[depth][w]; sure != 0) {
        const int first = std::countr_zero(sure);
        if (first < 63) set[w] &= (std::uint64_t{2} << first) - 1;
        std::fill(set.begin() + static_cast<std::ptrdiff_t>(w) + 1, set.end(), 0);
        return;
      }
  }

  [[nodiscard]] std::uint32_t outcome(const Bits& set, std::size_t middle) const {
    for (std::size_t w = 0; w < set.size(); ++w)
      if (set[w] != 0)
        return static_cast<std::uint32_t>(
            table_[w * 64 + static_cast<std::size_t>(std::countr_zero(set[w]))].output);
    return static_cast<std::uint32_t>(middle);
  }

  std::uint32_t node(std::size_t depth, Bits set) {
    if (tooLarge_) return 0;
    shorten(depth, set);
    const auto key = std::pair(depth, set);
    if (const auto found = known_.find(key); found != known_.end()) return found->second;
    std::vector<std::uint32_t> children(states_);
    for (std::size_t s = 0; s < states_; ++s) {
      Bits left = set;
      for (std::size_t w = 0; w < left.size(); ++w) left[w] &= applies_[depth][s][w];
      children[s] = depth + 1 == order_.size() ? outcome(left, s) : node(depth + 1, std::move(left));
    }
    const auto [at, fresh] =
        unique_[depth].try_emplace(children, static_cast<std::uint32_t>(tree_->items.size()));
    if (fresh) tree_->items.insert(tree_->items.end(), children.begin(), children.end());
    if (tree_->items.size() > maxTreeItems || known_.size() * set.size() > maxTreeItems) tooLarge_ = true;
    known_.emplace(key, at->second);
    return at->second;
  }

  const std::vector<RuleTransition>& table_;
  std::vector<int> order_;
  std::size_t states_;
  std::vector<std::vector<Bits>> applies_;  ///< transitions that accept a state; indices are the depth and
                                            ///< the state
  std::vector<Bits> certain_;               ///< transitions that accept all remaining inputs; the index is
                                            ///< the depth
  std::map<std::pair<std::size_t, Bits>, std::uint32_t> known_;
  std::map<std::size_t, std::map<std::vector<std::uint32_t>, std::uint32_t>> unique_;
  std::shared_ptr<RuleTree> tree_ = std::make_shared<RuleTree>();
  bool tooLarge_ = false;
};

}  // namespace

int neighboursOf(TableShape shape) {
  return shape == TableShape::moore        ? 8
         : shape == TableShape::hexagonal  ? 6
         : shape == TableShape::vonNeumann ? 4
                                           : 2;
}

std::shared_ptr<const RuleTree> treeOf(const std::vector<RuleTransition>& table, TableShape shape,
                                       int states) {
  return TreeBuilder(table, shape, states).build();
}

}  // namespace simreel::sim
