#pragma once
#include "kernels/guards/report.hpp"

namespace simreel::kernels {

/// Adds code that reports races in shared memory since the last barrier. These are accesses to words that
/// another invocation of the workgroup has changed, and changes of words that another invocation has read.
/// Skips variables whose tags (three per word) do not fit into 32 KiB.
void checkShared(Module& module, Report& report);

}  // namespace simreel::kernels
