#pragma once
#include "kernels/spirv/module.hpp"

#include <cstdint>
#include <unordered_map>

namespace simreel::kernels {

/// Adds an element for dropped writes to arrays in shared memory, as long as memory is left. Returns the
/// lengths before, by variable.
[[nodiscard]] std::unordered_map<Id, std::uint32_t> enlargeShared(Module& module);

}  // namespace simreel::kernels
