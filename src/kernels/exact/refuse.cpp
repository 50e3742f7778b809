#include "kernels/exact/refuse.hpp"

#include "kernels/compile/messages.hpp"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace simreel::kernels {

namespace {

struct Refusal {
  const char* message;
  bool whenFast;                                  ///< true if the feature is also rejected with fast
                                                  ///< numerics
  std::initializer_list<std::string_view> words;  ///< words in the source that may have caused the
                                                  ///< instruction; the caret marks one of them
};

/// Returns true for a built-in variable that describes a subgroup.
bool isOfSubgroup(std::optional<std::uint32_t> builtIn) {
  return builtIn &&
         ((*builtIn >= SpvBuiltInSubgroupSize && *builtIn <= SpvBuiltInSubgroupLocalInvocationId &&
           *builtIn != SpvBuiltInNumEnqueuedSubgroups) ||
          (*builtIn >= SpvBuiltInSubgroupEqMask && *builtIn <= SpvBuiltInSubgroupLtMask));
}

const Refusal* refusal(const Module& module, const Instruction& one) {
  static const Refusal floatAtomics = {
      "atomic operations on floating numbers give another sum with each order of the invocations; sum "
      "whole numbers (value * 65536) or reduce in shared memory",
      true,
      {"InterlockedAdd", "InterlockedMin", "InterlockedMax", "atomicAdd", "atomicMin", "atomicMax"}};
  static const Refusal subgroups = {
      "subgroup operations depend on the width that a driver gives its subgroups; use groupshared memory "
      "and barriers",
      true,
      {"Wave", "subgroup", "Quad", "ballot"}};
  static const Refusal derivatives = {
      "a compute shader has no neighbouring pixels to take a derivative of; compute the difference "
      "yourself, or give the level of detail",
      true,
      {"ddx", "ddy", "fwidth", "dFdx", "dFdy", "Sample"}};
  static const Refusal rays = {"OpenGL has no ray queries", true, {"rayQuery"}};
  static const Refusal matrices = {"OpenGL has no cooperative matrices", true, {"coopMat", "coopmat"}};
  const auto op = static_cast<unsigned>(one.op);
  if ((one.op == SpvOpLoad || one.op == SpvOpAccessChain) &&
      isOfSubgroup(module.decoration(one.operands[0], SpvDecorationBuiltIn)))
    return &subgroups;
  switch (one.op) {
    case SpvOpAtomicFAddEXT:
    case SpvOpAtomicFMinEXT:
    case SpvOpAtomicFMaxEXT:
      return &floatAtomics;
    case SpvOpDPdx:
    case SpvOpDPdy:
    case SpvOpFwidth:
    case SpvOpDPdxFine:
    case SpvOpDPdyFine:
    case SpvOpFwidthFine:
    case SpvOpDPdxCoarse:
    case SpvOpDPdyCoarse:
    case SpvOpFwidthCoarse:
    case SpvOpImageSampleImplicitLod:
    case SpvOpImageSampleProjImplicitLod:
    case SpvOpImageSampleDrefImplicitLod:
    case SpvOpImageQueryLod:
      return &derivatives;
    default:
      break;
  }
  const bool group = (op >= SpvOpGroupNonUniformElect && op <= SpvOpGroupNonUniformQuadSwap) ||
                     (op >= SpvOpGroupAll && op <= SpvOpGroupSMax) || (op >= 4421 && op <= 4432) ||
                     op == SpvOpGroupNonUniformPartitionNV;
  if (group) return &subgroups;
  if (op >= 4472 && op <= 4479) return &rays;
  if (op >= 5358 && op <= 5362) return &matrices;
  return nullptr;
}

struct Capability {
  std::uint32_t number;
  const char* message;
  bool whenFast;
};

const Capability* capability(std::uint32_t number) {
  static constexpr Capability refusals[] = {
      {SpvCapabilityFloat16, "OpenGL 4.5 has no numbers of 16 bits; write float", true},
      {SpvCapabilityInt16, "OpenGL 4.5 has no whole numbers of 16 bits; write int", true},
      {SpvCapabilityInt8, "OpenGL 4.5 has no whole numbers of 8 bits; write int", true},
      {SpvCapabilityInt64, "OpenGL 4.5 has no whole numbers of 64 bits; write two of 32", true},
      {SpvCapabilityStorageBuffer16BitAccess, "OpenGL 4.5 has no numbers of 16 bits; write float", true},
      {SpvCapabilityStorageBuffer8BitAccess, "OpenGL 4.5 has no whole numbers of 8 bits; write uint", true},
      {SpvCapabilityPhysicalStorageBufferAddresses,
       "OpenGL 4.5 has no references to buffers; use a buffer and an index", true},
      {SpvCapabilityRuntimeDescriptorArray,
       "OpenGL 4.5 has no arrays of textures or buffers without a length", true},
      {SpvCapabilityInt64Atomics, "OpenGL 4.5 has no atomic operations of 64 bits", true},
      {SpvCapabilityFloat64,
       "numbers of 64 bits have not the same bits on every driver; write float, or choose fast numerics",
       false},
  };
  for (const Capability& one : refusals)
    if (one.number == number) return &one;
  return nullptr;
}

/// Returns the longest identifier in the line that starts with one of the words.
std::string named(const Files& files, std::size_t file, int line,
                  std::initializer_list<std::string_view> words) {
  const std::string& text = files.text(file);
  std::size_t begin = 0;
  for (int i = 1; i < line && begin != std::string::npos; ++i) {
    begin = text.find('\n', begin);
    if (begin != std::string::npos) ++begin;
  }
  if (begin == std::string::npos) return {};
  const std::string_view found = std::string_view(text).substr(begin, text.find('\n', begin) - begin);
  for (const std::string_view word : words) {
    const std::size_t at = found.find(word);
    if (at == std::string_view::npos) continue;
    std::size_t end = at;
    while (end < found.size() &&
           (std::isalnum(static_cast<unsigned char>(found[end])) != 0 || found[end] == '_'))
      ++end;
    return std::string(found.substr(at, end - at));
  }
  return {};
}

}  // namespace

std::vector<Mistake> refused(const Module& module, const Files& files, bool fast) {
  std::vector<Mistake> mistakes;
  const auto add = [&](Mistake mistake) {
    if (std::none_of(mistakes.begin(), mistakes.end(), [&](const Mistake& other) {
          return other.file == mistake.file && other.line == mistake.line &&
                 other.message == mistake.message;
        }))
      mistakes.push_back(std::move(mistake));
  };
  std::size_t file = 0;
  int line = 0;
  for (const Instruction& one : module.body) {
    if (one.op == SpvOpLine) {
      file = fileNumber(module.text(one.operands[0]), files.count());
      line = static_cast<int>(one.operands[1]);
    }
    if (one.op == SpvOpStore && module.typeOf(one.operands[0]) != 0) {
      const Instruction* pointer = module.global(module.typeOf(one.operands[0]));
      const Id stored = module.typeOf(one.operands[1]);
      if (pointer != nullptr && pointer->op == SpvOpTypePointer && stored != 0 &&
          pointer->operands[1] != stored)
        add({file, line, "",
             "glslang gives this assignment a value of another type; write the value out, component by "
             "component"});
    }
    const Refusal* found = refusal(module, one);
    if (found != nullptr && (found->whenFast || !fast))
      add({file, line, named(files, file, line, found->words), found->message});
  }
  if (!mistakes.empty())
    return mistakes;  // The errors about capabilities would only repeat the errors about instructions.
  for (const Instruction& one : module.head) {
    if (one.op != SpvOpCapability) continue;
    const Capability* found = capability(one.operands[0]);
    if (found != nullptr && (found->whenFast || !fast)) {
      std::string token;
      for (const char* word :
           {"double", "float16_t", "int16_t", "uint16_t", "int64_t", "uint64_t", "min16float", "half"})
        if (token.empty() && withoutComments(files.text(0)).find(word) != std::string::npos) token = word;
      const std::size_t at = token.empty() ? 0 : withoutComments(files.text(0)).find(token);
      const std::string& text = files.text(0);
      add({0,
           1 + static_cast<int>(
                   std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')),
           token, found->message});
    }
  }
  return mistakes;
}

}  // namespace simreel::kernels
