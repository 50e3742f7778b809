#include "cli/options/device_options.hpp"

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

void add(CLI::App& command, gl::ContextOptions& options, const char* device) {
  command.add_option("--device", options.device, device);
  command.add_option("--memory-path", options.memoryPath,
                     "How kernels read memory: storage (fast on GPUs) or texel (fast on software drivers); "
                     "left out: as suits the driver");
}

}  // namespace

void addDevice(CLI::App& command, gl::ContextOptions& options) {
  add(command, options, "Device to use, by its number or a part of its name (see `simreel doctor`)");
}

void addDevices(CLI::App& command, gl::ContextOptions& options) {
  add(command, options,
      "Device to use, by its number or a part of its name (see `simreel doctor`). With a list (0,1) each "
      "process takes the next device, and at least one process for each device runs");
}

}  // namespace simreel::cli
