#include "kernels/spirv/facts.hpp"

#include "kernels/spirv/writing.hpp"

#include <GLSL.std.450.h>
#include <algorithm>
#include <bit>
#include <utility>

namespace simreel::kernels {

namespace {

constexpr std::uint32_t unknown = 0xffffffffU;

std::vector<Id> targetsOf(const Instruction& end) {
  switch (end.op) {
    case SpvOpBranch:
      return {end.operands[0]};
    case SpvOpBranchConditional:
      return {end.operands[1], end.operands[2]};
    case SpvOpSwitch: {
      std::vector<Id> targets = {end.operands[1]};
      for (std::size_t i = 3; i < end.operands.size(); i += 2) targets.push_back(end.operands[i]);
      return targets;
    }
    default:
      return {};
  }
}

std::uint32_t narrow(std::uint64_t bound) {
  return bound < unknown ? static_cast<std::uint32_t>(bound) : unknown;
}

/// Returns the comparison that holds exactly if `op` does not hold. Returns OpNop for other operations.
SpvOp opposite(SpvOp op) {
  switch (op) {
    case SpvOpUGreaterThanEqual:
      return SpvOpULessThan;
    case SpvOpUGreaterThan:
      return SpvOpULessThanEqual;
    case SpvOpSGreaterThanEqual:
      return SpvOpSLessThan;
    case SpvOpSGreaterThan:
      return SpvOpSLessThanEqual;
    case SpvOpINotEqual:
      return SpvOpIEqual;
    default:
      return SpvOpNop;
  }
}

}  // namespace

Facts::Facts(const Module& module) : module_(module), body_(module.body) {
  read();
  Id first = 0;
  for (std::size_t i = 0; i < body_.size(); ++i) {
    if (body_[i].op == SpvOpFunction) first = 0;
    if (body_[i].op == SpvOpLabel && first == 0) dominate(first = body_[i].result);
  }
}

void Facts::read() {
  Id label = 0;
  for (std::size_t i = 0; i < body_.size(); ++i) {
    const Instruction& one = body_[i];
    if (one.op == SpvOpLabel) label = one.result;
    if (one.result != 0) {
      definitions_[one.result] = i;
      in_[one.result] = label;
    }
    if (one.op == SpvOpStore) {
      const bool first = !stored_.contains(one.operands[0]);
      stored_[one.operands[0]] = first ? one.operands[1] : 0;
    }
    const std::vector<Id> targets = targetsOf(one);
    if (targets.empty()) continue;
    blocks_[label].end = one;
    for (const Id target : targets) blocks_[target].before.push_back(label);
  }
}

/// Finds the dominators of a function's blocks (Cooper, Harvey and Kennedy 2001).
void Facts::dominate(Id first) {
  std::vector<Id> order;
  std::vector<std::pair<Id, std::size_t>> path = {{first, 0}};
  std::unordered_map<Id, bool> seen = {{first, true}};
  while (!path.empty()) {
    const std::vector<Id> targets = targetsOf(blocks_[path.back().first].end);
    if (path.back().second == targets.size()) {
      order.push_back(path.back().first);
      path.pop_back();
      continue;
    }
    const Id next = targets[path.back().second++];
    if (!std::exchange(seen[next], true)) path.emplace_back(next, 0);
  }
  std::reverse(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i) blocks_[order[i]].order = i;
  const auto meet = [&](Id a, Id b) {
    while (a != b) {
      while (blocks_[a].order > blocks_[b].order) a = blocks_[a].dominator;
      while (blocks_[b].order > blocks_[a].order) b = blocks_[b].dominator;
    }
    return a;
  };
  blocks_[first].dominator = first;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 1; i < order.size(); ++i) {
      Id found = 0;
      for (const Id before : blocks_[order[i]].before)
        if (blocks_[before].dominator != 0) found = found == 0 ? before : meet(found, before);
      changed = std::exchange(blocks_[order[i]].dominator, found) != found || changed;
    }
  }
  blocks_[first].dominator = 0;
}

bool Facts::dominates(Id a, Id b) const {
  for (; b != 0; b = blocks_.contains(b) ? blocks_.at(b).dominator : 0)
    if (a == b) return true;
  return false;
}

const Instruction* Facts::made(Id value) const {
  const auto found = definitions_.find(value);
  return found == definitions_.end() ? nullptr : &body_[found->second];
}

/// Returns the original value if `value` only changes the signedness of another value.
Id Facts::plain(Id value) const {
  const Instruction* one = made(value);
  return one != nullptr && one->op == SpvOpBitcast ? plain(one->operands[0]) : value;
}

std::uint32_t Facts::atMost(Id value, Id block, int depth) const {
  value = plain(value);
  if (const auto constant = module_.constant(value)) return *constant;
  const Instruction* one = made(value);
  if (one == nullptr || depth == 0) return unknown;
  return std::min(fromParts(*one, block, depth - 1), fromBranches(value, block, depth - 1));
}

std::uint32_t Facts::fromParts(const Instruction& one, Id block, int depth) const {
  const auto of = [&](std::size_t i) { return atMost(one.operands[i], block, depth); };
  const auto wide = [&](std::size_t i) { return std::uint64_t{of(i)}; };
  switch (one.op) {
    case SpvOpBitwiseAnd:
      return std::min(of(0), of(1));
    case SpvOpBitwiseOr:
    case SpvOpBitwiseXor:
      return narrow((std::uint64_t{1} << std::bit_width(std::max(of(0), of(1)))) - 1);
    case SpvOpIAdd:
      return narrow(wide(0) + wide(1));
    case SpvOpIMul:
      return narrow(wide(0) * wide(1));
    case SpvOpSelect:
      return std::max(of(1), of(2));
    case SpvOpUMod:
    case SpvOpUDiv:
    case SpvOpShiftRightLogical: {
      const auto by = module_.constant(one.operands[1]);
      if (!by || (*by == 0 && one.op != SpvOpShiftRightLogical)) return unknown;
      if (one.op == SpvOpUMod) return std::min(of(0), *by - 1);
      if (one.op == SpvOpUDiv) return of(0) / *by;
      return *by < 32 ? of(0) >> *by : unknown;
    }
    case SpvOpExtInst:
      return one.operands[1] == GLSLstd450UMin ? std::min(of(2), of(3)) : unknown;
    case SpvOpLoad:
    case SpvOpCompositeExtract:
      return fromBuiltIn(one);
    default:
      return unknown;
  }
}

/// If a variable holds a parameter of a function, returns the function's argument. Returns other variables
/// unchanged.
Id Facts::inputOf(Id variable) const {
  const auto found = stored_.find(variable);
  const Instruction* value = found == stored_.end() ? nullptr : made(found->second);
  return value != nullptr && value->op == SpvOpLoad ? value->operands[0] : variable;
}

/// Returns an upper bound of a component of the invocation's index in its workgroup.
std::uint32_t Facts::fromBuiltIn(const Instruction& one) const {
  const auto size = groupSize(module_);
  const Instruction* from = made(one.operands[0]);
  Id variable = one.operands[0];
  std::uint32_t axis = 0;
  bool picked = false;
  if (one.op == SpvOpCompositeExtract) {
    if (from == nullptr || from->op != SpvOpLoad || one.operands.size() != 2) return unknown;
    variable = from->operands[0];
    axis = one.operands[1];
    picked = true;
  } else if (from != nullptr && from->op == SpvOpAccessChain && from->operands.size() == 2) {
    variable = from->operands[0];
    const auto constant = module_.constant(from->operands[1]);
    if (!constant) return unknown;
    axis = *constant;
    picked = true;
  }
  const auto what = module_.decoration(inputOf(variable), SpvDecorationBuiltIn);
  if (!what) return unknown;
  if (*what == SpvBuiltInLocalInvocationIndex && !picked) return size[0] * size[1] * size[2] - 1;
  if (*what == SpvBuiltInLocalInvocationId && picked && axis < 3) return size[axis] - 1;
  return unknown;
}

/// Returns an upper bound of a value in a block from the conditions of the branches that lead to the block.
std::uint32_t Facts::fromBranches(Id value, Id block, int depth) const {
  std::uint32_t bound = unknown;
  for (Id at = block; at != 0 && blocks_.contains(at); at = blocks_.at(at).dominator) {
    const Node& here = blocks_.at(at);
    if (here.before.size() != 1) continue;
    const Instruction& branch = blocks_.at(here.before[0]).end;
    if (branch.op != SpvOpBranchConditional || branch.operands[1] == branch.operands[2]) continue;
    bound = std::min(bound, fromCondition(branch.operands[0], branch.operands[1] == at, value, at, depth));
  }
  return bound;
}

std::uint32_t Facts::fromCondition(Id condition, bool holds, Id value, Id block, int depth) const {
  const Instruction* one = made(condition);
  if (one == nullptr || depth == 0) return unknown;
  if (one->op == SpvOpLogicalNot) return fromCondition(one->operands[0], !holds, value, block, depth - 1);
  if ((one->op == SpvOpLogicalAnd && holds) || (one->op == SpvOpLogicalOr && !holds))
    return std::min(fromCondition(one->operands[0], holds, value, block, depth - 1),
                    fromCondition(one->operands[1], holds, value, block, depth - 1));
  if (one->operands.size() != 2 || plain(one->operands[0]) != value) return unknown;
  const SpvOp op = holds ? one->op : opposite(one->op);
  return op == SpvOpNop ? unknown
                        : fromComparison(op, value, atMost(one->operands[1], block, depth - 1), block);
}

/// Returns an upper bound from a comparison that holds in a block and in the blocks that it dominates.
std::uint32_t Facts::fromComparison(SpvOp op, Id value, std::uint32_t limit, Id block) const {
  switch (op) {
    case SpvOpULessThan:
      return limit == 0 ? 0 : limit - 1;
    case SpvOpULessThanEqual:
    case SpvOpIEqual:
      return limit;
    case SpvOpSLessThan:
    case SpvOpSLessThanEqual:
      if (limit == 0 || limit > 0x3fffffffU || !countsUp(value, block)) return unknown;
      return op == SpvOpSLessThan ? limit - 1 : limit;
    default:
      return unknown;
  }
}

/// True for a loop counter that starts at a constant and is increased by a constant only after the
/// comparison that leads to `block` has held.
bool Facts::countsUp(Id value, Id block) const {
  const Instruction* phi = made(value);
  if (phi == nullptr || phi->op != SpvOpPhi || phi->operands.size() != 4) return false;
  constexpr std::uint32_t far = 0x3fffffffU;
  for (const std::size_t start : {std::size_t{0}, std::size_t{2}}) {
    const auto begin = module_.constant(phi->operands[start]);
    const Instruction* sum = made(phi->operands[2 - start]);
    if (!begin || *begin > far || sum == nullptr || sum->op != SpvOpIAdd || sum->operands[0] != value)
      continue;
    const auto step = module_.constant(sum->operands[1]);
    return step && *step <= far && dominates(block, in_.at(sum->result));
  }
  return false;
}

}  // namespace simreel::kernels
