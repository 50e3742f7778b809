#include "kernels/guards/loops.hpp"

#include "kernels/guards/counted.hpp"
#include "kernels/spirv/writing.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace simreel::kernels {

namespace {

bool isUnrolled(const Instruction& merge) {
  return merge.op == SpvOpLoopMerge && (merge.operands[2] & SpvLoopControlUnrollMask) != 0;
}

class Limiting {
 public:
  Limiting(Module& module, std::uint32_t maximum, bool unrolled, Report* report)
      : module_(module), most_(maximum), unrolled_(unrolled), report_(report) {}

  void run() {
    findLoops();
    if (loops_.empty() && (counted_.empty() || report_ == nullptr)) return;
    const Id number = module_.uintType();
    limit_ = module_.addGlobal(SpvOpVariable,
                               module_.globalOf(SpvOpTypePointer, 0, {SpvStorageClassPrivate, number}),
                               {SpvStorageClassPrivate, module_.uintConstant(most_)});
    giveName(module_, limit_, "simreel_left");
    std::vector<Instruction> body = std::move(module_.body);
    module_.body.clear();
    for (std::size_t i = 0; i < body.size(); ++i) {
      if (report_ != nullptr) at_.follow(module_, report_->files(), body[i]);
      place(body, i);
    }
    module_.index();
  }

 private:
  struct Loop {
    Id counter = 0;  ///< id of the variable that counts the iterations
    std::uint32_t number = 0;
    Position at;
  };

  /// A loop that needs no limit, because it ends after a known number of iterations.
  struct Counted {
    CountedLoop shape;
    Position at;
  };

  /// Collects the loops by the labels of their headers. Collects counted loops by the labels of their merge
  /// blocks, the blocks after the loop.
  void findLoops() {
    const auto counted = countedLoops(module_, most_);
    Id header = 0;
    for (const Instruction& one : module_.body) {
      if (one.op == SpvOpLabel) header = one.result;
      if (one.op != SpvOpLoopMerge || (!unrolled_ && isUnrolled(one))) continue;
      if (const auto found = counted.find(header); found != counted.end()) {
        counted_[one.operands[0]] = {found->second, {}};
        continue;
      }
      loops_[header] = {module_.fresh(), static_cast<std::uint32_t>(loops_.size()), {}};
      loopsByMerge_[one.operands[0]] = header;
    }
  }

  void place(std::vector<Instruction>& body, std::size_t& i) {
    Instruction& one = body[i];
    switch (one.op) {
      case SpvOpFunction:
        function_ = module_.global(one.operands[1])->operands[0];
        declared_ = false;
        break;
      case SpvOpLabel:
        label_ = one.result;
        if (!declared_) return declare(body, i);
        labelsSoFar_.push_back(label_);
        module_.body.push_back(std::move(one));
        return counted_.contains(label_) ? checkCountedEnded() : compare();
      case SpvOpBranch:
        enter(one.operands[0]);
        leave(one.operands[0]);
        break;
      case SpvOpBranchConditional:
        enter(one.operands[1]);
        enter(one.operands[2]);
        if (report_ != nullptr &&
            (loopsByMerge_.contains(one.operands[1]) || loopsByMerge_.contains(one.operands[2])))
          return branch(std::move(one));
        break;
      case SpvOpSwitch:
        for (std::size_t k = 1; k < one.operands.size(); k += 2) enter(one.operands[k]);
        break;
      case SpvOpLoopMerge:
        if (loops_.contains(label_)) return count(body, i);
        if (const auto counted = counted_.find(one.operands[0]); counted != counted_.end())
          counted->second.at = at_;
        break;
      case SpvOpUnreachable:  // This is the merge block of a loop that no break leaves.
        return finish();
      default:
        break;
    }
    module_.body.push_back(std::move(one));
  }

  /// Declares the iteration counters of a function's loops at the function's start.
  void declare(std::vector<Instruction>& body, std::size_t i) {
    declared_ = true;
    labelsSoFar_ = {label_};
    module_.body.push_back(std::move(body[i]));
    const Id pointer = module_.globalOf(SpvOpTypePointer, 0, {SpvStorageClassFunction, module_.uintType()});
    for (std::size_t k = i + 1; k < body.size() && body[k].op != SpvOpFunctionEnd; ++k) {
      if (body[k].op != SpvOpLabel) continue;
      const auto loop = loops_.find(body[k].result);
      if (loop == loops_.end()) continue;
      module_.noteType(loop->second.counter, pointer);
      module_.body.push_back({SpvOpVariable, pointer, loop->second.counter, {SpvStorageClassFunction}});
    }
  }

  /// Resets the iteration counter before a branch that enters a loop from outside. A branch back to a
  /// header is not an entry. It comes after the header.
  void enter(Id target) {
    const auto loop = loops_.find(target);
    if (loop == loops_.end() ||
        std::find(labelsSoFar_.begin(), labelsSoFar_.end(), target) != labelsSoFar_.end())
      return;
    module_.body.push_back({SpvOpStore, 0, 0, {loop->second.counter, module_.uintConstant(0)}});
    note(loop->second, module_.uintConstant(0));
  }

  /// Returns the pointer to the word in private memory that records that a loop has ended. The index is
  /// computed at run time. With a constant index, a driver would keep the word in a register. If the driver
  /// itself ends the loop, none of the branches that set the word run.
  Id word(Writing& writing, const Loop& loop) {
    const Id number = module_.uintType();
    if (endedFlags_ == 0) {
      const Id array = module_.addGlobal(
          SpvOpTypeArray, 0, {number, module_.uintConstant(static_cast<std::uint32_t>(loops_.size()) + 1)});
      endedFlags_ = module_.addGlobal(
          SpvOpVariable, module_.globalOf(SpvOpTypePointer, 0, {SpvStorageClassPrivate, array}),
          {SpvStorageClassPrivate});
      giveName(module_, endedFlags_, "simreel_ended");
    }
    const Id groups =
        writing.load(module_.vectorType(number, 3), builtIn(module_, SpvBuiltInNumWorkgroups));
    const Id some =
        writing.emit(SpvOpULessThan, module_.boolType(),
                     {module_.uintConstant(0), writing.emit(SpvOpCompositeExtract, number, {groups, 0})});
    const Id at =
        writing.emit(SpvOpSelect, number,
                     {some, module_.uintConstant(loop.number), module_.uintConstant(loop.number + 1)});
    return writing.chain(SpvStorageClassPrivate, number, endedFlags_, {at});
  }

  void note(const Loop& loop, Id value) {
    if (report_ == nullptr) return;
    Writing writing(module_, module_.body);
    writing.put(SpvOpStore, {word(writing, loop), value});
  }

  /// Records before a branch to a loop's merge block that the loop has ended.
  void leave(Id target) {
    if (const auto header = loopsByMerge_.find(target); header != loopsByMerge_.end())
      note(loops_[header->second], module_.uintConstant(1));
  }

  /// Inserts a block into the branch that leaves a loop, to record that the loop ends. If the other target
  /// is the loop header, the record is written before the branch instead.
  void branch(Instruction one) {
    Writing writing(module_, module_.body);
    const std::size_t out = loopsByMerge_.contains(one.operands[1]) ? 1 : 2;
    const Id target = one.operands[out], other = one.operands[3 - out];
    if (loops_.contains(other)) {
      const Id yes = module_.uintConstant(1), no = module_.uintConstant(0);
      const Id ends = writing.emit(SpvOpSelect, module_.uintType(),
                                   {one.operands[0], out == 1 ? yes : no, out == 1 ? no : yes});
      note(loops_[loopsByMerge_[target]], ends);
      module_.body.push_back(std::move(one));
      return;
    }
    const SpvOp before = module_.body.back().op;
    if (before != SpvOpSelectionMerge && before != SpvOpLoopMerge)
      writing.put(SpvOpSelectionMerge, {other, SpvSelectionControlMaskNone});
    const Id made = module_.fresh();
    one.operands[out] = made;
    module_.body.push_back(std::move(one));
    writing.label(made);
    leave(target);
    writing.put(SpvOpBranch, {target});
  }

  /// Reports a fault, in the merge block of a loop, if the driver ended the loop.
  void compare() {
    const auto header = loopsByMerge_.find(label_);
    if (report_ == nullptr || header == loopsByMerge_.end()) return;
    const Loop& loop = loops_[header->second];
    Writing writing(module_, module_.body);
    const Id ended = writing.load(module_.uintType(), word(writing, loop));
    const Id fine = writing.emit(SpvOpINotEqual, module_.boolType(), {ended, module_.uintConstant(0)});
    report_->note(module_, module_.body, fine, report_->place("loops", "", loop.at), ended, ended);
  }

  /// Reports a fault, in the merge block of a counted loop, if the loop's condition still holds. In this
  /// case the driver ended the loop.
  void checkCountedEnded() {
    if (report_ == nullptr) return;
    const Counted& loop = counted_[label_];
    Writing writing(module_, module_.body);
    const Id value =
        writing.load(module_.global(module_.typeOf(loop.shape.variable))->operands[1], loop.shape.variable);
    const Id more = writing.emit(loop.shape.compare, module_.boolType(), {value, loop.shape.end});
    const Id fine = writing.emit(SpvOpLogicalNot, module_.boolType(), {more});
    report_->note(module_, module_.body, fine, report_->place("loops", "", loop.at), value, value);
  }

  void count(std::vector<Instruction>& body, std::size_t& i) {
    Instruction merge = std::move(body[i]);
    do ++i;
    while (body[i].op == SpvOpLine || body[i].op == SpvOpNoLine);
    Instruction branch = std::move(body[i]);
    Writing writing(module_, module_.body);
    Loop& loop = loops_[label_];
    loop.at = at_;
    const Id number = module_.uintType();
    const Id done = writing.load(number, loop.counter);
    const Id left = writing.load(number, limit_);
    const Id more = writing.emit(SpvOpULessThan, module_.boolType(), {done, left});
    writing.put(SpvOpStore,
                {limit_, writing.emit(SpvOpSelect, number, {more, left, module_.uintConstant(0)})});
    writing.put(SpvOpStore,
                {loop.counter, writing.emit(SpvOpIAdd, number, {done, module_.uintConstant(1)})});
    if (report_ != nullptr)
      report_->note(module_, module_.body, more, report_->place("loop", "", at_), done, done);
    const Id after = merge.operands[0], inner = module_.fresh();
    module_.body.push_back(std::move(merge));
    if (report_ != nullptr) {
      this->branch({SpvOpBranchConditional, 0, 0, {more, inner, after}});
    } else {
      writing.put(SpvOpBranchConditional, {more, inner, after});
    }
    writing.label(inner);
    module_.body.push_back(std::move(branch));
  }

  void finish() {
    Writing writing(module_, module_.body);
    if (module_.global(function_)->op == SpvOpTypeVoid) return writing.put(SpvOpReturn, {});
    writing.put(SpvOpReturnValue, {module_.globalOf(SpvOpConstantNull, function_, {})});
  }

  Module& module_;
  std::uint32_t most_;
  bool unrolled_;
  Report* report_;
  Position at_;
  std::unordered_map<Id, Loop> loops_;
  std::unordered_map<Id, Id> loopsByMerge_;  ///< headers of loops by the labels of the merge blocks
  std::unordered_map<Id, Counted> counted_;  ///< counted loops by the labels of the merge blocks
  std::vector<Id> labelsSoFar_;              ///< labels of the blocks of the current function so far
  Id endedFlags_ = 0;                        ///< private array of words that record which loops have ended
  Id limit_ = 0;     ///< variable with the current iteration limit; 0 after a loop has reached the limit
  Id function_ = 0;  ///< return type of the current function
  Id label_ = 0;
  bool declared_ = false;
};

}  // namespace

void limitLoops(Module& module, std::uint32_t maximum, bool unrolled, Report* report) {
  Limiting(module, maximum, unrolled, report).run();
}

bool keepsUnrolled(const Module& module) {
  return std::any_of(module.body.begin(), module.body.end(), isUnrolled);
}

}  // namespace simreel::kernels
