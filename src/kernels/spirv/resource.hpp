#pragma once
#include "kernels/spirv/module.hpp"

#include <string>

namespace simreel::kernels {

enum class Resource { none, storage, block, image, texture, sampler };

/// Kind of resource of a global variable.
[[nodiscard]] Resource resourceOf(const Module& module, const Instruction& variable);
/// The type that a pointer points to, of an array of resources that of one.
[[nodiscard]] const Instruction& resourceType(const Module& module, const Instruction& variable);

/// True for an array of resources.
[[nodiscard]] bool isArrayed(const Module& module, const Instruction& variable);
/// The name of a block's variable. In OpenGL a block is known by its type's name; buffers of HLSL may share
/// a type, cbuffers have no variable's.
[[nodiscard]] std::string blockName(const Module& module, Id variable, bool hlsl);
/// The name of a buffer as the user wrote it, without what glslang marks with @.
[[nodiscard]] std::string bufferName(const Module& module, Id variable, bool hlsl);
/// A name without what glslang marks with @: "@data" of a buffer's elements, "_Found@count" of a counter.
[[nodiscard]] std::string plainName(const std::string& name);

}  // namespace simreel::kernels
