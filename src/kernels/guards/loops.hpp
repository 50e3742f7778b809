#pragma once
#include "kernels/guards/report.hpp"

#include <cstdint>

namespace simreel::kernels {

/// Ends each loop of a module (in the form that glslang writes) at the start of iteration `most` + 1. After
/// that, all loops of the invocation end at once, because an outer loop would otherwise take `most` times
/// as long. If `unrolled` is true, loops marked for unrolling are limited, too; SPIRV-Tools then cannot
/// unroll these loops. `report` receives the faults and may be null. If it is not null, loops that the
/// driver ends are reported as well: llvmpipe silently ends the loops of an invocation after 65,535
/// iterations of all its loops together.
void limitLoops(Module& module, std::uint32_t most, bool unrolled, Report* report);

/// Returns true if a loop marked for unrolling has not been unrolled.
[[nodiscard]] bool keepsUnrolled(const Module& module);

}  // namespace simreel::kernels
