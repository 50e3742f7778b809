#include "kernels/guards/shared.hpp"

#include "kernels/guards/words.hpp"
#include "kernels/spirv/writing.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace simreel::kernels {

namespace {

/// Constants for tags. A tag combines the number of barriers so far with the index of an invocation in the
/// workgroup. Each word of shared memory has three tags. One is for the highest invocation that changed the
/// word, and two are for the highest and lowest invocation that read it.
constexpr std::uint32_t tagsOfWord = 3, tagBits = 11, invocationLimit = 1024;

class Shared {
 public:
  Shared(Module& module, Report& report)
      : module_(module), writing_(module, module.body), report_(report), threads_(groupSize(module)) {}

  void run() {
    const std::uint32_t count = threads_[0] * threads_[1] * threads_[2];
    if (count == 1 || count > invocationLimit) return;
    findStored();
    if (tags_.empty()) return;
    const Id number = module_.uintType();
    epoch_ = module_.addGlobal(SpvOpVariable,
                               module_.globalOf(SpvOpTypePointer, 0, {SpvStorageClassPrivate, number}),
                               {SpvStorageClassPrivate, module_.uintConstant(1)});
    giveName(module_, epoch_, "simreel_barriers");
    std::vector<Instruction> body = std::move(module_.body);
    module_.body.clear();
    for (Instruction& one : body) {
      at_.follow(module_, report_.files(), one);
      chains_.follow(one);
      if (one.op == SpvOpLoad) access(one.operands[0], 0);
      if (one.op == SpvOpStore) access(one.operands[0], one.operands[1]);
      const bool barrier = one.op == SpvOpControlBarrier;
      module_.body.push_back(std::move(one));
      if (barrier) {
        const Id next =
            writing_.emit(SpvOpIAdd, number, {writing_.load(number, epoch_), module_.uintConstant(1)});
        writing_.put(SpvOpStore, {epoch_, next});
      }
    }
    for (const auto& [key, function] : functions_)
      key.second ? writeStored(key.first, function) : writeRead(key.first, function);
    writeClear(count);
    module_.index();
  }

 private:
  struct Tags {
    Id variable = 0;
    std::uint32_t length = 0;
  };

  /// Allocates tags for each variable that is stored to, while shared memory is left.
  void findStored() {
    constexpr std::uint32_t maximum = 32768 / 4;
    std::uint32_t words = 0;
    WordsIn sizes(module_, true);
    const std::vector<Instruction> globals = module_.globals;
    const auto pointee = [&](const Instruction& one) { return module_.global(one.type)->operands[1]; };
    const auto isShared = [](const Instruction& one) {
      return one.op == SpvOpVariable && one.operands[0] == SpvStorageClassWorkgroup;
    };
    for (const Instruction& one : globals)
      if (isShared(one)) words += sizes.size(pointee(one));
    std::map<Id, bool> stored;
    for (const Instruction& one : module_.body) {
      chains_.follow(one);
      if (one.op == SpvOpStore) stored[chains_.of(one.operands[0]).variable] = true;
    }
    for (const Instruction& one : globals) {
      const std::uint32_t length = isShared(one) ? tagsOfWord * sizes.size(pointee(one)) : 0;
      if (length == 0 || !stored[one.result] || words + length > maximum) continue;
      words += length;
      const Id array =
          module_.addGlobal(SpvOpTypeArray, 0, {module_.uintType(), module_.uintConstant(length)});
      const Id pointer = module_.globalOf(SpvOpTypePointer, 0, {SpvStorageClassWorkgroup, array});
      const Id made = module_.addGlobal(SpvOpVariable, pointer, {SpvStorageClassWorkgroup});
      giveName(module_, made, fmt::format("simreel_tags_{}", tags_.size()));
      tags_[one.result] = {made, length};
    }
  }

  /// Inserts the check before a load, or before a store of `value`.
  void access(Id pointer, Id value) {
    const PointerChain chain = chains_.of(pointer);
    if (!tags_.contains(chain.variable)) return;
    WordsIn words(module_, true);
    const WordsIn::Access access = words.access(writing_, chain);
    const bool stores = value != 0;
    const Id place = module_.uintConstant(
        report_.place(stores ? "race-write" : "race-read", access.what, at_, access.part));
    Words before, after;
    if (stores) {
      words.parts(writing_, writing_.load(access.type, pointer), access.type, before);
      words.parts(writing_, value, access.type, after);
    }
    Id& function = functions_[{chain.variable, stores}];
    if (function == 0) function = module_.fresh();
    const std::vector<std::uint32_t> offsets = words.offsets(access);
    for (std::size_t i = 0; i < offsets.size(); ++i) {
      const Id word =
          writing_.emit(SpvOpIAdd, module_.uintType(), {access.first, module_.uintConstant(offsets[i])});
      Words operands = {function, word, place, access.element};
      if (stores)
        operands.push_back(writing_.emit(SpvOpINotEqual, module_.boolType(), {before[i], after[i]}));
      writing_.emit(SpvOpFunctionCall, module_.globalOf(SpvOpTypeVoid, 0, {}), operands);
    }
  }

  /// Emits an atomic max of a tag with `value`. With value 0, only reads the tag.
  Id raise(Id variable, Id word, std::uint32_t at, Id value) {
    const Id number = module_.uintType();
    const Id first = writing_.emit(SpvOpIMul, number, {word, module_.uintConstant(tagsOfWord)});
    const Id index = writing_.emit(SpvOpIAdd, number, {first, module_.uintConstant(at)});
    const Id pointer = writing_.chain(SpvStorageClassWorkgroup, number, tags_[variable].variable, {index});
    return writing_.emit(
        SpvOpAtomicUMax, number,
        {pointer, module_.uintConstant(SpvScopeWorkgroup), module_.uintConstant(0), value});
  }

  Id binary(SpvOp op, Id a, Id b) { return writing_.emit(op, module_.uintType(), {a, b}); }
  Id compare(SpvOp op, Id a, Id b) { return writing_.emit(op, module_.boolType(), {a, b}); }
  Id number(std::uint32_t value) { return module_.uintConstant(value); }

  /// Emits this invocation's index in the workgroup, and its tags.
  void begin() {
    local_ = writing_.load(module_.uintType(), builtIn(module_, SpvBuiltInLocalInvocationIndex, 1));
    now_ = writing_.load(module_.uintType(), epoch_);
    const Id begun = binary(SpvOpShiftLeftLogical, now_, number(tagBits));
    high_ = binary(SpvOpBitwiseOr, begun, binary(SpvOpIAdd, local_, number(1)));
    low_ = binary(SpvOpBitwiseOr, begun, binary(SpvOpISub, number(invocationLimit), local_));
  }

  /// Emits code that decodes a tag. Returns the ids of two values: the index of the tag's invocation, and a
  /// bool that is true if that is not this invocation and it accessed the word since the last barrier.
  /// `low`: the tag keeps the lowest invocation, not the highest.
  std::pair<Id, Id> other(Id tag, bool low) {
    const Id kept = binary(SpvOpBitwiseAnd, tag, number((1U << tagBits) - 1));
    const Id invocation =
        low ? binary(SpvOpISub, number(invocationLimit), kept) : binary(SpvOpISub, kept, number(1));
    const Id since = compare(SpvOpIEqual, binary(SpvOpShiftRightLogical, tag, number(tagBits)), now_);
    return {invocation, compare(SpvOpLogicalAnd, since, compare(SpvOpINotEqual, invocation, local_))};
  }

  void note(Id foreign, Id place, Id invocation, Id element) {
    const Id fine = writing_.emit(SpvOpLogicalNot, module_.boolType(), {foreign});
    report_.noteAt(module_, module_.body, fine, place, linearInvocation(module_, module_.body, invocation),
                   element);
  }

  void writeRead(Id variable, Id function) {
    const Words given =
        writing_.function(function, {module_.uintType(), module_.uintType(), module_.intType()});
    giveName(module_, function, "simreel_read_shared");
    begin();
    raise(variable, given[0], 1, high_);
    raise(variable, given[0], 2, low_);
    const auto [invocation, foreign] = other(raise(variable, given[0], 0, number(0)), false);
    note(foreign, given[1], invocation, given[2]);
    writing_.end();
  }

  void writeStored(Id variable, Id function) {
    const Words given = writing_.function(
        function, {module_.uintType(), module_.uintType(), module_.intType(), module_.boolType()});
    giveName(module_, function, "simreel_store_shared");
    const Id merge = writing_.open(given[3]);
    begin();
    raise(variable, given[0], 0, high_);
    const auto [highest, above] = other(raise(variable, given[0], 1, number(0)), false);
    const auto [lowest, below] = other(raise(variable, given[0], 2, number(0)), true);
    const Id invocation = writing_.select(below, module_.uintType(), lowest, highest);
    note(compare(SpvOpLogicalOr, above, below), given[1], invocation, given[2]);
    writing_.close(merge);
    writing_.end();
  }

  /// Emits the function that sets all tags to 0 before the kernel starts.
  void writeClear(std::uint32_t count) {
    const Id function = module_.fresh(), type = module_.uintType();
    writing_.function(function, {});
    giveName(module_, function, "simreel_clear");
    const Id counter =
        writing_.emit(SpvOpVariable, module_.globalOf(SpvOpTypePointer, 0, {SpvStorageClassFunction, type}),
                      {SpvStorageClassFunction});
    const Id local = writing_.load(type, builtIn(module_, SpvBuiltInLocalInvocationIndex, 1));
    for (const auto& one : tags_) {
      writing_.put(SpvOpStore, {counter, local});
      const Id header = module_.fresh(), test = module_.fresh(), inner = module_.fresh(),
               go = module_.fresh(), after = module_.fresh();
      writing_.put(SpvOpBranch, {header});
      writing_.label(header);
      writing_.put(SpvOpLoopMerge, {after, go, SpvLoopControlMaskNone});
      writing_.put(SpvOpBranch, {test});
      writing_.label(test);
      const Id at = writing_.load(type, counter);
      const Id more = compare(SpvOpULessThan, at, number(one.second.length));
      writing_.put(SpvOpBranchConditional, {more, inner, after});
      writing_.label(inner);
      const Id tag = writing_.chain(SpvStorageClassWorkgroup, type, one.second.variable, {at});
      writing_.put(SpvOpStore, {tag, number(0)});
      writing_.put(SpvOpBranch, {go});
      writing_.label(go);
      writing_.put(SpvOpStore, {counter, binary(SpvOpIAdd, at, number(count))});
      writing_.put(SpvOpBranch, {header});
      writing_.label(after);
    }
    writing_.put(SpvOpControlBarrier,
                 {number(SpvScopeWorkgroup), number(SpvScopeWorkgroup),
                  number(SpvMemorySemanticsAcquireReleaseMask | SpvMemorySemanticsWorkgroupMemoryMask)});
    writing_.end();
    report_.beginWith(function);
  }

  Module& module_;
  Writing writing_;
  Report& report_;
  std::array<std::uint32_t, 3> threads_;
  Position at_;
  Chains chains_;
  std::map<Id, Tags> tags_;                      ///< tags by variable
  std::map<std::pair<Id, bool>, Id> functions_;  ///< functions by variable and type of access (true: store,
                                                 ///< false: load)
  Id epoch_ = 0;                                 ///< id of the variable with the number of barriers so far
  Id local_ = 0, now_ = 0, high_ = 0, low_ = 0;
};

}  // namespace

void checkShared(Module& module, Report& report) {
  Shared(module, report).run();
}

}  // namespace simreel::kernels
