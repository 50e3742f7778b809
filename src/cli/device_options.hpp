#pragma once
#include "gl/context.hpp"

namespace CLI {
class App;
}

namespace simreel::cli {

/// --device and --memory-path.
void addDevice(CLI::App& command, gl::ContextOptions& options);

}  // namespace simreel::cli
