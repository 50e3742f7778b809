#pragma once

namespace simreel::cli {

/// Restarts the program with a larger stack limit if the shell's limit is too small for drivers and
/// threads. Throws UserError(device) if the limit cannot be raised and would cause a crash.
void takeStackRoom(char** arguments);

}  // namespace simreel::cli
