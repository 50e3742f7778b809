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

/// Writes std140 offsets and strides of a struct, and of all within.
class Std140 {
 public:
  explicit Std140(Module& module) : module_(module) {}

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
      case SpvOpTypeArray: {
        const Size element = size(made.operands[0]);
        const std::uint32_t stride = up(up(element.bytes, element.alignment), 16);
        set(SpvOpDecorate, {type, SpvDecorationArrayStride}, stride);
        return {stride * module_.constant(made.operands[1]).value_or(1), std::max(element.alignment, 16U)};
      }
      case SpvOpTypeMatrix:
        return {16 * made.operands[1], 16};
      case SpvOpTypeStruct:
        return structure(type, made);
      default:
        return {};
    }
  }

 private:
  Size structure(Id type, const Instruction& made) {
    std::uint32_t at = 0, alignment = 16;
    for (std::uint32_t i = 0; i < made.operands.size(); ++i) {
      Id inner = made.operands[i];
      Size member = size(inner);
      std::uint32_t count = 1;
      while (module_.global(inner)->op == SpvOpTypeArray) {
        count *= module_.constant(module_.global(inner)->operands[1]).value_or(1);
        inner = module_.global(inner)->operands[0];
      }
      if (module_.global(inner)->op == SpvOpTypeMatrix) {
        set(SpvOpMemberDecorate, {type, i, SpvDecorationMatrixStride}, 16);
        // row major: as many vectors as a column has numbers
        if (module_.memberDecoration(type, i, SpvDecorationRowMajor)) {
          const std::uint32_t rows = module_.global(module_.global(inner)->operands[0])->operands[1];
          member.bytes = 16 * rows * count;
          if (count > 1) set(SpvOpDecorate, {made.operands[i], SpvDecorationArrayStride}, 16 * rows);
        }
      }
      at = up(at, member.alignment);
      set(SpvOpMemberDecorate, {type, i, SpvDecorationOffset}, at);
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

  Module& module_;
};

void withoutPushConstants(Module& module) {
  for (Instruction& one : module.globals)
    if ((one.op == SpvOpTypePointer || one.op == SpvOpVariable) &&
        one.operands[0] == SpvStorageClassPushConstant)
      one.operands[0] = SpvStorageClassUniform;
  module.index();
}

}  // namespace

void layOut(Module& module) {
  withoutPushConstants(module);
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
        Std140(module).size(resourceType(module, one).result);
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
