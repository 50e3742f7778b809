#pragma once
#include "kernels/spirv/module.hpp"

#include <cstdint>
#include <unordered_map>

namespace simreel::kernels {

/// Adds one element to each array in shared memory as long as shared memory is available. Dropped writes go
/// to this element. Returns the original length of each array by variable.
[[nodiscard]] std::unordered_map<Id, std::uint32_t> enlargeShared(Module& module);

}  // namespace simreel::kernels
