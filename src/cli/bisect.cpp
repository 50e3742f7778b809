// `simreel bisect`: where two builds or two drivers first compute something else.
#include "golden/bisect.hpp"

#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/scene_options.hpp"
#include "gl/context.hpp"
#include "sim/world.hpp"

#include <bit>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace simreel::cli {

namespace {

struct BisectOptions {
  SceneOptions scene;
  std::string device, memoryPath;
  std::string against, againstDevice, againstMemoryPath;
  std::optional<int> last;
  bool json = false;
};

std::string withScene(const std::string& program, const BisectOptions& o, const std::string& device,
                      const std::string& memoryPath) {
  std::string command = program + " trace " + inShellQuotes(o.scene.file);
  for (const std::string& change : o.scene.overrides) command += " -D " + inShellQuotes(change);
  if (o.scene.seed) command += fmt::format(" --seed {}", *o.scene.seed);
  if (o.scene.fps) command += fmt::format(" --fps {}", *o.scene.fps);
  if (!device.empty()) command += " --device " + inShellQuotes(device);
  if (!memoryPath.empty()) command += " --memory-path " + inShellQuotes(memoryPath);
  return command;
}

const char* componentName(int component) {
  constexpr const char* names[] = {"x", "y", "z", "w"};
  return names[component];
}

void print(const golden::Bisection& found, const std::string& elementName) {
  for (int side = 0; side < 2; ++side)
    fmt::print("{}: simreel {}, {}\n", side == 0 ? "here " : "there", found.versions[side],
               found.drivers[side]);
  if (!found.difference) {
    fmt::print("the same state, bit for bit, over {} frames\n", found.frames);
    return;
  }
  const golden::Difference& d = *found.difference;
  if (d.step == 0)
    fmt::print("they differ in the state they start from: {}.{}, {}\n", d.object, d.array, elementName);
  else
    fmt::print("they first differ at frame {}, step {} of {}: {}.{}, {}\n", d.frame, d.step, d.steps,
               d.object, d.array, elementName);
  for (int side = 0; side < 2; ++side)
    fmt::print("  {} {} = {:.9g} (0x{:08x})\n", side == 0 ? "here " : "there", componentName(d.component),
               std::bit_cast<float>(d.words[side]), d.words[side]);
  fmt::print("  {} element{} of the array differ there, by at most {} ulp\n", d.elementsThatDiffer,
             d.elementsThatDiffer == 1 ? "" : "s", d.mostUlp);
}

void printJson(const golden::Bisection& found) {
  nlohmann::ordered_json json = {{"here", {{"simreel", found.versions[0]}, {"driver", found.drivers[0]}}},
                                 {"there", {{"simreel", found.versions[1]}, {"driver", found.drivers[1]}}},
                                 {"frames", found.frames},
                                 {"difference", nullptr}};
  if (found.difference) {
    const golden::Difference& d = *found.difference;
    json["difference"] = {
        {"frame", d.frame},
        {"step", d.step},
        {"steps", d.steps},
        {"object", d.object},
        {"array", d.array},
        {"element", d.element},
        {"component", componentName(d.component)},
        {"bits", {fmt::format("0x{:08x}", d.words[0]), fmt::format("0x{:08x}", d.words[1])}},
        {"elementsThatDiffer", d.elementsThatDiffer},
        {"mostUlp", d.mostUlp}};
  }
  fmt::print("{}\n", json.dump(2));
}

/// As the simulation calls it, which takes a device: this one is started when the sides have ended.
std::string elementName(const scene::Scene& scene, const golden::Difference& difference,
                        const BisectOptions& o) {
  const gl::Context context({.device = o.device, .debug = false, .memoryPath = o.memoryPath});
  const sim::World world(scene);
  for (std::size_t i = 0; i < world.objectCount(); ++i)
    if (world.objectName(i) == difference.object) return world.object(i).elementName(difference.element);
  return fmt::format("element {}", difference.element);
}

void bisect(const BisectOptions& o) {
  const scene::Scene scene = o.scene.load();  // a mistake in the scene is told once
  const std::string self = inShellQuotes(std::filesystem::read_symlink("/proc/self/exe").string());
  const golden::Side sides[2] = {
      {withScene(self, o, o.device, o.memoryPath)},
      {withScene(o.against.empty() ? self : o.against, o,
                 o.againstDevice.empty() ? o.device : o.againstDevice,
                 o.againstMemoryPath.empty() ? o.memoryPath : o.againstMemoryPath)}};
  const auto found = golden::bisect(sides, o.last);
  if (o.json) {
    printJson(found);
  } else {
    print(found, found.difference ? elementName(scene, *found.difference, o) : "");
  }
  if (found.difference) setExitCode(static_cast<int>(ExitCode::different));
}

}  // namespace

void addBisect(CLI::App& app) {
  auto o = std::make_shared<BisectOptions>();
  auto* command =
      app.add_subcommand("bisect", "Find the step and element at which two builds or drivers differ");
  o->scene.add(*command);
  command->add_option("--device", o->device, "Index or part of a name (see `simreel doctor`)");
  command->add_option("--memory-path", o->memoryPath, "storage or texel");
  command->add_option(
      "--against", o->against,
      "Command of the other build, for example ./old/simreel or \"ssh box simreel\" (default: this one)");
  command->add_option("--against-device", o->againstDevice, "Device of the other side");
  command->add_option("--against-memory-path", o->againstMemoryPath, "Memory path of the other side");
  command->add_option("--last", o->last, "Last frame (default: the scene's)")
      ->check(CLI::Range(0, 10'000'000));
  command->add_flag("--json", o->json, "Print one JSON object instead of text");
  command->footer(
      "Without --against... the program is compared with itself: a test of determinism.\n"
      "Exit code: 0 the same state, 1 different, 2 usage, 4 or 6 a side failed.");
  command->callback([o] { bisect(*o); });
}

}  // namespace simreel::cli
