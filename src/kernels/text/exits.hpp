#pragma once
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

/// Inserts a block between the test of a loop and the loop's merge block, if the merge block has phis.
/// Otherwise SPIRV-Cross would write the loop as `for (; test;)` and leave out the values that the phis
/// have if the test fails. Undefined values become zero.
void splitLoopExits(Module& module);

}  // namespace simreel::kernels
