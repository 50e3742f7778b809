// simreel validate: checks scenes. simreel schema: prints the JSON Schema of scenes.
#include "base/error.hpp"
#include "base/log.hpp"
#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/options/device_options.hpp"
#include "cli/options/scene_options.hpp"
#include "cli/options/shipped_scene.hpp"
#include "draw/screen/renderer.hpp"
#include "frame/draw_world.hpp"
#include "frame/summaries.hpp"
#include "gl/context.hpp"
#include "scene/load.hpp"
#include "scene/texts/schema_text.hpp"
#include "sim/core/numerics.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

struct ValidateOptions {
  std::vector<std::string> files, overrides, assets;
  std::string device;  ///< device to validate on; empty if no device is used
  gl::ContextOptions on;
};

/// Makes the checks that need a device: compares the scene with the device's limits, and draws the first
/// frame.
void checkOnDevice(const scene::Scene& scene, const sim::Numerics& numerics) {
  sim::requireExact(scene, numerics);
  sim::World world(scene);
  draw::Renderer renderer(scene, scene.render.size, scene.render.samples);
  frame::drawWorld(renderer, world);
  frame::checkState(world);
}

/// Returns the errors of one scene. Returns an empty list if the scene is usable.
std::vector<UserError> problemsOf(const std::string& file, const ValidateOptions& o,
                                  const std::optional<sim::Numerics>& numerics) {
  std::vector<UserError> problems;
  try {
    const auto scene =  // loadTestScene() also reads the test settings in the sidecar.
        scene::loadTestScene(file, parseOverrides(o.overrides), sim::kinds(), assetFolders(o.assets));
    for (const std::string& remark : scene.remarks) warnLinesOnce(remark);
    problems = sim::findProblems(scene);
    if (problems.empty() && numerics) checkOnDevice(scene, *numerics);
    if (!numerics)
      for (const std::string& sentence : sim::tooLargeForMany(scene)) warn("{}: {}", file, sentence);
  } catch (const UserError& error) {
    problems.push_back(error);
  }
  return problems;
}

/// Prints an error after the scene's file name. A report is printed unchanged, because its lines already
/// contain the name.
void printProblem(const std::string& file, const UserError& error) {
  if (error.form() == UserError::Form::report)
    printError(error);
  else
    errorLine(file + ": error: " + error.what());
}

void validate(ValidateOptions o) {
  static_cast<void>(parseOverrides(o.overrides));
  static_cast<void>(assetFolders(o.assets));
  std::optional<gl::Context> context;
  std::optional<sim::Numerics> numerics;
  if (!o.device.empty()) {
    if (o.device != "true") o.on.device = o.device;
    context.emplace(o.on);
    numerics = sim::probeNumerics();
  }
  std::size_t bad = 0;
  ExitCode code = ExitCode::usage;
  for (const std::string& file : o.files) {
    const std::vector<UserError> problems = problemsOf(file, o, numerics);
    if (problems.empty()) {
      printText(oneLine(file) + ": ok\n");
      continue;
    }
    ++bad;
    std::fflush(stdout);
    for (const UserError& problem : problems) printProblem(file, problem);
    if (o.files.size() == 1)
      code = problems.front().code();  // Rendering the scene would return the same exit code.
  }
  if (bad > 0)
    fail(code, "{} of {} scene{} cannot be used", bad, o.files.size(), o.files.size() == 1 ? "" : "s");
}

}  // namespace

void addValidate(CLI::App& app) {
  auto o = std::make_shared<ValidateOptions>();
  auto* command = app.add_subcommand("validate", "Check scene files and report every mistake");
  findShipped(
      *command
           ->add_option("scenes", o->files, "Scene files, names of shipped scenes, or - for standard input")
           ->required());
  command->add_option("-D", o->overrides, "Override any value of the scenes; repeatable")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  addAssets(*command, o->assets);
  command->add_flag(
      "--device", o->device,
      "Also make each scene and draw its first frame on a device; =INDEX or =NAME chooses it");
  command->callback([o] { validate(*o); });
}

void addSchema(CLI::App& app) {
  app.add_subcommand("schema", "Print the JSON Schema of scene files")->callback([] {
    printText(scene::schemaText(sim::kinds().list));
  });
}

}  // namespace simreel::cli
