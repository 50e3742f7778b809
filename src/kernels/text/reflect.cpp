#include "kernels/text/reflect.hpp"

#include "kernels/spirv/resource.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include <fmt/format.h>

namespace simreel::kernels {

namespace {

const char* formatName(std::uint32_t format) {
  static constexpr const char* names[] = {"",          "rgba32f",      "rgba16f",
                                          "r32f",      "rgba8",        "rgba8_snorm",
                                          "rg32f",     "rg16f",        "r11f_g11f_b10f",
                                          "r16f",      "rgba16",       "rgb10_a2",
                                          "rg16",      "rg8",          "r16",
                                          "r8",        "rgba16_snorm", "rg16_snorm",
                                          "rg8_snorm", "r16_snorm",    "r8_snorm",
                                          "rgba32i",   "rgba16i",      "rgba8i",
                                          "r32i",      "rg32i",        "rg16i",
                                          "rg8i",      "r16i",         "r8i",
                                          "rgba32ui",  "rgba16ui",     "rgba8ui",
                                          "r32ui",     "rgb10_a2ui",   "rg32ui",
                                          "rg16ui",    "rg8ui",        "r16ui",
                                          "r8ui"};
  return format < std::size(names) ? names[format] : "";
}

class Reflecting {
 public:
  Reflecting(const Module& module, Language language)
      : module_(module), hlsl_(language == Language::hlsl) {}

  std::string typeName(Id type) const {
    const Instruction& made = *module_.global(type);
    switch (made.op) {
      case SpvOpTypeFloat:
        return made.operands[0] == 64 ? "double" : made.operands[0] == 16 ? "half" : "float";
      case SpvOpTypeInt:
        return made.operands[1] == 1 ? "int" : "uint";
      case SpvOpTypeBool:
        return "bool";
      case SpvOpTypeVector: {
        const std::string component = typeName(made.operands[0]);
        if (hlsl_) return fmt::format("{}{}", component, made.operands[1]);
        return fmt::format("{}vec{}", component == "float" ? "" : component.substr(0, 1), made.operands[1]);
      }
      case SpvOpTypeMatrix: {
        const std::uint32_t columns = made.operands[1],
                            rows = module_.global(made.operands[0])->operands[1];
        // glslang represents an HLSL matrix by its transpose.
        if (hlsl_) return fmt::format("float{}x{}", columns, rows);
        return columns == rows ? fmt::format("mat{}", columns) : fmt::format("mat{}x{}", columns, rows);
      }
      case SpvOpTypeStruct:
        return plainName(module_.name(type));
      default:
        return "?";
    }
  }

  std::size_t bytes(Id type, bool rowMajor, std::size_t matrixStride) const {
    const Instruction& made = *module_.global(type);
    switch (made.op) {
      case SpvOpTypeFloat:
      case SpvOpTypeInt:
        return made.operands[0] / 8;
      case SpvOpTypeVector:
        return made.operands[1] * bytes(made.operands[0], false, 0);
      case SpvOpTypeMatrix:
        return matrixStride * (rowMajor ? module_.global(made.operands[0])->operands[1] : made.operands[1]);
      case SpvOpTypeArray:
        return module_.constant(made.operands[1]).value_or(1) *
               module_.decoration(type, SpvDecorationArrayStride).value_or(0);
      case SpvOpTypeStruct: {
        std::size_t end = 0;
        for (const Member& member : members(type)) {
          std::size_t count = 1;
          for (const std::size_t length : member.array) count *= length;
          end =
              std::max(end, member.offset + (member.array.empty() ? member.bytes : count * member.stride));
        }
        return end;
      }
      default:
        return 4;
    }
  }

  std::vector<Member> members(Id structure) const {
    std::vector<Member> found;
    const Instruction& made = *module_.global(structure);
    for (std::uint32_t i = 0; i < made.operands.size(); ++i) {
      Member member;
      member.name = plainName(module_.memberName(structure, i));
      member.offset = module_.memberDecoration(structure, i, SpvDecorationOffset).value_or(0);
      Id type = made.operands[i];
      for (const Instruction* array = module_.global(type);
           array->op == SpvOpTypeArray || array->op == SpvOpTypeRuntimeArray;
           array = module_.global(type)) {
        member.array.push_back(
            array->op == SpvOpTypeArray ? module_.constant(array->operands[1]).value_or(1) : 0);
        // The stride of the innermost array is used; nested arrays have no padding.
        member.stride = module_.decoration(type, SpvDecorationArrayStride).value_or(0);
        type = array->operands[0];
      }
      member.type = typeName(type);
      member.bytes = bytes(type, module_.memberDecoration(structure, i, SpvDecorationRowMajor).has_value(),
                           module_.memberDecoration(structure, i, SpvDecorationMatrixStride).value_or(16));
      if (module_.global(type)->op == SpvOpTypeStruct) member.members = members(type);
      found.push_back(std::move(member));
    }
    return found;
  }

 private:
  const Module& module_;
  bool hlsl_;
};

struct Use {
  bool reads = false, writes = false;
  std::unordered_set<std::uint32_t> members;  ///< indices of block members that the body accesses
  bool whole = false;                         ///< true if the variable is used without a member index
};

/// Returns the uses of each variable in the body, traced through access chains and loaded images.
std::unordered_map<Id, Use> uses(const Module& module) {
  std::unordered_map<Id, Id> from;
  std::unordered_map<Id, Use> found;
  const auto root = [&](Id id) {
    for (auto next = from.find(id); next != from.end(); next = from.find(id)) id = next->second;
    return id;
  };
  for (const Instruction& one : module.body) {
    switch (one.op) {
      case SpvOpAccessChain:
      case SpvOpInBoundsAccessChain:
        if (one.operands.size() > 1)
          if (const auto member = module.constant(one.operands[1]))
            found[one.operands[0]].members.insert(*member);
        from[one.result] = one.operands[0];
        break;
      case SpvOpImageTexelPointer:
      case SpvOpCopyObject:
      case SpvOpSampledImage:
      case SpvOpImage:
        from[one.result] = one.operands[0];
        break;
      case SpvOpLoad:
        from[one.result] = one.operands[0];
        found[one.operands[0]].whole = true;
        // A loaded image counts as read only if a later instruction reads it.
        if (const Instruction* type = module.global(one.type);
            type == nullptr || (type->op != SpvOpTypeImage && type->op != SpvOpTypeSampledImage))
          found[root(one.operands[0])].reads = true;
        break;
      case SpvOpStore:
      case SpvOpAtomicStore:
      case SpvOpImageWrite:
        found[root(one.operands[0])].writes = true;
        break;
      case SpvOpCopyMemory:
        found[root(one.operands[0])].writes = true;
        found[root(one.operands[1])].reads = true;
        break;
      case SpvOpFunctionCall:
        for (std::size_t i = 1; i < one.operands.size(); ++i) {
          const Id variable = root(one.operands[i]);
          if (module.global(variable) != nullptr && module.global(variable)->op == SpvOpVariable)
            found[variable] = {true, true, {}, true};
        }
        break;
      default:
        if (one.op >= SpvOpAtomicLoad && one.op <= SpvOpAtomicXor) {
          Use& use = found[root(one.operands[0])];
          use.reads = true;
          use.writes = use.writes || one.op != SpvOpAtomicLoad;
        } else if (one.op >= SpvOpImageSampleImplicitLod && one.op <= SpvOpImageRead) {
          found[root(one.operands[0])].reads = true;
        }
    }
  }
  return found;
}

}  // namespace

void describeImage(const Module& module, const Instruction& image, Texture& texture) {
  static constexpr const char* dimensions[] = {"1D", "2D", "3D", "Cube", "Rect", "Buffer"};
  texture.type = image.operands[1] < std::size(dimensions) ? dimensions[image.operands[1]] : "?";
  if (image.operands[4] == 1) texture.type += "MS";
  if (image.operands[3] == 1) texture.type += "Array";
  const Instruction& number = *module.global(image.operands[0]);
  texture.values = number.op == SpvOpTypeFloat ? "float" : number.operands[1] == 1 ? "int" : "uint";
  texture.format = image.operands[5] == 2 ? formatName(image.operands[6]) : "";
}

namespace {

/// The ids in the module's code for the indices of the running invocation and of its workgroup. They are
/// pointers to such an index, and values loaded from it.
class InvocationIndices {
 public:
  explicit InvocationIndices(const Module& module) {
    for (const Instruction& one : module.globals) {
      const auto what = module.decoration(one.result, SpvDecorationBuiltIn);
      if (one.op == SpvOpVariable && what &&
          (*what == SpvBuiltInGlobalInvocationId || *what == SpvBuiltInWorkgroupId))
        ids_.insert(one.result);
    }
    Id function = 0;
    for (const Instruction& one : module.body) {
      if (one.op == SpvOpFunction) function = one.result;
      if (one.op == SpvOpFunctionParameter) parameters_[function].push_back(one.result);
      if (one.op == SpvOpVariable) variables_.insert(one.result);
    }
    for (std::size_t before = 0; before != ids_.size();) {
      before = ids_.size();
      for (const Instruction& one : module.body) follow(one);
    }
  }
  [[nodiscard]] bool has(const Instruction& one, std::size_t at) const {
    return at < one.operands.size() && isId(one, at) && ids_.contains(one.operands[at]);
  }
  /// Returns true if follow() can determine the use of each index among the operands.
  [[nodiscard]] bool follows(const Instruction& one) const {
    return one.op == SpvOpLoad || one.op == SpvOpFunctionCall ||
           (one.op == SpvOpStore && ids_.contains(one.operands[0]));
  }

 private:
  void follow(const Instruction& one) {
    if (one.op == SpvOpLoad && has(one, 0)) ids_.insert(one.result);
    if (one.op == SpvOpStore && has(one, 1) && variables_.contains(one.operands[0]))
      ids_.insert(one.operands[0]);
    if (one.op != SpvOpFunctionCall) return;
    const Words& parameters = parameters_[one.operands[0]];
    for (std::size_t i = 0; i < parameters.size(); ++i)
      if (has(one, i + 1)) ids_.insert(parameters[i]);
  }

  std::unordered_set<Id> ids_, variables_;
  std::unordered_map<Id, Words> parameters_;
};

}  // namespace

unsigned axesRead(const Module& module) {
  constexpr unsigned all = 7;
  unsigned axes = 0;
  const InvocationIndices numbers(module);
  const auto axis = [&](std::optional<std::uint32_t> number) {
    axes |= number && *number < 3 ? 1U << *number : all;
  };
  for (const Instruction& one : module.body) {
    if (numbers.follows(one)) continue;
    if (one.op == SpvOpAccessChain && numbers.has(one, 0)) {
      axis(module.constant(one.operands[1]));
    } else if (one.op == SpvOpCompositeExtract && numbers.has(one, 0)) {
      axis(one.operands[1]);
    } else if (one.op == SpvOpVectorShuffle) {
      const bool given = numbers.has(one, 0) || numbers.has(one, 1);
      for (std::size_t i = 2; given && i < one.operands.size(); ++i) axis(one.operands[i] % 3);
    } else {
      for (std::size_t i = 0; i < one.operands.size(); ++i)
        if (numbers.has(one, i)) axes = all;
    }
  }
  return axes;
}

Kernel reflected(const Module& module, Language language) {
  Kernel kernel;
  for (const Instruction& one : module.head)
    if (one.op == SpvOpExecutionMode && one.operands[1] == SpvExecutionModeLocalSize)
      for (std::size_t i = 0; i < 3; ++i) kernel.threads[i] = one.operands[2 + i];
  const Reflecting reflecting(module, language);
  std::unordered_map<Id, Use> used = uses(module);
  for (const Instruction& one : module.globals) {
    const Resource resource = resourceOf(module, one);
    if (resource == Resource::none) continue;
    const Instruction& type = resourceType(module, one);
    const Id pointee = type.result;
    const int binding = static_cast<int>(module.decoration(one.result, SpvDecorationBinding).value_or(0));
    const Use use = used[one.result];
    if (resource == Resource::storage) {
      const std::string name = blockName(module, one.result, language == Language::hlsl);
      Buffer buffer;
      buffer.name = plainName(name);
      buffer.binding = binding;
      buffer.reads = use.reads;
      buffer.writes = use.writes;
      buffer.members = reflecting.members(pointee);
      if (name.find("@count") != std::string::npos) {
        buffer.counterOf = buffer.name;
        buffer.name += ".counter";
      }
      kernel.buffers.push_back(std::move(buffer));
    } else if (resource == Resource::block) {
      std::string name = blockName(module, one.result, language == Language::hlsl);
      if (name.starts_with('$') || name == "gl_DefaultUniformBlock") name.clear();
      std::vector<Member> members = reflecting.members(pointee);
      for (std::uint32_t i = 0; i < members.size(); ++i)
        members[i].used = use.whole || use.members.contains(i);
      kernel.blocks.push_back(
          {name, binding, (reflecting.bytes(pointee, false, 16) + 15) / 16 * 16, std::move(members)});
    } else if (resource == Resource::image) {
      Texture image;
      image.name = image.uniform = module.name(one.result);
      describeImage(module, type, image);
      image.binding = binding;
      image.reads = use.reads;
      image.writes = use.writes;
      kernel.textures.push_back(std::move(image));
    }
  }
  return kernel;
}

}  // namespace simreel::kernels
