#include "kernels/guards/report.hpp"

#include "kernels/spirv/writing.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace simreel::kernels {

namespace {

constexpr const char* noteName = "simreel_note";

Id placeType(Module& module) {
  const Id made = module.addGlobal(
      SpvOpTypeStruct, 0, {module.uintType(), module.uintType(), module.intType(), module.intType()});
  static constexpr const char* names[] = {"count", "invocation", "least", "greatest"};
  for (std::uint32_t i = 0; i < std::size(names); ++i) {
    module.decorations.push_back({SpvOpMemberDecorate, 0, 0, {made, i, SpvDecorationOffset, 4 * i}});
    giveMemberName(module, made, i, names[i]);
  }
  giveName(module, made, "simreel_Place");
  return made;
}

/// Returns the variable of the report block. Creates the variable if it does not exist.
Id blockVariable(Module& module) {
  for (const Instruction& one : module.globals)
    if (one.op == SpvOpVariable && one.operands[0] == SpvStorageClassStorageBuffer &&
        module.name(module.global(one.type)->operands[1]) == reportBlock)
      return one.result;
  return storageBuffer(module, reportBlock, "places", placeType(module), 16);
}

Words noteParameters(Module& module) {
  return {module.boolType(), module.uintType(), module.intType(), module.intType()};
}

void dropFunction(Module& module, Id function) {
  const auto begin = std::find_if(module.body.begin(), module.body.end(), [&](const Instruction& one) {
    return one.op == SpvOpFunction && one.result == function;
  });
  if (begin == module.body.end()) return;
  const auto end = std::find_if(begin, module.body.end(),
                                [](const Instruction& one) { return one.op == SpvOpFunctionEnd; });
  module.body.erase(begin, end + 1);
}

}  // namespace

std::uint32_t Report::place(const char* kind, const std::string& what, const Position& at,
                            const std::string& part) {
  const Place made{kind, what, part, files_.name(at.file), at.line};
  const auto found = std::find(places_.begin(), places_.end(), made);
  if (found != places_.end()) return static_cast<std::uint32_t>(found - places_.begin());
  places_.push_back(made);
  return static_cast<std::uint32_t>(places_.size() - 1);
}

/// Returns the id of the note function. Until complete(), its body is a placeholder that SPIRV-Tools cannot
/// drop, move or inline.
Id Report::function(Module& module) {
  if (known_ == &module) return function_;
  known_ = &module;
  function_ = 0;
  for (const Instruction& one : module.head)
    if (one.op == SpvOpName && literalText(std::span(one.operands).subspan(1)) == noteName)
      function_ = one.operands[0];
  return function_ = function_ == 0 ? module.fresh() : function_;
}

bool Report::excuse(Id made) {
  const auto found = made == 0 ? excuses_.end() : excuses_.find(made);
  excuse_ = found == excuses_.end() ? nullptr : &found->second;
  return excuse_ != nullptr;
}

void Report::note(Module& module, std::vector<Instruction>& body, Id fine, std::uint32_t place, Id minimum,
                  Id greatest) {
  noteAt(module, body, fine, module.uintConstant(place), minimum, greatest);
}

void Report::noteAt(Module& module, std::vector<Instruction>& body, Id fine, Id place, Id minimum,
                    Id greatest) {
  Writing writing(module, body);
  if (excuse_ != nullptr)
    for (const auto& [condition, needed] : *excuse_) {
      const Id unneeded =
          needed ? writing.emit(SpvOpLogicalNot, module.boolType(), {condition}) : condition;
      fine = writing.emit(SpvOpLogicalOr, module.boolType(), {fine, unneeded});
    }
  const Id a = writing.asInt(minimum), b = minimum == greatest ? a : writing.asInt(greatest);
  writing.emit(SpvOpFunctionCall, module.globalOf(SpvOpTypeVoid, 0, {}),
               {function(module), fine, place, a, b});
}

void Report::hold(Module& module) {
  if (known_ != &module) return;
  const Id block = blockVariable(module), number = module.intType();
  Writing writing(module, module.body);
  const Words given = writing.function(function(module), noteParameters(module));
  const Id zero = module.globalOf(SpvOpConstant, number, {0});
  const Id value = writing.emit(SpvOpSelect, number, {given[0], zero, given[2]});
  const Id sum = writing.emit(SpvOpIAdd, number, {value, given[3]});
  const Id at = writing.chain(SpvStorageClassStorageBuffer, number, block,
                              {module.uintConstant(0), given[1], module.uintConstant(3)});
  writing.put(SpvOpStore, {at, sum});
  writing.end();
  giveName(module, function_, noteName);
  module.index();
  known_ = nullptr;
}

void Report::writeNote(Module& module, Id function, const Words& kept) {
  dropFunction(module, function);
  Writing writing(module, module.body);
  const Words given = writing.function(function, noteParameters(module));
  const Id already = writing.load(module.uintType(), kept[0]);
  const Id first = writing.emit(SpvOpIEqual, module.boolType(), {already, module.uintConstant(0)});
  const Id wrong = writing.emit(SpvOpLogicalNot, module.boolType(), {given[0]});
  const Id merge = writing.open(writing.emit(SpvOpLogicalAnd, module.boolType(), {first, wrong}));
  const Id number = writing.emit(SpvOpIAdd, module.uintType(), {given[1], module.uintConstant(1)});
  writing.put(SpvOpStore, {kept[0], number});
  writing.put(SpvOpStore, {kept[1], given[2]});
  writing.put(SpvOpStore, {kept[2], given[3]});
  writing.close(merge);
  writing.end();
  giveName(module, function, noteName);
}

namespace {

Id linear(Module& module, Writing& writing, const std::array<Id, 3>& at) {
  const Id number = module.uintType(), three = module.vectorType(number, 3);
  const Id groups = writing.load(three, builtIn(module, SpvBuiltInNumWorkgroups));
  Id sum = at[2];
  for (std::uint32_t i = 2; i-- > 0;) {
    const Id count = writing.emit(SpvOpCompositeExtract, number, {groups, i});
    const Id width = writing.emit(SpvOpIMul, number, {count, module.uintConstant(groupSize(module)[i])});
    sum = writing.emit(SpvOpIAdd, number, {writing.emit(SpvOpIMul, number, {sum, width}), at[i]});
  }
  return sum;
}

}  // namespace

Id linearInvocation(Module& module, std::vector<Instruction>& body) {
  Writing writing(module, body);
  const Id number = module.uintType(), three = module.vectorType(number, 3);
  const Id at = writing.load(three, builtIn(module, SpvBuiltInGlobalInvocationId));
  std::array<Id, 3> parts{};
  for (std::uint32_t i = 0; i < 3; ++i) parts[i] = writing.emit(SpvOpCompositeExtract, number, {at, i});
  return linear(module, writing, parts);
}

Id linearInvocation(Module& module, std::vector<Instruction>& body, Id local) {
  Writing writing(module, body);
  const Id number = module.uintType(), three = module.vectorType(number, 3);
  const Id group = writing.load(three, builtIn(module, SpvBuiltInWorkgroupId));
  std::array<Id, 3> parts{};
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Id threads = module.uintConstant(groupSize(module)[i]);
    const Id before =
        writing.emit(SpvOpIMul, number, {writing.emit(SpvOpCompositeExtract, number, {group, i}), threads});
    const Id own = i == 2 ? local : writing.emit(SpvOpUMod, number, {local, threads});
    parts[i] = writing.emit(SpvOpIAdd, number, {before, own});
    if (i < 2) local = writing.emit(SpvOpUDiv, number, {local, threads});
  }
  return linear(module, writing, parts);
}

/// Emits the function that adds this invocation's fault to the report block. If the highest bit of a
/// place's first word is set, only the invocation in word 1 of the place is recorded. The runtime uses this
/// to get the indices of that invocation.
void Report::writeAddFault(Module& module, Id function, const Words& kept) {
  const Id block = blockVariable(module), number = module.uintType(), flag = module.boolType();
  Writing writing(module, module.body);
  writing.function(function, {});
  const Id fault = writing.load(number, kept[0]);
  const Id merge = writing.open(writing.emit(SpvOpINotEqual, flag, {fault, module.uintConstant(0)}));
  const Id place = writing.emit(SpvOpISub, number, {fault, module.uintConstant(1)});
  const auto word = [&](std::uint32_t member, Id type) {
    return writing.chain(SpvStorageClassStorageBuffer, type, block,
                         {module.uintConstant(0), place, module.uintConstant(member)});
  };
  const Id linear = linearInvocation(module, module.body);
  const Id whole = module.intType(), device = module.uintConstant(SpvScopeDevice),
           relaxed = module.uintConstant(0);
  const Id count = writing.load(number, word(0, number)), lowest = writing.load(number, word(1, number));
  const Id all = writing.emit(SpvOpULessThan, flag, {count, module.uintConstant(0x80000000U)});
  const Id own = writing.emit(SpvOpIEqual, flag, {lowest, linear});
  const Id inner = writing.open(writing.emit(SpvOpLogicalOr, flag, {all, own}));
  const auto atomic = [&](SpvOp op, std::uint32_t member, Id type, Id value) {
    writing.emit(op, type, {word(member, type), device, relaxed, value});
  };
  atomic(SpvOpAtomicIAdd, 0, number, module.uintConstant(1));
  atomic(SpvOpAtomicUMin, 1, number, linear);
  atomic(SpvOpAtomicSMin, 2, whole, writing.load(whole, kept[1]));
  atomic(SpvOpAtomicSMax, 3, whole, writing.load(whole, kept[2]));
  writing.close(inner);
  writing.close(merge);
  writing.end();
  giveName(module, function, "simreel_tell");
}

/// Creates a new entry point that calls the kernel as a function.
void Report::enter(Module& module, Id tell) const {
  const Id made = module.fresh(), nothing = module.globalOf(SpvOpTypeVoid, 0, {});
  Id kernel = 0;
  for (Instruction& one : module.head)
    if (one.op == SpvOpEntryPoint) kernel = std::exchange(one.operands[1], made);
  for (Instruction& one : module.head)
    if (one.op == SpvOpExecutionMode && one.operands[0] == kernel) one.operands[0] = made;
  giveName(module, kernel, "simreel_kernel");
  Writing writing(module, module.body);
  writing.function(made, {});
  if (begin_ != 0) writing.emit(SpvOpFunctionCall, nothing, {begin_});
  writing.emit(SpvOpFunctionCall, nothing, {kernel});
  writing.emit(SpvOpFunctionCall, nothing, {tell});
  writing.end();
}

void Report::complete(Module& module) {
  if (places_.empty()) return;
  const Id note = function(module);
  Words kept;
  for (const char* name : {"simreel_fault", "simreel_least", "simreel_greatest"}) {
    const Id type = kept.empty() ? module.uintType() : module.intType();
    const Id pointer = module.globalOf(SpvOpTypePointer, 0, {SpvStorageClassPrivate, type});
    const Id zero = module.globalOf(SpvOpConstant, type, {0});
    kept.push_back(module.addGlobal(SpvOpVariable, pointer, {SpvStorageClassPrivate, zero}));
    giveName(module, kept.back(), name);
  }
  const Id tell = module.fresh();
  writeNote(module, note, kept);
  writeAddFault(module, tell, kept);
  enter(module, tell);
  module.index();
}

}  // namespace simreel::kernels
