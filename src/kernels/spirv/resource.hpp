#pragma once
#include "kernels/spirv/module.hpp"

#include <string>

namespace simreel::kernels {

enum class Resource { none, storage, block, image, texture, sampler };

/// Returns the resource kind of a global variable.
[[nodiscard]] Resource resourceOf(const Module& module, const Instruction& variable);
/// Returns the pointee type of a variable. For an array of resources, returns the type of one resource.
[[nodiscard]] const Instruction& resourceType(const Module& module, const Instruction& variable);

/// Returns true for an array of resources.
[[nodiscard]] bool isArrayed(const Module& module, const Instruction& variable);
/// Returns a unique name for a block. OpenGL identifies blocks by the name of their type, but several HLSL
/// buffers may have the same type, and cbuffers have no variable name.
[[nodiscard]] std::string blockName(const Module& module, Id variable, bool hlsl);
/// Returns the name of a buffer in the user's source, without glslang's @ suffixes.
[[nodiscard]] std::string bufferName(const Module& module, Id variable, bool hlsl);
/// Removes the @ suffixes that glslang adds to names, such as "@data" for a buffer's elements and
/// "_Found@count" for a counter.
[[nodiscard]] std::string plainName(const std::string& name);

}  // namespace simreel::kernels
