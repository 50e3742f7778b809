#pragma once

namespace simreel {

/// Sets the function that the parts of a long frame call in between; null: none. It may throw to end the
/// work, which leaves the frame unfinished.
void setFrameCheck(void (*check)());
/// Calls the function that setFrameCheck() set, if any.
void checkFrame();

}  // namespace simreel
