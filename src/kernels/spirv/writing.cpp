#include "kernels/spirv/writing.hpp"

namespace simreel::kernels {

Words Writing::function(Id id, const Words& parameterTypes) {
  const Id nothing = module_.globalOf(SpvOpTypeVoid, 0, {});
  Words types = {nothing};
  types.insert(types.end(), parameterTypes.begin(), parameterTypes.end());
  const Id type = module_.globalOf(SpvOpTypeFunction, 0, types);
  to_.push_back({SpvOpFunction, nothing, id, {SpvFunctionControlDontInlineMask, type}});
  Words parameters;
  for (const Id one : parameterTypes) parameters.push_back(emit(SpvOpFunctionParameter, one, {}));
  label(module_.fresh());
  return parameters;
}

Id Writing::select(Id condition, Id type, Id a, Id b, Id result) {
  if (const Instruction made = *module_.global(type); made.op == SpvOpTypeVector)
    condition = emit(SpvOpCompositeConstruct, module_.vectorType(module_.boolType(), made.operands[1]),
                     Words(made.operands[1], condition));
  if (result == 0) return emit(SpvOpSelect, type, {condition, a, b});
  to_.push_back({SpvOpSelect, type, result, {condition, a, b}});
  return result;
}

Id Writing::chain(SpvStorageClass storage, Id type, Id base, const Words& indices) {
  Words operands = {base};
  operands.insert(operands.end(), indices.begin(), indices.end());
  return emit(SpvOpAccessChain,
              module_.globalOf(SpvOpTypePointer, 0, {static_cast<std::uint32_t>(storage), type}), operands);
}

namespace {

void named(Module& module, SpvOp op, Words operands, const std::string& text) {
  const Words words = textWords(text);
  operands.insert(operands.end(), words.begin(), words.end());
  module.head.push_back({op, 0, 0, std::move(operands)});
}

}  // namespace

void giveName(Module& module, Id id, const std::string& name) {
  std::erase_if(module.head,
                [&](const Instruction& one) { return one.op == SpvOpName && one.operands[0] == id; });
  named(module, SpvOpName, {id}, name);
}

void giveMemberName(Module& module, Id type, std::uint32_t member, const std::string& name) {
  named(module, SpvOpMemberName, {type, member}, name);
}

std::array<std::uint32_t, 3> groupSize(const Module& module) {
  std::array<std::uint32_t, 3> threads = {1, 1, 1};
  for (const Instruction& one : module.head)
    if (one.op == SpvOpExecutionMode && one.operands[1] == SpvExecutionModeLocalSize)
      for (std::size_t i = 0; i < 3; ++i) threads[i] = one.operands[2 + i];
  return threads;
}

Id builtIn(Module& module, SpvBuiltIn what, std::uint32_t length) {
  const Id vector = module.vectorType(module.uintType(), length);
  const Id pointer = module.globalOf(SpvOpTypePointer, 0, {SpvStorageClassInput, vector});
  for (const Instruction& one : module.globals)
    if (one.op == SpvOpVariable && one.type == pointer &&
        module.decoration(one.result, SpvDecorationBuiltIn) == static_cast<std::uint32_t>(what))
      return one.result;
  const Id made = module.addGlobal(SpvOpVariable, pointer, {SpvStorageClassInput});
  module.decorate(made, SpvDecorationBuiltIn, {static_cast<std::uint32_t>(what)});
  for (Instruction& one : module.head)
    if (one.op == SpvOpEntryPoint) one.operands.push_back(made);
  return made;
}

Id storageBuffer(Module& module, const std::string& name, const std::string& member, Id element,
                 std::uint32_t stride) {
  const Id array = module.addGlobal(SpvOpTypeRuntimeArray, 0, {element});
  const Id block = module.addGlobal(SpvOpTypeStruct, 0, {array});
  const Id pointer = module.globalOf(SpvOpTypePointer, 0, {SpvStorageClassStorageBuffer, block});
  const Id variable = module.addGlobal(SpvOpVariable, pointer, {SpvStorageClassStorageBuffer});
  module.decorate(array, SpvDecorationArrayStride, {stride});
  module.decorate(block, SpvDecorationBlock);
  module.decorations.push_back({SpvOpMemberDecorate, 0, 0, {block, 0, SpvDecorationOffset, 0}});
  giveName(module, block, name);
  giveMemberName(module, block, 0, member);
  return variable;
}

}  // namespace simreel::kernels
