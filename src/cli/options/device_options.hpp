#pragma once
#include "gl/context.hpp"

namespace CLI {
class App;
}

namespace simreel::cli {

/// Adds --device and --memory-path.
void addDevice(CLI::App& command, gl::ContextOptions& options);
/// Adds --device and --memory-path for a command with several processes. --device may then be a list such
/// as "0,1".
void addDevices(CLI::App& command, gl::ContextOptions& options);

}  // namespace simreel::cli
