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
    case SpvStorageClassUniform:  // Before SPIR-V 1.3, storage buffers use this storage class with the
                                  // decoration BufferBlock.
      return module.decoration(type.result, SpvDecorationBufferBlock) ? Resource::storage : Resource::block;
    case SpvStorageClassUniformConstant:
      if (type.op == SpvOpTypeSampler) return Resource::sampler;
      return type.op == SpvOpTypeImage && type.operands[5] == 2 ? Resource::image : Resource::texture;
    default:
      return Resource::none;
  }
}

bool isArrayed(const Module& module, const Instruction& variable) {
  return resourceType(module, variable).result != module.global(variable.type)->operands[1];
}

std::string blockName(const Module& module, Id variable, bool hlsl) {
  const Id type = resourceType(module, *module.global(variable)).result;
  const std::string name = module.name(hlsl ? variable : type);
  return name.empty() ? module.name(hlsl ? type : variable) : name;
}

std::string bufferName(const Module& module, Id variable, bool hlsl) {
  return plainName(blockName(module, variable, hlsl));
}

std::string plainName(const std::string& name) {
  const std::size_t at = name.find('@');
  return at == 0 ? name.substr(1) : name.substr(0, at);
}

}  // namespace simreel::kernels
