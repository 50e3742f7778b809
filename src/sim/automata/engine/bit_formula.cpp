#include "sim/automata/engine/bit_formula.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

using Order = std::array<unsigned, 9>;

/// GLSL names of the nine cells' words, row by row.
constexpr const char* cellWords[] = {"above.west", "above.here", "above.east", "here.west", "alive",
                                     "here.east",  "below.west", "below.here", "below.east"};

class Diagram {
 public:
  Diagram(const CellRule& rule, const Order& order) : order_(order) {
    std::vector<bool> table(512);
    for (unsigned i = 0; i < 512; ++i) {
      unsigned cells = 0;
      for (unsigned k = 0; k < 9; ++k)
        if ((i >> (8 - k) & 1U) != 0) cells |= 1U << order_[k];
      table[i] = rule.outcome(cells);
    }
    root_ = node(0, table);
  }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }

  [[nodiscard]] std::string text() const {
    std::string result;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      result += fmt::format("WORD n{}={};", i + 2, expression(nodes_[i]));
    return result + fmt::format("return {};", value(root_));
  }

 private:
  struct Node {
    unsigned cell;
    int dead, alive;  ///< Indices of the child nodes for a dead and for a live cell: 0 is the constant
                      ///< false, 1 the constant true, and i is nodes_[i - 2].
  };

  int node(unsigned depth, const std::vector<bool>& table) {
    if (std::all_of(table.begin(), table.end(), [&](bool b) { return b == table[0]; }))
      return table[0] ? 1 : 0;
    const auto key = std::pair(depth, table);
    if (const auto found = known_.find(key); found != known_.end()) return found->second;
    const auto half = table.begin() + static_cast<std::ptrdiff_t>(table.size() / 2);
    const int dead = node(depth + 1, {table.begin(), half});
    const int alive = node(depth + 1, {half, table.end()});
    int result = dead;
    if (dead != alive) {
      const auto [at, fresh] =
          unique_.emplace(std::array<int, 3>{static_cast<int>(order_[depth]), dead, alive},
                          static_cast<int>(nodes_.size()) + 2);
      if (fresh) nodes_.push_back({order_[depth], dead, alive});
      result = at->second;
    }
    known_.emplace(key, result);
    return result;
  }

  [[nodiscard]] static std::string value(int node) {
    return node == 0 ? "WORD(0u)" : node == 1 ? "~WORD(0u)" : fmt::format("n{}", node);
  }
  [[nodiscard]] static std::string expression(const Node& n) {
    const char* cell = cellWords[n.cell];
    if (n.dead == 0 && n.alive == 1) return cell;
    if (n.dead == 1 && n.alive == 0) return fmt::format("~{}", cell);
    if (n.dead == 0) return fmt::format("{}&n{}", cell, n.alive);
    if (n.alive == 0) return fmt::format("n{}&~{}", n.dead, cell);
    if (n.dead == 1) return fmt::format("~{}|n{}", cell, n.alive);
    if (n.alive == 1) return fmt::format("{}|n{}", cell, n.dead);
    return fmt::format("choose({},n{},n{})", cell, n.dead, n.alive);
  }

  Order order_;
  std::vector<Node> nodes_;
  std::map<std::pair<unsigned, std::vector<bool>>, int> known_;
  std::map<std::array<int, 3>, int> unique_;
  int root_ = 0;
};

}  // namespace

std::string bitFormula(const CellRule& rule) {
  constexpr int shuffles = 24;
  Order order{4, 1, 3, 5, 7, 0, 2, 6, 8};
  std::string best;
  std::size_t minimum = 0;
  unsigned random = 1;
  for (int trial = 0; trial <= shuffles; ++trial) {
    const Diagram diagram(rule, order);
    if (trial == 0 || diagram.size() < minimum) {
      minimum = diagram.size();
      best = diagram.text();
    }
    for (std::size_t i = order.size() - 1; i > 0; --i) {
      random = random * 747796405U + 2891336453U;
      std::swap(order[i], order[(random >> 16U) % (i + 1)]);
    }
  }
  return best;
}

}  // namespace simreel::sim
