#pragma once
#include <string>

namespace simreel::kernels {

/// Moves the increments of a loop into its body if there are several. In `for (; test; x = next, ++i)` with
/// a `break`, NVIDIA's compiler (580.159) executes the first increments before it leaves the loop.
/// Assignments in the body do not have this problem.
void moveIncrements(std::string& glsl);

}  // namespace simreel::kernels
