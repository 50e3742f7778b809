#pragma once
#include "kernels/guards/report.hpp"

#include <cstdint>

namespace simreel::kernels {

/// Ends each loop of a module (in the form that glslang writes) at the start of iteration `maximum` + 1.
/// After that, all loops of the invocation end at once, because an outer loop would otherwise take
/// `maximum` times as long. `unrolled`: true to limit also loops marked for unrolling, which SPIRV-Tools
/// then cannot unroll. `report`: records the faults; may be nullptr. With a report, loops that the driver
/// ends are reported as well. llvmpipe silently ends the loops of an invocation after 65,535 iterations of
/// all its loops together.
void limitLoops(Module& module, std::uint32_t maximum, bool unrolled, Report* report);

/// Returns true if a loop marked for unrolling has not been unrolled.
[[nodiscard]] bool keepsUnrolled(const Module& module);

}  // namespace simreel::kernels
