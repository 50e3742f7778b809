#include "kernels/guards/counted.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace simreel::kernels {

namespace {

/// A block: its label, and the index range of its other instructions.
struct Range {
  Id label;
  std::size_t begin, end;
};

class LoopCounting {
 public:
  LoopCounting(const Module& module, std::uint32_t maximum) : module_(module), most_(maximum) {}

  std::unordered_map<Id, CountedLoop> run() {
    split();
    std::unordered_map<Id, CountedLoop> found;
    for (std::size_t i = 0; i < blocks_.size(); ++i)
      if (const auto loop = counted(i)) found[blocks_[i].label] = *loop;
    return found;
  }

 private:
  const Instruction& at(std::size_t i) const { return module_.body[i]; }

  /// Splits the body into blocks, and collects the stores and other uses of each variable.
  void split() {
    for (std::size_t i = 0; i < module_.body.size(); ++i) {
      const Instruction& one = at(i);
      if (one.op == SpvOpLabel) {
        index_[one.result] = blocks_.size();
        blocks_.push_back({one.result, i + 1, i + 1});
      } else if (!blocks_.empty()) {
        blocks_.back().end = i + 1;
      }
      if (one.result != 0) definitions_[one.result] = i;
      if (one.op == SpvOpStore) {
        stores_[one.operands[0]].push_back(i);
        escapes_[one.operands[1]] = true;
      } else if (one.op != SpvOpLoad && one.op != SpvOpLabel) {
        for (std::size_t k = 0; k < one.operands.size(); ++k)
          if (isId(one, k)) escapes_[one.operands[k]] = true;
      }
    }
  }

  const Instruction& last(std::size_t block) const { return at(blocks_[block].end - 1); }

  const Instruction* definition(Id id) const {
    const auto found = definitions_.find(id);
    return found == definitions_.end() ? nullptr : &at(found->second);
  }

  std::optional<CountedLoop> counted(std::size_t header) const {
    const Range& block = blocks_[header];
    const auto merge = std::find_if(module_.body.begin() + static_cast<std::ptrdiff_t>(block.begin),
                                    module_.body.begin() + static_cast<std::ptrdiff_t>(block.end),
                                    [](const Instruction& one) { return one.op == SpvOpLoopMerge; });
    if (merge == module_.body.begin() + static_cast<std::ptrdiff_t>(block.end)) return {};
    const Id after = merge->operands[0], next = merge->operands[1];
    if (last(header).op != SpvOpBranch || !index_.contains(last(header).operands[0])) return {};
    const std::size_t test = index_.at(last(header).operands[0]);
    const Instruction& branch = last(test);
    if (branch.op != SpvOpBranchConditional || branch.operands[2] != after) return {};
    const Instruction* condition = definition(branch.operands[0]);
    if (condition == nullptr || condition->operands.size() != 2) return {};
    const Instruction* load = definition(condition->operands[0]);
    const auto end = module_.constant(condition->operands[1]);
    if (load == nullptr || load->op != SpvOpLoad || !end) return {};
    CountedLoop loop{load->operands[0], condition->op, condition->operands[1]};
    if (!exits(test, header, after)) return {};
    const auto begin = first(loop.variable, header), step = stepOf(loop.variable, header, after, next);
    if (!begin || !step || !ends(*begin, *step, *end, loop.compare)) return {};
    return loop;
  }

  /// Returns true if only block `test` branches out of the loop.
  bool exits(std::size_t test, std::size_t header, Id after) const {
    for (std::size_t b = header; b < blocks_.size() && blocks_[b].label != after; ++b) {
      const Instruction& one = last(b);
      if (b == test) continue;
      if (one.op == SpvOpBranch && one.operands[0] == after) return false;
      if (one.op == SpvOpBranchConditional && (one.operands[1] == after || one.operands[2] == after))
        return false;
      if (one.op == SpvOpSwitch &&
          std::find(one.operands.begin() + 1, one.operands.end(), after) != one.operands.end())
        return false;
    }
    return true;
  }

  /// Returns the constant that is the counter's initial value, from the last store in the block before the
  /// loop.
  std::optional<std::int64_t> first(Id variable, std::size_t header) const {
    if (header == 0 || escapes_.contains(variable) || !stores_.contains(variable)) return {};
    const Range& before = blocks_[header - 1];
    if (last(header - 1).op != SpvOpBranch || last(header - 1).operands[0] != blocks_[header].label)
      return {};
    std::optional<std::int64_t> value;
    for (const std::size_t i : stores_.at(variable))
      if (i >= before.begin && i < before.end) value = constant(at(i).operands[1]);
    return value;
  }

  /// Returns the constant that the continue block adds to the counter, if nothing else in the loop stores
  /// to the counter.
  std::optional<std::int64_t> stepOf(Id variable, std::size_t header, Id after, Id next) const {
    if (!index_.contains(after) || !index_.contains(next) || !stores_.contains(variable)) return {};
    const Range &body = blocks_[header], &behind = blocks_[index_.at(after)],
                &back = blocks_[index_.at(next)];
    std::optional<std::size_t> only;
    for (const std::size_t i : stores_.at(variable)) {
      if (i < body.begin || i >= behind.begin) continue;
      if (only) return {};
      only = i;
    }
    if (!only || *only < back.begin || *only >= back.end) return {};
    const Instruction* sum = definition(at(*only).operands[1]);
    if (sum == nullptr || (sum->op != SpvOpIAdd && sum->op != SpvOpISub)) return {};
    const Instruction* load = definition(sum->operands[0]);
    const auto step = constant(sum->operands[1]);
    if (load == nullptr || load->op != SpvOpLoad || load->operands[0] != variable || !step) return {};
    return sum->op == SpvOpIAdd ? *step : -*step;
  }

  std::optional<std::int64_t> constant(Id id) const {
    const auto value = module_.constant(id);
    if (!value) return {};
    return static_cast<std::int32_t>(*value);
  }

  /// Returns true if the counter values `begin`, `begin + step`, ... fail the comparison after at most
  /// `most_` iterations and without overflow.
  bool ends(std::int64_t begin, std::int64_t step, std::uint32_t endBits, SpvOp compare) const {
    const bool isUnsigned = compare == SpvOpULessThan || compare == SpvOpULessThanEqual;
    const std::int64_t end =
        isUnsigned ? static_cast<std::int64_t>(endBits) : static_cast<std::int32_t>(endBits);
    constexpr std::int64_t far = std::int64_t{1} << 29;
    if (isUnsigned && begin < 0) return false;
    if (std::abs(begin) > far || std::abs(step) > far || std::abs(end) > far) return false;
    std::int64_t span = 0;
    switch (compare) {
      case SpvOpULessThan:
      case SpvOpSLessThan:
        span = end - begin;
        break;
      case SpvOpULessThanEqual:
      case SpvOpSLessThanEqual:
        span = end - begin + 1;
        break;
      case SpvOpSGreaterThan:
        span = begin - end;
        step = -step;
        break;
      case SpvOpSGreaterThanEqual:
        span = begin - end + 1;
        step = -step;
        break;
      default:
        return false;
    }
    return step > 0 && span <= step * static_cast<std::int64_t>(most_);
  }

  const Module& module_;
  std::uint32_t most_;
  std::vector<Range> blocks_;
  std::unordered_map<Id, std::size_t> index_;        ///< indices of blocks by label
  std::unordered_map<Id, std::size_t> definitions_;  ///< indices of instructions by result id
  std::unordered_map<Id, std::vector<std::size_t>> stores_;
  std::unordered_map<Id, bool> escapes_;  ///< variables that are used in other ways than by loads and
                                          ///< stores
};

}  // namespace

std::unordered_map<Id, CountedLoop> countedLoops(const Module& module, std::uint32_t maximum) {
  return LoopCounting(module, maximum).run();
}

}  // namespace simreel::kernels
