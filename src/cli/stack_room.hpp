#pragma once

namespace simreel::cli {

/// Where the stack that the shell allows is too small for drivers and for threads, begins the program again
/// with more. Throws UserError(device) where no more is to be had and what there is would end in a crash.
void takeStackRoom(char** arguments);

}  // namespace simreel::cli
