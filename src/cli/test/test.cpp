#include "base/clock.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "cli/commands.hpp"
#include "cli/device_options.hpp"
#include "cli/scene_options.hpp"
#include "cli/test/test_options.hpp"
#include "draw/screen/picture_probe.hpp"
#include "frame/interrupt.hpp"
#include "gl/context.hpp"
#include "gl/machine.hpp"
#include "golden/baseline/profile.hpp"
#include "golden/baseline/stale.hpp"
#include "golden/suite/suite.hpp"
#include "sim/core/numerics.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

namespace fs = std::filesystem;

/// A profile is a folder beside the scenes.
void checkProfile(const std::string& name) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyz0123456789-";
  if (name.find_first_not_of(plain) != std::string::npos || name.size() > 64)
    fail(ExitCode::usage, "--profile takes a name of small letters, digits and '-', not \"{}\"", name);
}

golden::Device describeDevice(const gl::Context& context, const std::string& profile) {
  const auto numerics = sim::probeNumerics();
  const auto machine = gl::machineOf(context);
  golden::Device device;
  device.origin = {numerics.fingerprint, draw::probePictures(), machine.processor, machine.driver};
  device.profile = profile.empty() ? golden::ownProfile(context.device().name) : profile;
  device.memoryPath = gl::memoryPath() == gl::MemoryPath::texel ? "texel" : "storage";
  if (!numerics.exactHolds) device.inexact = numerics.firstFailure;
  return device;
}

std::vector<golden::SceneFile> chosenScenes(const TestOptions& o) {
  const std::vector<std::string> here = {"."};
  const auto all = golden::findScenes(o.paths.empty() ? here : o.paths);
  auto chosen = golden::filtered(all, o.globs);
  if (!o.shard.empty()) chosen = golden::shardOf(chosen, o.shard);
  if (chosen.empty())
    fail(ExitCode::nothingRan, "no scene to test: {} found, {} of them match --filter and --shard",
         all.size(), chosen.size());
  return chosen;
}

/// Runs the scenes, printing each as it ends. Returns the signal that interrupted, or 0.
int runAll(const std::vector<golden::SceneFile>& scenes, golden::Suite& suite, const TestOutputs& outputs,
           golden::SuiteResult& result) {
  for (const golden::SceneFile& scene : scenes) {
    try {
      result.scenes.push_back(suite.test(scene));
    } catch (const frame::Interrupted& interrupted) {
      return interrupted.signal;
    }
    outputs.show(result.scenes.back(), result.unit);
  }
  return 0;
}

/// Those that no scene took over.
void addOrphans(const golden::SuiteOptions& options, golden::SuiteResult& result) {
  for (const fs::path& folder : options.orphans) {
    if (!pathExists(folder)) continue;
    const auto heir = std::find_if(
        result.scenes.begin(), result.scenes.end(),
        [&](const golden::SceneResult& scene) { return scene.renamedFrom == folder.generic_string(); });
    golden::Stale stale{folder.generic_string(), "its scene is gone", false};
    if (heir != result.scenes.end())
      stale.message = fmt::format(
          "its scene is gone; the pictures are those of {}: --update moves it there", heir->name);
    else if (options.update == golden::Update::prune && !(stale.removed = golden::removeBaselines(folder)))
      stale.message = "its scene is gone; what is no baseline was left there";
    result.stale.push_back(std::move(stale));
  }
}

void test(const TestOptions& o) {
  if (o.outputs.github) avoidWorkflowCommands();
  const bool pictures = !o.expected.empty() || !o.actual.empty() || !o.run.empty() || !o.rules.empty();
  if (pictures) return testPictures(o);
  if (o.allowance.ignoreAntialiased || o.allowance.searchRadius || !o.allowance.mask.empty())
    fail(
        ExitCode::usage,
        "--ignore-antialiased, --search-radius and --mask are for pictures (--expected); scenes are exact");
  checkProfile(o.profile);
  golden::SuiteOptions options;
  options.repeats = o.repeat;
  options.retries = o.retries;
  options.allowFlaky = o.allowFlaky;
  options.update = o.updateMode();
  options.reason = o.reason;
  options.profile = o.profile;
  options.tolerance = o.tolerance.given();
  options.assets = assetFolders(o.assets);
  options.reportFolder = o.outputs.folder();
  options.artifacts = o.outputs.artifacts();
  const auto scenes = chosenScenes(o);
  if (o.list) {
    for (const golden::SceneFile& scene : scenes)
      printText(oneLine(scene.name) + "\t" + oneLine(scene.file.string()) + "\n");
    return;
  }
  o.outputs.prepare();
  frame::catchInterrupts();
  frame::ignoreBrokenPipes();
  const Clock::time_point begin = Clock::now();
  const gl::Context context(o.on);
  const golden::Device device = describeDevice(context, o.profile);

  options.orphans =
      golden::baselinesWithoutScene(o.paths.empty() ? std::vector<std::string>{"."} : o.paths);
  golden::Suite suite(options, device);
  golden::SuiteResult result;
  result.version = version();
  result.driver = device.origin.driver;
  result.processor = device.origin.processor;
  result.profile = device.profile;
  result.fingerprint = device.origin.numerics;
  result.drawing = device.origin.drawing;
  result.memoryPath = device.memoryPath;
  result.command = o.command;
  result.allowFlaky = o.allowFlaky;
  const int signal = runAll(scenes, suite, o.outputs, result);
  result.strict = o.strict;
  result.stale = suite.stale();
  addOrphans(options, result);
  if (o.strict &&
      std::any_of(result.stale.begin(), result.stale.end(), [](const auto& one) { return !one.removed; }))
    suite.tally().addFailure();
  result.seconds = secondsSince(begin);
  o.outputs.write(result);
  if (signal != 0) info("simreel: interrupted after {} of {} scenes", result.scenes.size(), scenes.size());
  setExitCode(signal != 0 ? 128 + signal : static_cast<int>(suite.tally().exitCode()));
}

void addPictures(CLI::App& command, TestOptions& o) {
  command.add_option("--expected", o.expected,
                     "Test pictures instead of scenes: the folder of their baselines");
  command.add_option("--actual", o.actual, "The folder of the pictures, with all below it");
  command.add_option(
      "--run", o.run,
      "Make the pictures first, by this command for each scene: 'renderer {scene} -o {output}'; "
      "without {scene} once, and {output} is the folder");
  command.add_option("--rules", o.rules,
                     "JSON: tolerances, masks and expected failures of pictures by name or folder");
  o.allowance.add(command);
}

}  // namespace

golden::Update TestOptions::updateMode() const {
  if (!updateGiven) {
    if (!reason.empty()) fail(ExitCode::usage, "--reason is kept in baselines; give it with --update");
    return golden::Update::none;
  }
  return update == "missing"   ? golden::Update::missing
         : update == "changed" ? golden::Update::changed
         : update == "prune"   ? golden::Update::prune
                               : golden::Update::all;
}

void addTest(CLI::App& app) {
  auto o = std::make_shared<TestOptions>();
  auto* command = app.add_subcommand("test", "Compare scenes with their baselines");
  command->add_option("scenes", o->paths, "Scenes and folders of scenes (default: this folder)");
  command->add_option("--filter", o->globs, "Only scenes whose name or path matches, repeatable")
      ->allow_extra_args(false);
  command->add_option("--shard", o->shard, "Only the k-th of n parts, for example 2/4");
  command->add_option("--repeat", o->repeat, "Runs of each scene, which have to agree")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--retries", o->retries, "Further tries of a scene that fails; passing then is flaky")
      ->check(CLI::Range(0, 100));
  command->add_flag("--allow-flaky", o->allowFlaky, "Flaky scenes do not fail the run");
  o->outputs.add(*command);
  command
      ->add_option_function<std::string>(
          "--update",
          [o](const std::string& mode) {
            o->updateGiven = true;
            o->update = mode;
          },
          "Write baselines that are missing, changed or (default) both; prune: remove those that nothing "
          "is tested against")
      ->expected(0, 1)
      ->default_str("all")
      ->check(CLI::IsMember({"missing", "changed", "all", "prune"}));
  command->add_option("--reason", o->reason, "Why, kept in the baselines that are written");
  command->add_option("--profile", o->profile, "Name of the numerics family (default: by driver)");
  addAssets(*command, o->assets);
  addDevice(*command, o->on);
  command->add_flag("--debug", o->on.debug, "Ask the driver for debug messages; serious ones are errors");
  command->add_flag("--list", o->list, "Only print the scenes that would be tested");
  command->add_flag("--strict", o->strict, "Baselines that nothing is tested against fail the run, too");
  addPictures(*command, *o);
  o->tolerance.add(*command);
  command->callback([o] {
    o->command = commandLine();
    test(*o);
  });
}

}  // namespace simreel::cli
