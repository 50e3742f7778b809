#pragma once
#include "kernels/spirv/module.hpp"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace simreel::kernels {

/// Upper bounds of integers. They are derived from the instructions that compute the integers and from the
/// branches that lead to a block. The object copies the body, so a pass may change the module while it
/// queries bounds.
class Facts {
 public:
  explicit Facts(const Module& module);

  /// Returns an upper bound of an integer, read as unsigned, in the block with label `block`. Returns
  /// 0xffffffff if nothing is known.
  [[nodiscard]] std::uint32_t atMost(Id value, Id block) const { return atMost(value, block, 8); }
  /// Returns true if every path to block `b` leads through block `a`.
  [[nodiscard]] bool dominates(Id a, Id b) const;

 private:
  struct Node {
    std::vector<Id> before;  ///< labels of the predecessor blocks
    Instruction end;         ///< branch at the end of the block
    Id dominator = 0;        ///< label of the immediate dominator; 0 for the first block of a function
    std::size_t order = 0;   ///< index in reverse postorder
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
  std::unordered_map<Id, std::size_t> definitions_;
  std::unordered_map<Id, Id> in_;  ///< label of the block that contains each instruction, by result id
  std::unordered_map<Id, Node> blocks_;
  std::unordered_map<Id, Id> stored_;  ///< value of each variable with a single store; 0 for several stores
};

}  // namespace simreel::kernels
