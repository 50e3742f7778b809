#pragma once
#include "kernels/guards/report.hpp"

namespace simreel::kernels {

/// Adds code that reports races in shared memory: accesses to words that another invocation of the
/// workgroup has changed, or changes to words that another one has read, without a barrier in between.
/// Variables whose tags (three per word) do not fit into 32 KiB are skipped.
void checkShared(Module& module, Report& report);

}  // namespace simreel::kernels
