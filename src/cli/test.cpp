#include "base/clock.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "cli/commands.hpp"
#include "cli/device_options.hpp"
#include "cli/scene_options.hpp"
#include "cli/tolerance_options.hpp"
#include "draw/screen/picture_probe.hpp"
#include "frame/interrupt.hpp"
#include "gl/context.hpp"
#include "gl/machine.hpp"
#include "golden/baseline/profile.hpp"
#include "golden/report/github.hpp"
#include "golden/report/html.hpp"
#include "golden/report/json.hpp"
#include "golden/report/junit.hpp"
#include "golden/report/text.hpp"
#include "golden/suite/suite.hpp"
#include "sim/core/numerics.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <unistd.h>
#include <vector>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

namespace fs = std::filesystem;

struct TestOptions {
  std::vector<std::string> paths;
  std::vector<std::string> globs;
  std::vector<std::string> assets;
  std::string shard;
  int repeat = 2;
  int retries = 0;
  bool allowFlaky = false;
  std::string report, junit, json;
  bool github = false;
  std::string update;
  bool updateGiven = false;
  std::string reason, profile;
  gl::ContextOptions on;
  bool list = false;
  ToleranceOptions tolerance;
  std::string command;  ///< as typed
};

golden::Update updateMode(const TestOptions& o) {
  if (!o.updateGiven) {
    if (!o.reason.empty()) fail(ExitCode::usage, "--reason is kept in baselines; give it with --update");
    return golden::Update::none;
  }
  return o.update == "missing"   ? golden::Update::missing
         : o.update == "changed" ? golden::Update::changed
                                 : golden::Update::all;
}

/// A profile is a folder beside the scenes.
void checkProfile(const std::string& name) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyz0123456789-";
  if (name.find_first_not_of(plain) != std::string::npos || name.size() > 64)
    fail(ExitCode::usage, "--profile takes a name of small letters, digits and '-', not \"{}\"", name);
}

/// Where failures' pictures go: <report>/files, or beside the JSON report.
void choosePlaces(const TestOptions& o, golden::SuiteOptions& suite) {
  if (!o.report.empty()) {
    suite.reportFolder = o.report;
    suite.artifacts = suite.reportFolder / "files";
  } else if (!o.json.empty()) {
    suite.reportFolder = fs::path(o.json).parent_path();
    suite.artifacts = fs::path(o.json).replace_extension().string() + "-files";
  }
}

/// An earlier report is replaced; anything else is not ours to touch.
void prepareReport(const fs::path& folder, const fs::path& artifacts) {
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error))
    fail(ExitCode::usage, "--report takes a folder, and {} is a file", folder.string());
  if (fs::exists(folder, error) && !fs::is_empty(folder, error) &&
      !fs::exists(folder / "report.json", error))
    fail(ExitCode::usage, "the folder {} is not empty and holds no report; give --report another one",
         folder.string());
  fs::remove_all(artifacts, error);
  makeFolders(folder);
}

/// What accept reads is inside the report's folder; a JSON report elsewhere points nowhere.
golden::SuiteResult forElsewhere(golden::SuiteResult suite) {
  for (golden::SceneResult& scene : suite.scenes) {
    scene.candidate.clear();
    for (golden::FrameResult& frame : scene.frames)
      for (std::string* path : {&frame.expectedImage, &frame.actualImage, &frame.differenceImage})
        path->clear();
  }
  return suite;
}

void writeGithub(const golden::SuiteResult& suite) {
  // The one text that is made of commands.
  const std::string commands = golden::githubAnnotations(suite);
  static_cast<void>(std::fwrite(commands.data(), 1, commands.size(), stdout));
  // NOLINTNEXTLINE(concurrency-mt-unsafe): the environment is only read.
  const char* place = std::getenv("GITHUB_STEP_SUMMARY");
  if (place == nullptr || *place == '\0') return;
  // Earlier steps of the job may have written there.
  std::FILE* file = std::fopen(place, "a");
  const std::string text = golden::githubSummary(suite);
  const bool written = file != nullptr && std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if ((file != nullptr && std::fclose(file) != 0) || !written)
    fail(ExitCode::inputOutput, "cannot write the job summary to {}", place);
}

void writeReports(const TestOptions& o, const golden::SuiteResult& suite) {
  if (!o.report.empty()) {
    writeFileAtomically(fs::path(o.report) / "report.json", golden::reportText(suite));
    golden::writeHtmlReport(o.report, suite);
  }
  if (!o.json.empty()) {
    const bool elsewhere = !o.report.empty();
    writeFileAtomically(o.json, golden::reportText(elsewhere ? forElsewhere(suite) : suite));
  }
  if (!o.junit.empty()) writeFileAtomically(o.junit, golden::junitText(suite));
  if (o.github) writeGithub(suite);
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

bool colored() {
  return ::isatty(STDOUT_FILENO) == 1;
}

/// Runs the scenes, printing each as it ends. Returns the signal that interrupted, or 0.
int runAll(const std::vector<golden::SceneFile>& scenes, golden::Suite& suite, const fs::path& reportFolder,
           golden::SuiteResult& result) {
  for (const golden::SceneFile& scene : scenes) {
    try {
      result.scenes.push_back(suite.test(scene));
    } catch (const frame::Interrupted& interrupted) {
      return interrupted.signal;
    }
    if (verbosity() != Verbosity::quiet) {
      printPainted(golden::sceneLine(result.scenes.back(), colored(), reportFolder));
      std::fflush(stdout);
    }
  }
  return 0;
}

void test(const TestOptions& o) {
  if (o.github) avoidWorkflowCommands();
  checkProfile(o.profile);
  golden::SuiteOptions options;
  options.repeats = o.repeat;
  options.retries = o.retries;
  options.allowFlaky = o.allowFlaky;
  options.update = updateMode(o);
  options.reason = o.reason;
  options.profile = o.profile;
  options.tolerance = o.tolerance.given();
  options.assets = assetFolders(o.assets);
  choosePlaces(o, options);
  const auto scenes = chosenScenes(o);
  if (o.list) {
    for (const golden::SceneFile& scene : scenes)
      printText(oneLine(scene.name) + "\t" + oneLine(scene.file.string()) + "\n");
    return;
  }
  if (!o.report.empty()) prepareReport(o.report, options.artifacts);
  frame::catchInterrupts();
  frame::ignoreBrokenPipes();
  const Clock::time_point begin = Clock::now();
  const gl::Context context(o.on);
  const golden::Device device = describeDevice(context, o.profile);

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
  const int signal = runAll(scenes, suite, options.reportFolder, result);
  result.seconds = secondsSince(begin);
  const std::string reportFile = !o.report.empty() ? (fs::path(o.report) / "report.json").string() : o.json;
  for (const golden::SceneResult& scene : result.scenes)
    if (!scene.candidate.empty()) result.acceptCommand = "simreel accept " + reportFile;
  writeReports(o, result);
  if (verbosity() != Verbosity::quiet) printPainted(golden::closingText(result, colored(), o.report));
  if (signal != 0) info("simreel: interrupted after {} of {} scenes", result.scenes.size(), scenes.size());
  setExitCode(signal != 0 ? 128 + signal : static_cast<int>(suite.exitCode()));
}

void addOutputs(CLI::App& command, TestOptions& o) {
  command.add_option("--report", o.report, "Folder for the HTML report, its pictures and report.json");
  command.add_option("--junit", o.junit, "JUnit XML file");
  command.add_option("--json", o.json, "JSON report; without --report, pictures of failures go beside it");
  command.add_flag("--github", o.github, "Print annotations and write the job summary of GitHub Actions");
}

}  // namespace

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
  addOutputs(*command, *o);
  command
      ->add_option_function<std::string>(
          "--update",
          [o](const std::string& mode) {
            o->updateGiven = true;
            o->update = mode;
          },
          "Write baselines that are missing, changed or (default) both")
      ->expected(0, 1)
      ->default_str("all")
      ->check(CLI::IsMember({"missing", "changed", "all"}));
  command->add_option("--reason", o->reason, "Why, kept in the baselines that are written");
  command->add_option("--profile", o->profile, "Name of the numerics family (default: by driver)");
  addAssets(*command, o->assets);
  addDevice(*command, o->on);
  command->add_flag("--debug", o->on.debug, "Ask the driver for debug messages; serious ones are errors");
  command->add_flag("--list", o->list, "Only print the scenes that would be tested");
  o->tolerance.add(*command);
  command->callback([o] {
    o->command = commandLine();
    test(*o);
  });
}

}  // namespace simreel::cli
