#pragma once
#include <string>

namespace simreel::kernels {

/// Moves the increments of a loop into its body if there are several. In `for (; test; x = next, ++i)` with
/// a `break`, NVIDIA's compiler (580.159) makes the first increments
/// before it leaves. Assignments in the body are safe.
void moveIncrements(std::string& glsl);

}  // namespace simreel::kernels
