#include "kernels/spirv/resource.hpp"

namespace simreel::kernels {

const Instruction& resourceType(const Module& module, const Instruction& variable) {
  const Instruction* type = module.global(module.global(variable.type)->operands[1]);
  while (type->op == SpvOpTypeArray || type->op == SpvOpTypeRuntimeArray)
    type = module.global(type->operands[0]);
  return *type;
}

Resource resourceOf(const Module& module, const Instruction& variable) {
  if (variable.op != SpvOpVariable) return Resource::none;
  const Instruction& type = resourceType(module, variable);
  switch (variable.operands[0]) {
    case SpvStorageClassStorageBuffer:
      return Resource::storage;
    case SpvStorageClassUniform:  // until SPIR-V 1.3 storage buffers are blocks of their own kind
      return module.decoration(type.result, SpvDecorationBufferBlock) ? Resource::storage : Resource::block;
    case SpvStorageClassUniformConstant:
      if (type.op == SpvOpTypeSampler) return Resource::sampler;
      return type.op == SpvOpTypeImage && type.operands[5] == 2 ? Resource::image : Resource::texture;
    default:
      return Resource::none;
  }
}

}  // namespace simreel::kernels
