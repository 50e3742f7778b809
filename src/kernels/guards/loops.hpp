#pragma once
#include "kernels/guards/report.hpp"

#include <cstdint>

namespace simreel::kernels {

/// Ends each loop of a module, as glslang writes it, when it begins its iteration `most` + 1 in one run;
/// from then on the invocation's other loops end, too, or a loop around would take `most` times as long.
/// `unrolled`: those that are to be unrolled, too, which SPIRV-Tools then cannot do. `report`: notes it;
/// nullptr for none. With it, loops that
/// the driver ends by itself are noted, too: llvmpipe ends those of an invocation after 65,535 iterations
/// of all loops together, and lets the invocation go on.
void limitLoops(Module& module, std::uint32_t most, bool unrolled, Report* report);

/// True if a loop marked for unrolling has not been unrolled.
[[nodiscard]] bool keepsUnrolled(const Module& module);

}  // namespace simreel::kernels
