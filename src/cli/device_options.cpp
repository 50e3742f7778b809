#include "cli/device_options.hpp"

#include <CLI/CLI.hpp>

namespace simreel::cli {

void addDevice(CLI::App& command, gl::ContextOptions& options) {
  command.add_option("--device", options.device, "Index or part of a name (see `simreel doctor`)");
  command.add_option("--memory-path", options.memoryPath,
                     "storage (kernels read memory as GPUs like it, and finish the picture) or texel (as "
                     "software drivers do); by driver if not given");
}

}  // namespace simreel::cli
