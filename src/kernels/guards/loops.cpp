#include "kernels/guards/loops.hpp"

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
  Limiting(Module& module, std::uint32_t most, bool unrolled, Report* report)
      : module_(module), most_(most), unrolled_(unrolled), report_(report) {}

  void run() {
    findLoops();
    if (counters_.empty()) return;
    const Id number = module_.uintType();
    left_ = module_.addGlobal(SpvOpVariable,
                              module_.globalOf(SpvOpTypePointer, 0, {SpvStorageClassPrivate, number}),
                              {SpvStorageClassPrivate, module_.uintConstant(most_)});
    giveName(module_, left_, "simreel_left");
    std::vector<Instruction> body = std::move(module_.body);
    module_.body.clear();
    for (std::size_t i = 0; i < body.size(); ++i) {
      if (report_ != nullptr) at_.follow(module_, report_->files(), body[i]);
      place(body, i);
    }
    module_.index();
  }

 private:
  /// Assigns an iteration counter to each loop, by the label of its header.
  void findLoops() {
    Id header = 0;
    for (const Instruction& one : module_.body) {
      if (one.op == SpvOpLabel) header = one.result;
      if (one.op == SpvOpLoopMerge && (unrolled_ || !isUnrolled(one))) counters_[header] = module_.fresh();
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
        begun_.push_back(label_);
        break;
      case SpvOpBranch:
        begin(one.operands[0]);
        break;
      case SpvOpBranchConditional:
        begin(one.operands[1]);
        begin(one.operands[2]);
        break;
      case SpvOpSwitch:
        for (std::size_t k = 1; k < one.operands.size(); k += 2) begin(one.operands[k]);
        break;
      case SpvOpLoopMerge:
        if (counters_.contains(label_)) return count(body, i);
        break;
      case SpvOpUnreachable:  // code after a loop without a break
        return leave();
      default:
        break;
    }
    module_.body.push_back(std::move(one));
  }

  /// Declares the counters of a function's loops at its start.
  void declare(std::vector<Instruction>& body, std::size_t i) {
    declared_ = true;
    begun_ = {label_};
    module_.body.push_back(std::move(body[i]));
    const Id pointer = module_.globalOf(SpvOpTypePointer, 0, {SpvStorageClassFunction, module_.uintType()});
    for (std::size_t k = i + 1; k < body.size() && body[k].op != SpvOpFunctionEnd; ++k) {
      if (body[k].op != SpvOpLabel) continue;
      const auto counter = counters_.find(body[k].result);
      if (counter == counters_.end()) continue;
      module_.noteType(counter->second, pointer);
      module_.body.push_back({SpvOpVariable, pointer, counter->second, {SpvStorageClassFunction}});
    }
  }

  /// Resets the counter at a branch into a loop. A branch to a header that appears later enters the loop; a
  /// branch to an earlier header is the back edge.
  void begin(Id target) {
    const auto counter = counters_.find(target);
    if (counter == counters_.end() || std::find(begun_.begin(), begun_.end(), target) != begun_.end())
      return;
    module_.body.push_back({SpvOpStore, 0, 0, {counter->second, module_.uintConstant(0)}});
  }

  void count(std::vector<Instruction>& body, std::size_t& i) {
    Instruction merge = std::move(body[i]);
    do ++i;
    while (body[i].op == SpvOpLine || body[i].op == SpvOpNoLine);
    Instruction branch = std::move(body[i]);
    Writing writing(module_, module_.body);
    const Id counter = counters_[label_], number = module_.uintType();
    const Id done = writing.load(number, counter);
    const Id left = writing.load(number, left_);
    const Id more = writing.emit(SpvOpULessThan, module_.boolType(), {done, left});
    writing.put(SpvOpStore,
                {left_, writing.emit(SpvOpSelect, number, {more, left, module_.uintConstant(0)})});
    writing.put(SpvOpStore, {counter, writing.emit(SpvOpIAdd, number, {done, module_.uintConstant(1)})});
    if (report_ != nullptr)
      report_->note(module_, module_.body, more, report_->place("loop", "", at_), done, done);
    const Id after = merge.operands[0], inner = module_.fresh();
    module_.body.push_back(std::move(merge));
    writing.put(SpvOpBranchConditional, {more, inner, after});
    writing.label(inner);
    module_.body.push_back(std::move(branch));
  }

  void leave() {
    Writing writing(module_, module_.body);
    if (module_.global(function_)->op == SpvOpTypeVoid) return writing.put(SpvOpReturn, {});
    writing.put(SpvOpReturnValue, {module_.globalOf(SpvOpConstantNull, function_, {})});
  }

  Module& module_;
  std::uint32_t most_;
  bool unrolled_;
  Report* report_;
  Position at_;
  std::unordered_map<Id, Id> counters_;
  std::vector<Id> begun_;  ///< labels of this function emitted so far
  Id left_ = 0;  ///< variable with the current iteration limit of all loops: `most`, or 0 after a loop has
                 ///< reached it
  Id function_ = 0;  ///< return type of the function
  Id label_ = 0;
  bool declared_ = false;
};

}  // namespace

void limitLoops(Module& module, std::uint32_t most, bool unrolled, Report* report) {
  Limiting(module, most, unrolled, report).run();
}

bool keepsUnrolled(const Module& module) {
  return std::any_of(module.body.begin(), module.body.end(), isUnrolled);
}

}  // namespace simreel::kernels
