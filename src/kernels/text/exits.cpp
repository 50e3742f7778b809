#include "kernels/text/exits.hpp"

#include <cstddef>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace simreel::kernels {

namespace {

class Splitting {
 public:
  explicit Splitting(Module& module) : module_(module) {}

  void run() {
    find();
    if (phis_.empty()) return;
    std::vector<Instruction> body = std::move(module_.body);
    module_.body.clear();
    Id label = 0;
    for (Instruction& one : body) {
      if (one.op == SpvOpLabel) label = one.result;
      const auto test = tests_.find(label);
      if (one.op == SpvOpBranchConditional && test != tests_.end()) {
        split(std::move(one), label, test->second);
      } else {
        module_.body.push_back(std::move(one));
      }
    }
    rename();
    module_.index();
  }

 private:
  /// Finds the blocks that test whether a loop continues, with the labels of the loops' merge blocks. Such
  /// a block is the loop header or the block to which the header branches.
  void find() {
    Id label = 0, after = 0;
    for (const Instruction& one : module_.body) {
      if (one.op == SpvOpLabel) {
        label = one.result;
        after = 0;
      }
      if (one.op == SpvOpPhi) phis_.insert(label);
      if (one.op == SpvOpLoopMerge) after = one.operands[0];
      if (after != 0 && one.op == SpvOpBranch) tests_[one.operands[0]] = after;
      if (after != 0 && one.op == SpvOpBranchConditional) tests_[label] = after;
    }
  }

  void split(Instruction branch, Id label, Id after) {
    const std::size_t out = branch.operands[1] == after ? 1 : 2;
    if (branch.operands[out] != after || !phis_.contains(after)) {
      module_.body.push_back(std::move(branch));
      return;
    }
    const SpvOp before = module_.body.back().op;
    if (before != SpvOpSelectionMerge && before != SpvOpLoopMerge)
      module_.body.push_back(
          {SpvOpSelectionMerge, 0, 0, {branch.operands[3 - out], SpvSelectionControlMaskNone}});
    const Id made = module_.fresh();
    branch.operands[out] = made;
    module_.body.push_back(std::move(branch));
    module_.body.push_back({SpvOpLabel, 0, made, {}});
    module_.body.push_back({SpvOpBranch, 0, 0, {after}});
    moved_[after][label] = made;
  }

  /// Changes the phis to refer to the new blocks.
  void rename() {
    Id label = 0;
    for (Instruction& one : module_.body) {
      if (one.op == SpvOpLabel) label = one.result;
      if (one.op != SpvOpPhi || !moved_.contains(label)) continue;
      const auto& names = moved_.at(label);
      for (std::size_t i = 1; i < one.operands.size(); i += 2)
        if (const auto found = names.find(one.operands[i]); found != names.end())
          one.operands[i] = found->second;
    }
  }

  Module& module_;
  std::unordered_set<Id> phis_;  ///< labels of blocks that contain phis
  std::unordered_map<Id, Id> tests_;
  std::unordered_map<Id, std::unordered_map<Id, Id>> moved_;  ///< labels of new blocks by target and origin
                                                              ///< of the branch
};

}  // namespace

void splitLoopExits(Module& module) {
  for (Instruction& one : module.globals)
    if (one.op == SpvOpUndef) one.op = SpvOpConstantNull;
  Splitting(module).run();
}

}  // namespace simreel::kernels
