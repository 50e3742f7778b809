#include "base/error.hpp"
#include "base/file.hpp"
#include "base/version.hpp"
#include "cli/commands.hpp"
#include "draw/picture_probe.hpp"
#include "gl/context.hpp"
#include "gl/limits.hpp"
#include "gl/machine.hpp"
#include "sim/numerics.hpp"

#include <string>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

void printDevices(const std::vector<gl::DeviceInfo>& devices) {
  fmt::print("EGL devices: {}\n", devices.empty() ? "none" : std::to_string(devices.size()));
  for (const gl::DeviceInfo& d : devices) {
    fmt::print("  {}: {}{}\n", d.index, d.name, d.software ? " (software)" : "");
    if (d.problem.empty())
      fmt::print("     {}, OpenGL {}\n", d.vendor, d.version);
    else
      fmt::print("     cannot be used: {}\n", d.problem);
  }
}

void printLimits() {
  const gl::Limits& l = gl::limits();
  fmt::print("Limits:\n");
  fmt::print("  one storage buffer      {} MiB\n", l.storageBlockBytes >> 20);
  fmt::print("  texels in a buffer view {}\n", l.texelBufferTexels);
  fmt::print("  picture and texture     {0}x{0}\n", l.textureSize);
  fmt::print("  samples per pixel       {}\n", l.samples);
  fmt::print("  work groups             {}\n", l.groupsX);
  fmt::print("  shared memory           {} KiB\n", l.sharedBytes >> 10);
  fmt::print("  anisotropy              {}\n", l.anisotropy);
}

void doctor(const std::string& device) {
  fmt::print("simreel {}\n", version());
  const auto assets = assetFolder();
  fmt::print("Assets: {}\n", assets.empty() ? "not found; set SIMREEL_ASSETS" : assets.string());
  printDevices(gl::listDevices());
  // Throws with the advice what to install where nothing can run.
  const gl::Context context({.device = device, .debug = false, .memoryPath = ""});
  fmt::print("Chosen: {}: {}, because {}\n", context.device().index, context.device().name,
             context.reason());
  fmt::print("Memory path: {}\n", gl::memoryPath() == gl::MemoryPath::texel
                                      ? "texel (software drivers load texels fastest)"
                                      : "storage (storage blocks and shared memory)");
  printLimits();
  const auto numerics = sim::probeNumerics();
  fmt::print("Exact numerics: {}\n",
             numerics.exactHolds ? "hold, bit for bit" : "BROKEN: " + numerics.firstFailure);
  fmt::print("Numerics fingerprint: {}\n", numerics.fingerprint);
  fmt::print("Drawing fingerprint: {}\n", draw::probePictures());
  fmt::print("Processor: {}\n", gl::machineOf(context).processor);
  const unsigned reached = sim::probeLoop();
  if (reached == sim::loopProbeRounds)
    fmt::print("Long loops: run to the end ({} iterations)\n", reached);
  else
    fmt::print("Long loops: end silently after {} of {} iterations; simreel splits its loops below that\n",
               reached, sim::loopProbeRounds);
  if (!numerics.exactHolds)
    fail(ExitCode::device,
         "this driver does not compute exactly ({}); use another one, or \"numerics\": \"fast\"",
         numerics.firstFailure);
}

}  // namespace

void addDoctor(CLI::App& app) {
  auto* command =
      app.add_subcommand("doctor", "Show devices, drivers and limits, and what is wrong with them");
  auto device = std::make_shared<std::string>();
  command->add_option("--device", *device, "Index or part of a name");
  command->callback([device] { doctor(*device); });
}

}  // namespace simreel::cli
