#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/processor.hpp"
#include "base/version.hpp"
#include "cli/commands.hpp"
#include "draw/screen/picture_probe.hpp"
#include "gl/context.hpp"
#include "gl/driver_environment.hpp"
#include "gl/limits.hpp"
#include "gl/machine.hpp"
#include "scene/scene.hpp"
#include "sim/core/numerics.hpp"
#include "sim/kernels/arithmetic.hpp"

#include <cstdlib>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

/// Formats and prints text as printText() does, because names of devices and folders may contain any bytes.
template <class... Args>
void print(fmt::format_string<Args...> format, Args&&... args) {
  printText(fmt::format(format, std::forward<Args>(args)...));
}

void printDevices(const std::vector<gl::DeviceInfo>& devices) {
  print("EGL devices: {}\n", devices.empty() ? "none" : std::to_string(devices.size()));
  for (const gl::DeviceInfo& d : devices) {
    print("  {}: {}{}\n", d.index, d.name, d.software ? " (software)" : "");
    if (d.problem.empty())
      print("     {}, OpenGL {}\n", d.vendor, d.version);
    else
      print("     cannot be used: {}\n", d.problem);
  }
}

void printLimits() {
  const gl::Limits& l = gl::limits();
  print("Limits:\n");
  print("  one storage buffer      {} MiB\n", l.storageBlockBytes >> 20);
  print("  texels in a buffer view {}\n", l.texelBufferTexels);
  print("  picture and texture     {0}x{0}\n", l.textureSize);
  print("  samples per pixel       {}\n", l.samples);
  print("  work groups             {}\n", l.groupsX);
  print("  shared memory           {} KiB\n", l.sharedBytes >> 10);
  print("  anisotropy              {}\n", l.anisotropy);
}

void printRasterizer() {
  const bool exact = scene::Render{}.rasterizer == scene::Rasterizer::exact;
  print("Rasterizer: {}, the default ({})\n", exact ? "exact" : "driver",
        exact ? "the same pixels on every machine; --rasterizer driver draws with this driver's own"
              : "edges and filters are this driver's; --rasterizer exact draws the same pixels everywhere");
}

void doctor(const std::string& device) {
  print("simreel {}\n", version());
  const auto assets = assetFolder();
  print("Assets: {}\n", assets.empty() ? "not found; set SIMREEL_ASSETS" : assets.string());
  if (const std::string variables = gl::driverVariables(); !variables.empty())
    print("Environment: {} selects another driver\n", variables);
  printDevices(gl::listDevices());
  // The constructor throws UserError with advice on what to install if no device works.
  const gl::Context context({.device = device, .debug = false, .memoryPath = ""});
  print("Chosen: {}: {}, because {}\n", context.device().index, context.device().name, context.reason());
  print("Memory path: {}\n", gl::memoryPath() == gl::MemoryPath::texel
                                 ? "texel (software drivers load texels fastest)"
                                 : "storage (storage blocks and shared memory)");
  printRasterizer();
  if (const char* threads = std::getenv("LP_NUM_THREADS"); threads != nullptr && gl::softwareDriver())
    print("Driver's threads: {} (LP_NUM_THREADS), {} processors\n", threads, processorCount());
  printLimits();
  const auto numerics = sim::probeNumerics();
  print("Exact numerics: {}\n",
        numerics.exactHolds ? "hold, bit for bit" : "BROKEN: " + numerics.firstFailure);
  print("Arithmetic of users' kernels: {}\n", sim::arithmeticText(sim::kernelArithmetic()));
  print("Numerics fingerprint: {}\n", numerics.fingerprint);
  print("Drawing fingerprint: {}\n", draw::probePictures());
  print("Processor: {}\n", gl::machineOf(context).processor);
  const unsigned reached = sim::probeLoop();
  if (reached == sim::loopProbeRounds)
    print("Long loops: run to the end ({} iterations)\n", reached);
  else
    print("Long loops: end silently after {} of {} iterations; simreel splits its loops below that\n",
          reached, sim::loopProbeRounds);
  if (!numerics.exactHolds)
    fail(ExitCode::device,
         "this driver does not compute exactly ({}); use another one, or \"numerics\": \"fast\"",
         numerics.firstFailure);
}

}  // namespace

void addDoctor(CLI::App& app) {
  auto* command = app.add_subcommand("doctor", "Show devices, drivers, limits and their problems");
  auto device = std::make_shared<std::string>();
  command->add_option("--device", *device, "Device to look at, by its number or a part of its name");
  command->callback([device] { doctor(*device); });
}

}  // namespace simreel::cli
