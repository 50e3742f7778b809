#pragma once
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

enum class Resource { none, storage, block, image, texture, sampler };

/// Kind of resource of a global variable.
[[nodiscard]] Resource resourceOf(const Module& module, const Instruction& variable);
/// The type that a pointer points to, of an array of resources that of one.
[[nodiscard]] const Instruction& resourceType(const Module& module, const Instruction& variable);

}  // namespace simreel::kernels
