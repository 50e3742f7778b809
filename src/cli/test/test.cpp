#include "base/error.hpp"
#include "base/log.hpp"
#include "cli/commands.hpp"
#include "cli/options/device_options.hpp"
#include "cli/options/scene_options.hpp"
#include "cli/test/test_options.hpp"

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

void test(const TestOptions& o) {
  if (o.outputs.github) avoidWorkflowCommands();
  const bool pictures = !o.expected.empty() || !o.actual.empty() || !o.run.empty() || !o.rules.empty();
  if (pictures) return testPictures(o);
  testScenes(o);
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
  for (const char* name : {"--repeat", "--device", "--memory-path", "--debug", "--assets"})
    command.get_option(name)->excludes(command.get_option("--expected"));
}

}  // namespace

golden::Measures TestOptions::measures() const {
  if (!quick) return golden::Measures::all;
  if (tolerance.given().contains("maxFlipMean"))
    fail(ExitCode::usage,
         "--max-flip-mean is a bound on FLIP, which --quick does not measure; give one of them");
  return golden::Measures::quick;
}

golden::Update TestOptions::updateMode() const {
  if (!updateGiven) {
    if (!reason.empty()) fail(ExitCode::usage, "--reason is stored in baselines, so it needs --update");
    return golden::Update::none;
  }
  if (!reason.empty() && update == "prune")
    fail(ExitCode::usage, "--reason has no effect with --update=prune, which writes no baselines");
  return update == "missing"   ? golden::Update::missing
         : update == "changed" ? golden::Update::changed
         : update == "prune"   ? golden::Update::prune
                               : golden::Update::all;
}

void addTest(CLI::App& app) {
  auto o = std::make_shared<TestOptions>();
  auto* command = app.add_subcommand("test", "Compare scenes with their baselines");
  command->add_option("scenes", o->paths, "Scenes and folders of scenes (default: this folder)");
  command
      ->add_option("--filter", o->globs, "Only scenes whose name or path matches this pattern; repeatable")
      ->allow_extra_args(false);
  command->add_option("--shard", o->shard, "Only the k-th of n parts, for example 2/4");
  command
      ->add_option("-j,--jobs", o->jobs,
                   "Scenes (or commands of --run) at once, each in its own process with an equal share of "
                   "the processors; auto: one for each processor")
      ->capture_default_str();
  command->add_option("--repeat", o->repeat, "Runs of each scene, which must agree")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command
      ->add_option(
          "--retries", o->retries,
          "Further tries of a scene that fails, or whose process or command (--run) fails; a scene "
          "that passes then counts as flaky")
      ->check(CLI::Range(0, 100));
  command
      ->add_option("--timeout", o->timeout,
                   "Most seconds that a process, or a command of --run, may take for a scene; after that "
                   "it is ended, and the scene counts as an error (default: no limit)")
      ->check(CLI::Range(0.1, 1e6));
  command->add_flag(
      "--quick", o->quick,
      "Do not measure SSIM and FLIP, which take most of the time, unless there is a bound on them");
  command->add_flag("--allow-flaky", o->allowFlaky, "Flaky scenes do not fail the run");
  o->outputs.add(*command);
  command
      ->add_option_function<std::string>(
          "--update",
          [o](const std::string& mode) {
            o->updateGiven = true;
            o->update = mode;
          },
          "Write baselines that are missing, changed or (default) both; prune: remove baselines that no "
          "scene or picture is tested against")
      ->expected(0, 1)
      ->default_str("all")
      ->check(CLI::IsMember({"missing", "changed", "all", "prune"}));
  command->add_option("--reason", o->reason, "Reason, which the written baselines keep");
  command->add_option("--profile", o->profile, "Name of the numerics family (default: by driver)");
  addAssets(*command, o->assets);
  addDevices(*command, o->on);
  command->add_flag("--debug", o->on.debug, "Ask the driver for debug messages; serious ones are errors");
  command->add_flag("--list", o->list, "Print the scenes that would be tested, and do nothing");
  command->add_flag("--strict", o->strict,
                    "Baselines that no scene or picture is tested against fail the run, too");
  addPictures(*command, *o);
  o->tolerance.add(*command);
  command->callback([o] {
    o->command = commandLine();
    test(*o);
  });
}

}  // namespace simreel::cli
