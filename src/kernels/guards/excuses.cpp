#include "kernels/guards/excuses.hpp"

#include <algorithm>
#include <cstddef>
#include <unordered_set>

namespace simreel::kernels {

namespace {

class Search {
 public:
  explicit Search(const Module& module) : module_(module) {
    for (std::size_t i = 0; i < module.body.size(); ++i) {
      const Instruction& one = module.body[i];
      if (one.op == SpvOpFunction) begin_ = i;
      if (one.result != 0) definitions_[one.result] = i;
      for (std::size_t k = 0; k < one.operands.size(); ++k)
        if (isId(one, k)) uses_[one.operands[k]].push_back(i);
      begins_.push_back(begin_);
    }
  }

  Excuses found() {
    for (std::size_t i = 0; i < module_.body.size(); ++i) {
      const Instruction& one = module_.body[i];
      if (one.op == SpvOpLogicalAnd) excuse(i, one.operands[0], 1, true);
      if (one.op == SpvOpLogicalOr) excuse(i, one.operands[0], 1, false);
      if (one.op != SpvOpSelect || module_.typeOf(one.operands[0]) == 0) continue;
      excuse(i, one.operands[0], 1, true);
      excuse(i, one.operands[0], 2, false);
    }
    return std::move(excuses_);
  }

 private:
  /// Excuses all values that are used only by operand `side` of instruction `last`. They are not needed
  /// unless `condition` has the value `needed`.
  void excuse(std::size_t last, Id condition, std::size_t side, bool needed) {
    const Instruction& one = module_.body[last];
    if (module_.signature(module_.typeOf(condition)) != "b1" || one.operands[side] == condition) return;
    const auto known = definitions_.find(condition);
    const std::size_t first = std::max(known == definitions_.end() ? 0 : known->second, begins_[last]);
    std::unordered_set<std::size_t> tree;
    for (std::size_t i = last; i-- > first + 1;) {
      const Instruction& value = module_.body[i];
      if (value.result == 0 || value.op == SpvOpPhi || value.op == SpvOpLabel) continue;
      const auto uses = uses_.find(value.result);
      if (uses == uses_.end()) continue;
      const bool only = std::all_of(uses->second.begin(), uses->second.end(), [&](std::size_t use) {
        return tree.contains(use) || (use == last && isOnly(one, value.result, side));
      });
      if (!only) continue;
      tree.insert(i);
      excuses_[value.result].emplace_back(condition, needed);
    }
  }
  /// Returns true if `value` is operand `side` of an instruction and is not another operand as well.
  static bool isOnly(const Instruction& one, Id value, std::size_t side) {
    for (std::size_t i = 0; i < one.operands.size(); ++i)
      if ((one.operands[i] == value) != (i == side)) return false;
    return true;
  }

  const Module& module_;
  std::size_t begin_ = 0;
  std::vector<std::size_t> begins_;  ///< for each instruction: index of the first instruction of its
                                     ///< function
  std::unordered_map<Id, std::size_t> definitions_;
  std::unordered_map<Id, std::vector<std::size_t>> uses_;
  Excuses excuses_;
};

}  // namespace

Excuses excusesOf(const Module& module) {
  return Search(module).found();
}

}  // namespace simreel::kernels
