#include "cli/options/device_options.hpp"

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

void add(CLI::App& command, gl::ContextOptions& options, const char* device) {
  command.add_option("--device", options.device, device);
  command.add_option("--memory-path", options.memoryPath,
                     "storage (kernels read memory as GPUs like it, and finish the picture) or texel (as "
                     "software drivers do); by driver if not given");
}

}  // namespace

void addDevice(CLI::App& command, gl::ContextOptions& options) {
  add(command, options, "Index or part of a name (see `simreel doctor`)");
}

void addDevices(CLI::App& command, gl::ContextOptions& options) {
  add(command, options,
      "Index or part of a name (see `simreel doctor`); of several, 0,1, each process takes the next: at "
      "least one a device runs");
}

}  // namespace simreel::cli
