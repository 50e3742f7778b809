#pragma once
#include "kernels/spirv/module.hpp"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace simreel::kernels {

/// Upper bounds of integers, from how they are made and from the branches that lead to a block. Keeps its
/// own copy of the body, so a pass may change the module's while it asks.
class Facts {
 public:
  explicit Facts(const Module& module);

  /// Returns an upper bound of an integer, read as unsigned, in the block with this label; 0xffffffff if
  /// nothing is known.
  [[nodiscard]] std::uint32_t atMost(Id value, Id block) const { return atMost(value, block, 8); }
  /// True if every path to block `b` leads through block `a`.
  [[nodiscard]] bool dominates(Id a, Id b) const;

 private:
  struct Node {
    std::vector<Id> before;  ///< labels of the predecessors
    Instruction end;         ///< the branch at its end
    Id dominator = 0;        ///< immediate; 0 for the first block of a function
    std::size_t order = 0;   ///< in reverse postorder
  };

  void read();
  void dominate(Id first);
  [[nodiscard]] const Instruction* made(Id value) const;
  [[nodiscard]] std::uint32_t atMost(Id value, Id block, int depth) const;
  [[nodiscard]] std::uint32_t fromParts(const Instruction& one, Id block, int depth) const;
  [[nodiscard]] std::uint32_t fromBuiltIn(const Instruction& one) const;
  [[nodiscard]] std::uint32_t fromBranches(Id value, Id block, int depth) const;
  [[nodiscard]] std::uint32_t fromCondition(Id condition, bool holds, Id value, Id block, int depth) const;
  [[nodiscard]] std::uint32_t fromComparison(SpvOp op, Id value, std::uint32_t limit, Id block) const;
  [[nodiscard]] bool countsUp(Id value, Id block) const;
  [[nodiscard]] Id plain(Id value) const;
  [[nodiscard]] Id inputOf(Id variable) const;

  const Module& module_;
  std::vector<Instruction> body_;
  std::unordered_map<Id, std::size_t> made_;
  std::unordered_map<Id, Id> in_;  ///< the block of each instruction with a result
  std::unordered_map<Id, Node> blocks_;
  std::unordered_map<Id, Id> stored_;  ///< values of variables with a single store; 0 for several
};

}  // namespace simreel::kernels
