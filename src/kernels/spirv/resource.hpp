#pragma once
#include "kernels/spirv/module.hpp"

#include <string>

namespace simreel::kernels {

enum class Resource { none, storage, block, image, texture, sampler };

/// Returns the resource kind of a global variable.
[[nodiscard]] Resource resourceOf(const Module& module, const Instruction& variable);
/// Returns the pointee type of a variable; for an array of resources, the type of one resource.
[[nodiscard]] const Instruction& resourceType(const Module& module, const Instruction& variable);

/// True for an array of resources.
[[nodiscard]] bool isArrayed(const Module& module, const Instruction& variable);
/// Returns a unique name for a block. OpenGL identifies blocks by their type name, but HLSL buffers may
/// share a type; cbuffers have no variable name.
[[nodiscard]] std::string blockName(const Module& module, Id variable, bool hlsl);
/// Returns the user's name of a buffer, without glslang's @ suffixes.
[[nodiscard]] std::string bufferName(const Module& module, Id variable, bool hlsl);
/// Removes glslang's @ suffixes from a name: "@data" for a buffer's elements, "_Found@count" for a counter.
[[nodiscard]] std::string plainName(const std::string& name);

}  // namespace simreel::kernels
