// simreel bisect: finds the first point of a run at which two builds or two drivers differ.
#include "base/error.hpp"
#include "base/log.hpp"
#include "base/process.hpp"
#include "batch/render/chosen_frames.hpp"
#include "cli/commands.hpp"
#include "cli/compare/bisect_report.hpp"
#include "cli/options/device_options.hpp"
#include "cli/options/scene_options.hpp"
#include "frame/frames_spec.hpp"
#include "frame/interrupt.hpp"
#include "gl/context.hpp"
#include "sim/world/world.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

struct BisectOptions {
  SceneOptions scene;
  gl::ContextOptions on;
  std::optional<std::string> against, againstDevice, againstMemoryPath;
  std::optional<int> frames;
  bool passes = false;
  bool json = false;
};

std::string ownCommand() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) fail(ExitCode::inputOutput, "cannot find this program: /proc/self/exe: {}", error.message());
  return inShellQuotes(program.string());
}

golden::BisectSide side(const char* name, const std::string& command, const BisectOptions& o,
                        const std::string& device, const std::string& memoryPath) {
  golden::BisectSide result{name, command, o.scene.arguments()};
  if (!device.empty()) result.arguments.push_back("--device=" + device);
  if (!memoryPath.empty()) result.arguments.push_back("--memory-path=" + memoryPath);
  return result;
}

/// Returns the simulation's name for an element, such as "particle (12, 30)". Creates a context, because
/// the contexts of the child processes no longer exist.
std::string elementName(const BisectOptions& o, const scene::Scene& scene, const std::string& object,
                        long element) {
  const gl::Context context(o.on);
  const sim::World world(scene);
  return golden::elementName(world, object, element);
}

int lastFrame(const BisectOptions& o, const scene::Scene& scene) {
  if (!o.frames) return scene.frameCount() - 1;
  if (*o.frames < 1 || *o.frames > frame::largestFrame)
    fail(ExitCode::usage, "--frames takes how many frames to compare, at least 1, not {}", *o.frames);
  return *o.frames - 1;
}

void bisect(const BisectOptions& o) {
  if (o.against && o.against->find_first_not_of(" \t\n") == std::string::npos)
    fail(ExitCode::usage,
         "--against is empty, so there is nothing to compare with; give the command of the other simreel, "
         "for example --against ./old/simreel");
  if (o.scene.file == "-")
    fail(ExitCode::usage,
         "bisect reads the scene several times, but standard input can be read only once; give a file");
  const scene::Scene scene = o.scene.load();
  const int last = lastFrame(o, scene);
  batch::warnBeyondEnd(last, scene);
  const std::string own = ownCommand();
  const auto here = side("this side", own, o, o.on.device, o.on.memoryPath);
  const auto there =
      side("the other side", o.against.value_or(own), o, o.againstDevice.value_or(o.on.device),
           o.againstMemoryPath.value_or(o.on.memoryPath));
  if (!o.against && !o.againstDevice && !o.againstMemoryPath)
    info(
        "simreel: comparing this program with itself on the same device, which shows whether it repeats; "
        "--against, --against-device or --against-memory-path name another side");
  frame::catchInterrupts();
  frame::ignoreBrokenPipes();
  try {
    BisectReport report{golden::bisect(here, there, last, o.passes), here.command, there.command, {}};
    const auto& difference = report.result.difference;
    if (difference && !difference->arrays.empty()) {
      const golden::DifferentArray& first = difference->arrays.front();
      report.element = elementName(o, scene, first.object, static_cast<long>(first.difference.first));
    }
    printText(o.json ? bisectJson(report) : bisectText(report));
    if (difference || report.result.pass) setExitCode(static_cast<int>(ExitCode::different));
  } catch (const frame::Interrupted& interrupted) {
    info("simreel: interrupted");
    setExitCode(128 + interrupted.signal);
  }
}

}  // namespace

void addBisect(CLI::App& app) {
  auto o = std::make_shared<BisectOptions>();
  auto* command = app.add_subcommand(
      "bisect",
      "Find where two builds or drivers first differ: frame, step and element, or pass and pixel");
  o->scene.add(*command);
  command->add_option(
      "--against", o->against,
      "Command of the other simreel: ./old/simreel, \"env A=1 simreel\", \"ssh box simreel\"");
  command->add_option("--against-device", o->againstDevice, "Device of the other side (default: the same)");
  command->add_option("--against-memory-path", o->againstMemoryPath,
                      "Memory path of the other side (default: the same)");
  command->add_option("--frames", o->frames,
                      "How many frames to compare (default: all), beside the pre-roll");
  command->add_flag(
      "--passes", o->passes,
      "Compare the exact pictures, too: find the first pass that differs, and the pixel and primitive");
  addDevice(*command, o->on);
  command->add_flag("--json", o->json, "Print the result as JSON");
  command->callback([o] { bisect(*o); });
}

}  // namespace simreel::cli
