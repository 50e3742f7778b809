#pragma once

namespace simreel {

/// Sets the function that long computations within a frame call repeatedly. Null means no function. The
/// function may throw to stop the computation, which leaves the frame unfinished.
void setFrameCheck(void (*check)());
/// Calls the function set by setFrameCheck(), if there is one.
void checkFrame();

}  // namespace simreel
