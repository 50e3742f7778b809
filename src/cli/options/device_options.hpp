#pragma once
#include "gl/context.hpp"

namespace CLI {
class App;
}

namespace simreel::cli {

/// --device and --memory-path.
void addDevice(CLI::App& command, gl::ContextOptions& options);
/// The same of a command whose processes each may have another device: "0,1".
void addDevices(CLI::App& command, gl::ContextOptions& options);

}  // namespace simreel::cli
