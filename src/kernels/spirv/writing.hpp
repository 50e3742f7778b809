#pragma once
#include "kernels/spirv/module.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace simreel::kernels {

/// Appends instructions to a list, with fresh ids of a module.
class Writing {
 public:
  Writing(Module& module, std::vector<Instruction>& to) : module_(module), to_(to) {}

  /// Appends an instruction with a result, and returns its id.
  Id emit(SpvOp op, Id type, Words operands) {
    const Id made = module_.fresh();
    module_.noteType(made, type);
    to_.push_back({op, type, made, std::move(operands)});
    return made;
  }
  void put(SpvOp op, Words operands) { to_.push_back({op, 0, 0, std::move(operands)}); }
  void label(Id id) { to_.push_back({SpvOpLabel, 0, id, {}}); }
  /// Begins a selection: what follows runs where the condition holds. Returns the label for close().
  Id open(Id condition) {
    const Id inner = module_.fresh(), merge = module_.fresh();
    put(SpvOpSelectionMerge, {merge, SpvSelectionControlMaskNone});
    put(SpvOpBranchConditional, {condition, inner, merge});
    label(inner);
    return merge;
  }
  void close(Id merge) {
    put(SpvOpBranch, {merge});
    label(merge);
  }
  /// Begins a function of these parameters without a result; returns their ids.
  Words function(Id id, const Words& parameterTypes);
  void end() {
    put(SpvOpReturn, {});
    put(SpvOpFunctionEnd, {});
  }

  /// `a` where the condition, of one number, holds, `b` elsewhere; `result`: an id that is there already.
  Id select(Id condition, Id type, Id a, Id b, Id result = 0);
  /// A whole number by its bits.
  Id asUint(Id value) { return cast(value, module_.uintType()); }
  Id asInt(Id value) { return cast(value, module_.intType()); }
  Id load(Id type, Id pointer) { return emit(SpvOpLoad, type, {pointer}); }
  /// The place of a member, as chain of constant or computed indices.
  Id chain(SpvStorageClass storage, Id type, Id base, const Words& indices);

 private:
  Id cast(Id value, Id type) {
    return module_.typeOf(value) == type ? value : emit(SpvOpBitcast, type, {value});
  }

  Module& module_;
  std::vector<Instruction>& to_;
};

/// Names an id, or a member of a struct.
void giveName(Module& module, Id id, const std::string& name);
void giveMemberName(Module& module, Id type, std::uint32_t member, const std::string& name);

/// The variable that holds a built-in vector of so many whole numbers, an input of the kernel.
Id builtIn(Module& module, SpvBuiltIn what, std::uint32_t length = 3);

/// Threads of a group.
[[nodiscard]] std::array<std::uint32_t, 3> groupSize(const Module& module);

/// A storage buffer `name` whose one member, `member`, is an array of `element` without a fixed length.
Id storageBuffer(Module& module, const std::string& name, const std::string& member, Id element,
                 std::uint32_t stride);

}  // namespace simreel::kernels
