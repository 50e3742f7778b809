// simreel sweep status, retry, collect and job: subcommands that work on an existing plan of a sweep. A
// cluster runs `job`.
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/log.hpp"
#include "base/text.hpp"
#include "batch/collect/contact_sheet.hpp"
#include "batch/collect/sweep_page.hpp"
#include "batch/collect/sweep_tables.hpp"
#include "batch/plan/sweep_plan.hpp"
#include "batch/render/scratch.hpp"
#include "batch/slurm/queue.hpp"
#include "batch/sweep/sweep_job.hpp"
#include "batch/sweep/sweep_run.hpp"
#include "cli/commands.hpp"
#include "cli/options/device_options.hpp"
#include "cli/options/job_count.hpp"
#include "cli/sweep/sweep_options.hpp"
#include "frame/file/manifest.hpp"
#include "frame/file/output_name.hpp"
#include "frame/frames_spec.hpp"
#include "frame/image.hpp"
#include "frame/interrupt.hpp"
#include "frame/sink/open_sink.hpp"
#include "frame/sink/progress.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/ranges.h>

namespace simreel::cli {

namespace fs = std::filesystem;

namespace {

struct FollowerOptions {
  std::string folder;
  std::vector<std::size_t> jobs;
  std::optional<int> frame;
  std::string frames;  ///< frames whose sheets `collect` writes to `output`; empty for none
  std::string output;
  SweepRunOptions run;
};

batch::SweepTally tallyOf(const batch::CollectedSweep& sweep) {
  batch::SweepTally tally;
  for (const batch::JobStatus& job : sweep.jobs) tally.add(job);
  return tally;
}

fs::path slurmFolder(const batch::SweepPlan& plan) {
  return plan.folder / "slurm";
}
constexpr const char* slurmWork = "sweep";

/// Returns `queued` if the job is missing or aborted and still in the cluster's queue; otherwise returns
/// `state`.
batch::JobState stateIn(const batch::SlurmQueue& queue, std::size_t job, batch::JobState state) {
  const bool idle = state == batch::JobState::missing || state == batch::JobState::aborted;
  return idle && queue.has(slurmWork, job) ? batch::JobState::queued : state;
}

/// Prints a line for each job that is not done, and the totals.
void status(const FollowerOptions& o) {
  const batch::SweepPlan plan = batch::readSweepPlan(o.folder);
  // Reads the queue before the jobs, because a job may start between the two reads.
  const batch::SlurmQueue queue(slurmFolder(plan));
  auto sweep = batch::collect(plan);
  for (std::size_t i = 0; i < sweep.jobs.size(); ++i)
    sweep.jobs[i].state = stateIn(queue, i, sweep.jobs[i].state);
  for (std::size_t i = 0; i < sweep.jobs.size(); ++i) {
    const batch::JobStatus& job = sweep.jobs[i];
    if (job.state == batch::JobState::done && job.result->checksPassed()) continue;
    std::string why = job.result ? job.result->message : job.why;
    if (job.result && job.result->code == 0)
      for (const auto& check : job.result->checks)
        if (!check.passed) why += (why.empty() ? "" : "; ") + check.message;
    printText(oneLine(fmt::format("{}  {:7}  {}{}{}", sweep.plan.name(i), stateName(job.state),
                                  sweep.plan.label(i), why.empty() ? "" : "  ", why)) +
              "\n");
  }
  const batch::SweepTally tally = tallyOf(sweep);
  printText(tally.text() + "\n");
  setExitCode(tally.exitCode());
}

void retry(const FollowerOptions& o) {
  const batch::SweepPlan plan = batch::readSweepPlan(o.folder);
  const frame::OutputLock lock =
      lockSweep(plan, readFile(plan.planFile(), "plan") + readFile(plan.sceneFile(), "scene"));
  std::vector<std::size_t> all(plan.jobs.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  runSweep(plan, all, o.run);
}

/// Returns the numbers of the frames of a job: those in its manifest; none if there is no readable
/// manifest.
std::vector<int> framesOf(const batch::SweepPlan& plan, std::size_t job) {
  std::vector<int> numbers;
  try {
    if (const auto manifest = frame::readManifest(plan.jobFolder(job) / "manifest.json"))
      for (const auto& [number, frame] : manifest->frames) numbers.push_back(number);
  } catch (const UserError&) {  // NOLINT(bugprone-empty-catch): `sweep status` reports the job.
  }
  return numbers;
}

/// Throws UserError(usage) if no job has the frame. Warns of jobs that have other frames only.
void requireFrame(const batch::SweepPlan& plan, int frame) {
  std::vector<std::string> with, without;
  int first = 0, last = -1;
  for (std::size_t job = 0; job < plan.jobs.size(); ++job) {
    const std::vector<int> frames = framesOf(plan, job);
    if (frames.empty()) continue;
    first = last < 0 ? frames.front() : std::min(first, frames.front());
    last = std::max(last, frames.back());
    (std::binary_search(frames.begin(), frames.end(), frame) ? with : without).push_back(plan.name(job));
  }
  if (last < 0) fail(ExitCode::usage, "no job of {} has frames yet", plan.folder.string());
  constexpr std::size_t most = 8;  // names in a message
  const bool all = without.size() <= most;
  if (!all) without.resize(most);
  const std::string names = fmt::format("{}{}", fmt::join(without, ", "), all ? "" : ", ...");
  if (with.empty())
    fail(ExitCode::usage, "--frame {}: no job of {} has this frame; jobs {} have frames {} to {}", frame,
         plan.folder.string(), names, first, last);
  if (!without.empty())
    warn("--frame {}: jobs {} of {} do not have this frame; they are grey", frame, names,
         plan.folder.string());
}

/// Returns the manifest of the first job that has frames. Throws UserError(usage) if no job has frames.
frame::Manifest firstManifest(const batch::CollectedSweep& sweep) {
  for (std::size_t job = 0; job < sweep.jobs.size(); ++job)
    if (auto manifest = frame::readManifest(sweep.plan.jobFolder(job) / "manifest.json");
        manifest && !manifest->frames.empty())
      return *manifest;
  fail(ExitCode::usage, "no job of {} has frames yet", sweep.plan.folder.string());
}

/// Writes the sheet of each frame of `frames` to `output`: all jobs side by side over time.
void writeSheets(const batch::CollectedSweep& sweep, const FollowerOptions& o) {
  const frame::Manifest manifest = firstManifest(sweep);
  const auto frames = frame::parseFrames(o.frames, "--frames", manifest.frames.rbegin()->first);
  for (const int frame : frames)
    if (!manifest.frames.contains(frame))
      fail(ExitCode::usage, "--frames {}: the jobs of {} have no frame {} (they have {} to {})", o.frames,
           sweep.plan.folder.string(), frame, manifest.frames.begin()->first,
           manifest.frames.rbegin()->first);
  frame::OutputName output = frame::parseOutput(o.output, frames.size());
  output.manifest = false;
  const frame::Image first = batch::contactSheet(sweep, frames.front());
  frame::RunInfo run;
  run.title = manifest.run.title;
  run.sceneHash = manifest.run.sceneHash;
  run.width = first.width;
  run.height = first.height;
  run.fps = manifest.run.fps;
  const auto sink = frame::openSink(output, frame::Existing::overwrite, run, frames, "rgba");
  for (const int frame : frames)
    sink->add({.frame = frame, .stateHash = {}},
              frame == frames.front() ? first : batch::contactSheet(sweep, frame));
  sink->finish();
  info("{}", sink->summary());
}

void writeCollected(const FollowerOptions& o) {
  if (o.frames.empty() != o.output.empty())
    fail(ExitCode::usage, "--frames and --output of `sweep collect` need each other");
  const auto sweep = batch::collect(batch::readSweepPlan(o.folder));
  const auto& folder = sweep.plan.folder;
  if (o.frame) requireFrame(sweep.plan, *o.frame);
  writeFileAtomically(folder / "table.csv", batch::tableText(sweep));
  std::string made = "table.csv, ";
  if (const std::string counts = batch::countsText(sweep); !counts.empty()) {
    writeFileAtomically(folder / "counts.csv", counts);
    made += "counts.csv, ";
  }
  writeFileAtomically(folder / "index.html", batch::sweepPage(sweep, o.frame));
  writeFileAtomically(folder / "sheet.png", frame::encodePng(batch::contactSheet(sweep, o.frame), {}));
  const batch::SweepTally tally = tallyOf(sweep);
  info("{} -> {}sheet.png, index.html in {}", tally.text(), made, folder.string());
  if (!o.output.empty()) writeSheets(sweep, o);
  setExitCode(tally.exitCode());
}

/// Runs the given jobs in this process, one after another.
void job(const FollowerOptions& o) {
  const batch::SweepPlan plan = batch::readSweepPlan(o.folder);
  batch::checkProgram(plan);
  for (const std::size_t number : o.jobs)
    if (number >= plan.jobs.size())
      fail(ExitCode::usage, "there is no job {}; the sweep has 0 to {}", number, plan.jobs.size() - 1);
  frame::Progress progress(frame::parseProgressMode(o.run.progress));
  frame::catchInterrupts();
  frame::ignoreBrokenPipes();
  const fs::path scratch = batch::scratchRoot(o.run.cluster.scratch);
  const gl::Context context(o.run.on);
  int code = 0;
  for (const std::size_t number : o.jobs) {
    progress.ofJob(plan.name(number));
    const batch::JobEnd end = batch::runSweepJob(plan, number, context, progress, commandLine(), scratch);
    if (end.signal != 0) return setExitCode(128 + end.signal);
    if (end.elsewhere)
      fail(ExitCode::inputOutput, "{} is in use by another simreel process",
           plan.jobFolder(number).string());
    if (end.result.code != 0)
      printError(UserError(static_cast<ExitCode>(end.result.code), end.result.message));
    if (code == 0) code = end.result.code;
  }
  setExitCode(code);
}

void shared(const FollowerOptions& o) {
  const batch::SweepPlan plan = batch::readSweepPlan(o.folder);
  batch::checkProgram(plan);
  frame::Progress progress(frame::parseProgressMode(o.run.progress));
  frame::catchInterrupts();
  if (!batch::lacksShared(plan)) return info("there is no common beginning to simulate");
  const gl::Context context(o.run.on);
  if (const int signal = batch::makeShared(plan, context, progress, commandLine()); signal != 0)
    setExitCode(128 + signal);
}

}  // namespace

void SweepRunOptions::add(CLI::App& command) {
  command
      .add_option("-j,--jobs", jobs,
                  "Jobs at once, each in a process of its own with an equal share of the processors; auto: "
                  "one for each processor")
      ->capture_default_str();
  addDevices(command, on);
  command.add_option("--progress", progress, "auto, ndjson or none");
  cluster.add(command);
}

namespace {

/// Submits the jobs as Slurm job arrays. The cluster runs `simreel sweep job` for each job.
void submitSweep(const batch::SweepPlan& plan, const std::vector<std::size_t>& jobs,
                 const SweepRunOptions& how) {
  batch::Slurm slurm = how.cluster.cluster(slurmFolder(plan));
  if (jobs.empty()) return;
  batch::Slurm::Work work{.name = slurmWork, .arguments = {"sweep", "job"}, .numbers = jobs};
  const std::string folder = fs::absolute(plan.folder).lexically_normal().string();
  work.afterAnyResult = true;  // Jobs can run without the state that they share, so they start even if
                               // computing it failed.
  if (how.on.deviceCount() > 1)
    fail(ExitCode::usage, "--device {}: with --slurm the cluster gives each job its device", how.on.device);
  if (jobs.size() > 1 && batch::lacksShared(plan))
    work.after = slurm.submit({.name = "shared", .arguments = {"sweep", "shared", folder}, .numbers = {}});
  if (!how.on.device.empty()) work.arguments.push_back("--device=" + how.on.device);
  if (!how.on.memoryPath.empty()) work.arguments.push_back("--memory-path=" + how.on.memoryPath);
  for (const std::string& word : how.cluster.arguments()) work.arguments.push_back(word);
  work.arguments.push_back(folder);
  const auto ids = slurm.submit(work);
  info("{} jobs submitted as {}; see `simreel sweep status {}`", jobs.size(), fmt::join(ids, ", "),
       plan.folder.string());
}

}  // namespace

frame::OutputLock lockSweep(const batch::SweepPlan& plan, const std::string& text) {
  const std::array mine{static_cast<int>(::getpid())};
  try {
    return {plan.planFile(), hashHex(text), mine};
  } catch (const UserError&) {
    if (!frame::isOutputLocked(plan.planFile())) throw;
    fail(ExitCode::inputOutput,
         "another simreel is running another sweep in {}; wait for it, or choose another folder",
         plan.folder.string());
  }
}

void runSweep(const batch::SweepPlan& plan, const std::vector<std::size_t>& jobs,
              const SweepRunOptions& how) {
  batch::checkProgram(plan);
  std::vector<std::size_t> waiting;
  std::size_t queued = 0;
  // With --slurm, jobs that are in the cluster's queue are not submitted again. Without --slurm, these jobs
  // run in this process.
  const batch::SlurmQueue queue(how.cluster.slurm ? slurmFolder(plan) : fs::path());
  for (const std::size_t number : jobs) {
    const auto state = stateIn(queue, number, batch::statusOf(plan, number).state);
    if (state == batch::JobState::queued)
      ++queued;
    else if (state != batch::JobState::done && state != batch::JobState::running)
      waiting.push_back(number);
  }
  if (waiting.size() + queued < jobs.size())
    info("{} of {} jobs are done or being rendered", jobs.size() - waiting.size() - queued, jobs.size());
  if (queued > 0) info("{} of {} jobs are queued already", queued, jobs.size());
  if (how.cluster.slurm) return submitSweep(plan, waiting, how);
  batch::LocalRun local;
  local.workers = jobCount(how.jobs, how.on);
  local.on = how.on;
  local.ndjson = frame::parseProgressMode(how.progress) == frame::Progress::Mode::ndjson;
  local.command = commandLine();
  local.scratch = batch::scratchRoot(how.cluster.scratch);
  frame::catchInterrupts();
  frame::ignoreBrokenPipes();
  const int signal = waiting.empty() ? 0 : batch::runJobs(plan, waiting, local);
  const batch::SweepTally tally = tallyOf(batch::collect(plan));
  info("{} -> {}", tally.text(), plan.folder.string());
  if (signal != 0)
    info("simreel: interrupted; `simreel sweep retry {}` goes on from there", plan.folder.string());
  setExitCode(signal != 0 ? 128 + signal : tally.exitCode());
}

namespace {

/// Throws UserError(usage) if an option of `simreel sweep SCENE` was given to one of its subcommands.
void refuseOptionsOf(const CLI::App& sweep, const char* subcommand) {
  for (const CLI::Option* option : sweep.get_options())
    if (option->count() > 0)
      fail(ExitCode::usage, "{} belongs to `simreel sweep SCENE` and has no effect on `simreel sweep {}`",
           option->get_name(), subcommand);
}

}  // namespace

void addSweepFollowers(CLI::App& sweep) {
  auto o = std::make_shared<FollowerOptions>();
  const auto add = [&](const char* name, const char* doc, void (*act)(const FollowerOptions&)) {
    auto* command = sweep.add_subcommand(name, doc);
    command->add_option("folder", o->folder, "Folder of the sweep")->required();
    command->callback([o, act, name, &sweep] {
      refuseOptionsOf(sweep, name);
      act(*o);
    });
    return command;
  };
  add("status",
      "Print the state of each job; exit code 0: all is well, 1: one failed, 7: one is queued, running or "
      "aborted, 3: one is missing",
      status);
  o->run.add(*add("retry", "Run the jobs that failed, were aborted or are missing", retry));
  auto* collect = add("collect", "Write table.csv, counts.csv, sheet.png and index.html", writeCollected);
  collect->add_option("--frame", o->frame, "Frame to show (default: the last of each job)");
  collect->add_option("--frames", o->frames, "Also write the sheets of these frames to --output");
  collect->add_option("-o,--output", o->output,
                      "All jobs side by side over time: numbered pictures (sheet_####.png) or a video");
  addDevice(*add("shared", "Simulate the common beginning of all jobs once, if there is one", shared),
            o->run.on);
  auto* one = add("job", "Run single jobs in this process, as a cluster does", job);
  one->add_option("jobs", o->jobs, "Numbers of the jobs, from 0")->required();
  addDevice(*one, o->run.on);
  one->add_option("--progress", o->run.progress, "auto, tty, ndjson or none");
  o->run.cluster.addScratch(*one);
}

}  // namespace simreel::cli
