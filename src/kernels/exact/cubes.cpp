#include "kernels/exact/cubes.hpp"

#include <unordered_map>
#include <utility>
#include <vector>

namespace simreel::kernels {

namespace {

/// The cube map types of a module, with and without a sampler, and the variables of these types.
struct Cubes {
  std::set<Id> types, variables;
};

Cubes cubesOf(const Module& module) {
  Cubes found;
  std::set<Id> pointers;
  for (const Instruction& one : module.globals) {
    const bool cube = one.op == SpvOpTypeImage && one.operands[1] == SpvDimCube && one.operands[2] != 1 &&
                      one.operands[3] == 0 && one.operands[5] == 1 &&
                      module.signature(one.operands[0]) == "f1";
    if (cube || (one.op == SpvOpTypeSampledImage && found.types.contains(one.operands[0])))
      found.types.insert(one.result);
    if (one.op == SpvOpTypePointer && found.types.contains(one.operands[1])) pointers.insert(one.result);
    if (one.op == SpvOpVariable && pointers.contains(one.type)) found.variables.insert(one.result);
  }
  return found;
}

bool isSize(SpvOp op) {
  return op == SpvOpImageQuerySizeLod || op == SpvOpImageQuerySize;
}

/// Returns true if the cube maps are global variables and all their uses can be replaced.
bool replaceable(const Module& module, const Cubes& cubes) {
  std::set<Id> values;
  for (const Instruction& one : module.body) {
    if (one.op == SpvOpLoad && cubes.variables.contains(one.operands[0])) values.insert(one.result);
    if ((one.op == SpvOpSampledImage || one.op == SpvOpImage) && values.contains(one.operands[0]))
      values.insert(one.result);
    if (one.op == SpvOpFunctionParameter && cubes.types.contains(module.typeOf(one.result))) return false;
    const bool known = one.op == SpvOpSampledImage || one.op == SpvOpImage || isSize(one.op) ||
                       one.op == SpvOpImageQueryLevels || one.op == SpvOpLoad ||
                       (one.op == SpvOpImageSampleExplicitLod && one.operands.size() == 4 &&
                        one.operands[2] == SpvImageOperandsLodMask);
    for (std::size_t i = 0; i < one.operands.size(); ++i) {
      if (!isId(one, i)) continue;
      const Id id = one.operands[i];
      if (cubes.variables.contains(id) && one.op != SpvOpLoad) return false;
      if (values.contains(id) && (!known || i != 0)) return false;
    }
  }
  return true;
}

}  // namespace

std::set<Id> flattenCubes(Module& module) {
  const Cubes cubes = cubesOf(module);
  if (cubes.variables.empty() || !replaceable(module, cubes)) return {};
  std::vector<Instruction> body = std::move(module.body);
  module.body.clear();
  for (Instruction& one : body) {
    if (!isSize(one.op) || !cubes.types.contains(module.typeOf(one.operands[0]))) {
      module.body.push_back(std::move(one));
      continue;
    }
    const Id flat = one.type, result = one.result;
    one.type = module.vectorType(module.global(flat)->operands[0], 3);
    one.result = module.fresh();
    module.noteType(one.result, one.type);
    const Id made = one.result;
    module.body.push_back(std::move(one));
    module.body.push_back({SpvOpVectorShuffle, flat, result, {made, made, 0, 1}});
  }
  for (Instruction& one : module.globals)
    if (one.op == SpvOpTypeImage && cubes.types.contains(one.result)) {
      one.operands[1] = SpvDim2D;
      one.operands[3] = 1;
    }
  module.index();
  return cubes.variables;
}

}  // namespace simreel::kernels
