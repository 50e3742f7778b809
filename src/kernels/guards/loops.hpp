#pragma once
#include "kernels/guards/report.hpp"

#include <cstdint>

namespace simreel::kernels {

/// Ends each loop of a module (in glslang's form) at the start of its iteration `most` + 1. After that all
/// other loops of the invocation end too; otherwise an enclosing loop would multiply the time by `most`.
/// `unrolled`: also limits loops marked for unrolling, so that SPIRV-Tools cannot unroll them any more.
/// `report`: records it; nullptr: no reports.
void limitLoops(Module& module, std::uint32_t most, bool unrolled, Report* report);

/// True if a loop marked for unrolling has not been unrolled.
[[nodiscard]] bool keepsUnrolled(const Module& module);

}  // namespace simreel::kernels
