// simreel sweep SCENE --vary ...: writes a plan and runs its jobs.
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/isolated.hpp"
#include "base/log.hpp"
#include "base/version.hpp"
#include "batch/plan/shared_camera.hpp"
#include "batch/plan/shared_ranges.hpp"
#include "batch/plan/sweep_plan.hpp"
#include "batch/plan/vary.hpp"
#include "batch/sweep/sweep_job.hpp"
#include "cli/commands.hpp"
#include "cli/sweep/sweep_options.hpp"
#include "frame/file/field_file.hpp"
#include "scene/scene_source.hpp"
#include "sim/world/list.hpp"

#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

namespace fs = std::filesystem;

void checkOptions(const SweepOptions& o) {
  if (o.scene.file.empty())
    fail(ExitCode::usage, "sweep: give a scene: simreel sweep scene.json --vary path=a,b,c -o folder/");
  if (o.vary.empty()) fail(ExitCode::usage, "sweep: nothing varies; give at least one --vary path=a,b,c");
  if (o.output.empty()) fail(ExitCode::usage, "sweep: give a folder for its jobs: -o folder/");
  if (int{o.zip} + int{o.grid} + int{o.sample.has_value()} > 1)
    fail(ExitCode::usage, "--zip, --grid and --sample exclude each other");
  if (!o.fields.empty()) static_cast<void>(frame::parseFieldChoice(o.fields));
  if (o.scene.seed && !o.sample)
    fail(ExitCode::usage, "--seed is the seed of --sample here; set the scene's seed with -D seed={}",
         *o.scene.seed);
}

/// Simulates each job once to measure color ranges that are "auto", and gives all jobs the same ranges.
void shareRanges(batch::SweepPlan& plan, const std::string& text, const SweepOptions& o) {
  // The ranges are measured in a separate process, because jobs are later forked from the current process,
  // which must not have had a GL context by then.
  constexpr ProcessLimits unlimited{std::size_t{1} << 40, 1 << 30};
  std::string lines;
  try {
    lines = runIsolated(unlimited, [&] {
      const gl::Context context(o.run.on);
      std::string all;
      for (const scene::Override& one : batch::sharedRanges(plan, text))
        all += one.path + "=" + one.value + "\n";
      return all;
    });
  } catch (const UserError&) {
    throw;
  } catch (const std::runtime_error& error) {
    fail(ExitCode::device, "the first runs of the jobs, which measure the ranges of colours, {}",
         error.what());
  }
  std::vector<std::string> ranges;
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) {
    plan.overrides.push_back(scene::parseOverride(line));
    ranges.push_back(std::move(line));
  }
  if (ranges.empty()) return;
  batch::checkJobs(plan, text);
  info("simreel: first runs of {} jobs measured the ranges of colours; to keep them: {}", plan.jobs.size(),
       scene::asArguments(ranges));
}

batch::SweepPlan planOf(const SweepOptions& o, const std::string& text) {
  std::vector<batch::Vary> varied;
  for (const std::string& one : o.vary) varied.push_back(batch::parseVary(one));
  const auto how = o.zip      ? batch::Combination::zip
                   : o.sample ? batch::Combination::sample
                              : batch::Combination::grid;
  batch::SweepPlan plan;
  plan.folder = o.output;
  plan.program = version();
  if (o.scene.file != "-")
    plan.assets.push_back(fs::absolute(o.scene.file).lexically_normal().parent_path());
  for (const fs::path& folder : assetFolders(o.scene.assets))
    plan.assets.push_back(fs::absolute(folder).lexically_normal());
  SceneOptions scene = o.scene;
  scene.seed.reset();
  plan.overrides = scene.changes();
  plan.frames = o.frames;
  plan.fields = o.fields;
  for (const batch::Vary& one : varied) plan.varied.push_back(one.path);
  const auto seed = static_cast<std::uint64_t>(o.scene.seed.value_or(1));
  for (auto& values : batch::combine(varied, how, o.sample.value_or(0), seed))
    plan.jobs.push_back({std::move(values), {}});
  batch::checkJobs(plan, text);
  if (const std::vector<scene::Override> camera = batch::sharedCamera(plan, text); !camera.empty()) {
    plan.overrides.insert(plan.overrides.end(), camera.begin(), camera.end());
    batch::checkJobs(plan, text);  // The camera is part of the jobs' hashes, so the hashes are computed
                                   // again.
  }
  if (batch::hasAutoRanges(plan, text)) shareRanges(plan, text, o);
  return plan;
}

/// Writes the plan and the scene into the folder. If the folder already contains a plan, the two plans must
/// be equal unless `overwrite` is set.
void store(const batch::SweepPlan& plan, const std::string& scene, bool overwrite) {
  const std::string text = planText(plan);
  if (pathExists(plan.planFile())) {
    const bool same = readFile(plan.planFile(), "plan") == text && pathExists(plan.sceneFile()) &&
                      readFile(plan.sceneFile(), "scene") == scene;
    if (same) return;
    if (!overwrite)
      fail(ExitCode::inputOutput, "{} belongs to another sweep; use --overwrite, or another folder",
           plan.planFile().string());
    std::optional<batch::SweepPlan> old;
    try {
      old = batch::readSweepPlan(plan.folder);
    } catch (const UserError&) {  // NOLINT(bugprone-empty-catch): what it had made is not known then.
    }
    if (old) batch::removeOthers(*old, plan);
  }
  makeFolders(plan.folder);
  writeFileAtomically(plan.sceneFile(), scene);
  writeFileAtomically(plan.planFile(), text);
}

void sweep(const SweepOptions& o) {
  checkOptions(o);
  const std::string text = scene::readSceneSource(o.scene.file, sim::kinds()).first;
  const batch::SweepPlan plan = planOf(o, text);
  makeFolders(plan.folder);
  const frame::OutputLock lock = lockSweep(plan, planText(plan) + text);
  store(plan, text, o.overwrite);
  if (o.planOnly) {
    info("{} job{} -> {}", plan.jobs.size(), plan.jobs.size() == 1 ? "" : "s", plan.planFile().string());
    return;
  }
  std::vector<std::size_t> all(plan.jobs.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  runSweep(plan, all, o.run);
}

}  // namespace

void addSweep(CLI::App& app) {
  auto o = std::make_shared<SweepOptions>();
  auto* command = app.add_subcommand("sweep", "Render a scene with many values of its parameters");
  command->require_subcommand(0, 1);
  o->scene.addOptional(*command);
  command
      ->add_option("--vary", o->vary,
                   "A parameter and its values: path=a,b,c or path=first:last:step; repeatable")
      ->allow_extra_args(false);
  command->add_option("-o,--output", o->output, "Folder for the plan and a folder of each job");
  command->add_flag("--grid", o->grid, "Combine each value with every other (default)");
  command->add_flag("--zip", o->zip, "Combine the first values, then the second ones, and so on");
  command
      ->add_option("--sample", o->sample,
                   "Number of jobs with values drawn at random (by --seed) from the lists, and from ranges "
                   "path=low:high")
      ->check(CLI::Range(std::size_t{1}, batch::maxJobs));
  command->add_option("--frames", o->frames, "Frames of each job, for example 0-99x2,150");
  command
      ->add_option(
          "--fields", o->fields,
          "Also write the raw values of fields: of all, as npy or pfm, or of those that are named: "
          "NAME,... or pfm,NAME,...")
      ->type_name("{npy,pfm,NAME}");
  auto* planOnly = command->add_flag(
      "--plan-only", o->planOnly,
      "Only write plan.json; `simreel sweep job FOLDER NUMBER` runs its jobs on any machine");
  command->add_flag("--overwrite", o->overwrite, "Replace another sweep in the folder");
  o->run.add(*command);
  for (const char* name : {"--jobs", "--progress", "--slurm", "--scratch"})
    command->get_option(name)->excludes(planOnly);
  addSweepFollowers(*command);
  command->callback([o, command] {
    if (command->get_subcommands().empty()) sweep(*o);
  });
}

}  // namespace simreel::cli
