#pragma once
#include "kernels/guards/report.hpp"

namespace simreel::kernels {

/// Adds code that notes accesses to words of shared memory that another invocation of the group changed, or
/// read before a change, with no barrier between. Variables for whose words three tags each find no room in
/// 32 KiB are left out.
void checkShared(Module& module, Report& report);

}  // namespace simreel::kernels
