#pragma once
#include "kernels/spirv/module.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace simreel::kernels {

/// Appends instructions with fresh ids to a list of instructions of a module.
class Writing {
 public:
  Writing(Module& module, std::vector<Instruction>& to) : module_(module), to_(to) {}

  /// Appends an instruction with a result and returns the result's id.
  Id emit(SpvOp op, Id type, Words operands) {
    const Id made = module_.fresh();
    module_.noteType(made, type);
    to_.push_back({op, type, made, std::move(operands)});
    return made;
  }
  void put(SpvOp op, Words operands) { to_.push_back({op, 0, 0, std::move(operands)}); }
  void label(Id id) { to_.push_back({SpvOpLabel, 0, id, {}}); }
  /// Opens an if block. The instructions that follow run only if the condition is true. Returns the label
  /// for close().
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
  /// Starts a void function with these parameter types. Returns the ids of the parameters.
  Words function(Id id, const Words& parameterTypes);
  void end() {
    put(SpvOpReturn, {});
    put(SpvOpFunctionEnd, {});
  }

  /// Emits `a` if the scalar condition is true, and otherwise `b`. `result`: existing id for the result, or
  /// 0 for a new one.
  Id select(Id condition, Id type, Id a, Id b, Id result = 0);
  /// asUint() and asInt() bitcast an integer to unsigned and signed.
  Id asUint(Id value) { return cast(value, module_.uintType()); }
  Id asInt(Id value) { return cast(value, module_.intType()); }
  Id load(Id type, Id pointer) { return emit(SpvOpLoad, type, {pointer}); }
  /// Emits an access chain with constant or computed indices.
  Id chain(SpvStorageClass storage, Id type, Id base, const Words& indices);

 private:
  Id cast(Id value, Id type) {
    return module_.typeOf(value) == type ? value : emit(SpvOpBitcast, type, {value});
  }

  Module& module_;
  std::vector<Instruction>& to_;
};

/// Gives a name to an id or to a member of a struct.
void giveName(Module& module, Id id, const std::string& name);
void giveMemberName(Module& module, Id type, std::uint32_t member, const std::string& name);

/// Returns the input variable of a built-in integer vector. Creates the variable if it does not exist.
Id builtIn(Module& module, SpvBuiltIn what, std::uint32_t length = 3);

/// Returns the number of threads of a workgroup in x, y and z.
[[nodiscard]] std::array<std::uint32_t, 3> groupSize(const Module& module);

/// Creates a storage buffer `name` that contains only an unsized array `member` with elements of type
/// `element`.
Id storageBuffer(Module& module, const std::string& name, const std::string& member, Id element,
                 std::uint32_t stride);

}  // namespace simreel::kernels
