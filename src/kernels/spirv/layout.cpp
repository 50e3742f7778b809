#include "kernels/spirv/layout.hpp"

#include "kernels/spirv/resource.hpp"

#include <algorithm>
#include <set>

namespace simreel::kernels {

namespace {

struct Size {
  std::uint32_t bytes = 4, alignment = 4;
};

std::uint32_t up(std::uint32_t value, std::uint32_t to) {
  return (value + to - 1) / to * to;
}

/// Adds offsets and strides to a struct and its nested types, following std430 or std140. In std140 structs
/// and array elements are aligned to 16 bytes.
class Layout {
 public:
  Layout(Module& module, bool std140) : module_(module), least_(std140 ? 16 : 1) {}

  Size size(Id type) {
    const Instruction made = *module_.global(type);
    switch (made.op) {
      case SpvOpTypeVector: {
        const std::uint32_t n = made.operands[1], component = size(made.operands[0]).bytes;
        return {component * n, component * (n == 2 ? 2 : 4)};
      }
      case SpvOpTypeFloat:
      case SpvOpTypeInt:
        return {made.operands[0] / 8, made.operands[0] / 8};
      case SpvOpTypeRuntimeArray:
      case SpvOpTypeArray: {
        const Size element = size(made.operands[0]);
        const std::uint32_t alignment = std::max(element.alignment, least_);
        const std::uint32_t stride = up(element.bytes, alignment);
        set(SpvOpDecorate, {type, SpvDecorationArrayStride}, stride);
        const std::uint32_t length =
            made.op == SpvOpTypeArray ? module_.constant(made.operands[1]).value_or(1) : 1;
        return {stride * length, alignment};
      }
      case SpvOpTypeMatrix:
        return matrix(made.operands[1], module_.global(made.operands[0])->operands[1]);
      case SpvOpTypeStruct:
        return structure(type, made);
      default:
        return {};
    }
  }

 private:
  /// Returns the size of a matrix that consists of `vectors` vectors with `numbers` components each.
  Size matrix(std::uint32_t vectors, std::uint32_t numbers) const {
    const std::uint32_t stride = std::max(numbers == 2 ? 8U : 16U, least_);
    return {stride * vectors, stride};
  }

  Size structure(Id structType, const Instruction& made) {
    std::uint32_t at = 0, alignment = least_;
    for (std::uint32_t i = 0; i < made.operands.size(); ++i) {
      Id inner = made.operands[i];
      Size member = size(inner);
      std::uint32_t count = 1;
      while (isArray(module_.global(inner)->op)) {
        if (module_.global(inner)->op == SpvOpTypeArray)
          count *= module_.constant(module_.global(inner)->operands[1]).value_or(1);
        inner = module_.global(inner)->operands[0];
      }
      if (const Instruction type = *module_.global(inner); type.op == SpvOpTypeMatrix) {
        const std::uint32_t columns = type.operands[1],
                            rows = module_.global(type.operands[0])->operands[1];
        const bool rowMajor = module_.memberDecoration(structType, i, SpvDecorationRowMajor).has_value();
        const Size one = rowMajor ? matrix(rows, columns) : matrix(columns, rows);
        set(SpvOpMemberDecorate, {structType, i, SpvDecorationMatrixStride}, one.alignment);
        member = {one.bytes * count, one.alignment};
        if (inner != made.operands[i])
          set(SpvOpDecorate, {made.operands[i], SpvDecorationArrayStride}, one.bytes);
      }
      at = up(at, member.alignment);
      set(SpvOpMemberDecorate, {structType, i, SpvDecorationOffset}, at);
      at += member.bytes;
      alignment = std::max(alignment, member.alignment);
    }
    return {up(at, alignment), alignment};
  }

  void set(SpvOp op, Words begin, std::uint32_t value) {
    for (Instruction& one : module_.decorations)
      if (one.op == op && one.operands.size() == begin.size() + 1 &&
          std::equal(begin.begin(), begin.end(), one.operands.begin())) {
        one.operands.back() = value;
        return;
      }
    begin.push_back(value);
    module_.decorations.push_back({op, 0, 0, std::move(begin)});
  }

  static bool isArray(SpvOp op) { return op == SpvOpTypeArray || op == SpvOpTypeRuntimeArray; }

  Module& module_;
  std::uint32_t least_;
};

void withoutPushConstants(Module& module) {
  for (Instruction& one : module.globals)
    if ((one.op == SpvOpTypePointer || one.op == SpvOpVariable) &&
        one.operands[0] == SpvStorageClassPushConstant)
      one.operands[0] = SpvStorageClassUniform;
  module.index();
}

}  // namespace

void layOut(Module& module, bool hlsl) {
  withoutPushConstants(module);
  const std::vector<Instruction> globals = module.globals;
  for (const Instruction& one : globals) {
    const Resource kind = resourceOf(module, one);
    if (kind == Resource::block || (kind == Resource::storage && hlsl))
      Layout(module, kind == Resource::block).size(resourceType(module, one).result);
  }
}

void bindResources(Module& module) {
  std::erase_if(module.decorations, [](const Instruction& one) {
    return one.op == SpvOpDecorate &&
           (one.operands[1] == SpvDecorationBinding || one.operands[1] == SpvDecorationDescriptorSet);
  });
  std::uint32_t buffers = 0, blocks = 0, images = 0, textures = 0;
  const std::vector<Instruction> globals = module.globals;
  for (const Instruction& one : globals) {
    std::uint32_t* next = nullptr;
    switch (resourceOf(module, one)) {
      case Resource::storage:
        next = &buffers;
        break;
      case Resource::block:
        next = &blocks;
        break;
      case Resource::image:
        next = &images;
        break;
      case Resource::texture:
        next = &textures;
        break;
      default:
        continue;
    }
    module.decorate(one.result, SpvDecorationDescriptorSet, {0});
    module.decorate(one.result, SpvDecorationBinding, {(*next)++});
  }
}

}  // namespace simreel::kernels
