#pragma once
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

/// Puts a block between the test of a loop and the block behind it, if that block has phis. SPIRV-Cross
/// writes such a loop as `for (; test;)` and leaves out the values that the phis have where the test fails.
/// Undefined values become zero.
void splitLoopExits(Module& module);

}  // namespace simreel::kernels
