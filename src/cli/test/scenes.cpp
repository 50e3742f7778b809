// simreel test SCENES: compares scenes with their baselines, one after another or in several processes.
#include "base/clock.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "base/workers.hpp"
#include "cli/commands.hpp"
#include "cli/options/job_count.hpp"
#include "cli/options/scene_options.hpp"
#include "cli/test/test_options.hpp"
#include "draw/screen/picture_probe.hpp"
#include "frame/interrupt.hpp"
#include "gl/context.hpp"
#include "gl/driver_threads.hpp"
#include "gl/machine.hpp"
#include "golden/baseline/baseline.hpp"
#include "golden/baseline/profile.hpp"
#include "golden/baseline/stale.hpp"
#include "golden/report/outcome.hpp"
#include "golden/suite/suite.hpp"
#include "golden/tally.hpp"
#include "sim/core/numerics.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace simreel::cli {

namespace {

namespace fs = std::filesystem;

/// Checks that a profile's name is a valid folder name, because the profile's baselines are stored in a
/// folder with that name.
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

void setEnvironment(const golden::Device& device, golden::SuiteResult& result) {
  result.driver = device.origin.driver;
  result.processor = device.origin.processor;
  result.profile = device.profile;
  result.fingerprint = device.origin.numerics;
  result.drawing = device.origin.drawing;
  result.memoryPath = device.memoryPath;
}

/// Runs one test of scenes.
class SceneRun {
 public:
  explicit SceneRun(const TestOptions& o) : o_(o) {
    if (o.allowance.ignoreAntialiased || o.allowance.searchRadius || !o.allowance.mask.empty())
      fail(ExitCode::usage,
           "--ignore-antialiased, --search-radius and --mask are for pictures (--expected); scenes are "
           "exact");
    checkProfile(o.profile);
    options_.repeats = o.repeat;
    options_.retries = o.retries;
    options_.allowFlaky = o.allowFlaky;
    options_.measures = o.measures();
    options_.update = o.updateMode();
    options_.reason = o.reason;
    options_.profile = o.profile;
    options_.tolerance = o.tolerance.given();
    options_.assets = assetFolders(o.assets);
    options_.reportFolder = o.outputs.folder();
    options_.artifacts = o.outputs.artifacts();
    jobs_ = jobCount(o.jobs, o.on);
    chooseScenes();
  }

  void run() {
    if (o_.list) {
      for (const golden::SceneFile& scene : scenes_)
        printText(oneLine(scene.name) + "\t" + oneLine(scene.file.string()) + "\n");
      return;
    }
    o_.outputs.prepare();
    frame::catchInterrupts();
    frame::interruptFrames();
    frame::ignoreBrokenPipes();
    const Clock::time_point begin = Clock::now();
    options_.orphans =
        golden::baselinesWithoutScene(o_.paths.empty() ? std::vector<std::string>{"."} : o_.paths);
    result_.version = version();
    result_.command = o_.command;
    result_.allowFlaky = o_.allowFlaky;
    result_.strict = o_.strict;
    jobs_ = std::min(jobs_, scenes_.size());
    // A timeout needs a child process, because only a process can be stopped while it tests a scene.
    if (jobs_ == 1 && o_.timeout == 0)
      testHere();
    else if (jobs_ > 0)
      testBeside();
    addOrphans();
    if (o_.strict && std::any_of(result_.stale.begin(), result_.stale.end(),
                                 [](const auto& one) { return !one.removed; }))
      tally_.addFailure();
    result_.seconds = secondsSince(begin);
    finish();
  }

 private:
  void chooseScenes() {
    const std::vector<std::string> here = {"."};
    const auto all = golden::findScenes(o_.paths.empty() ? here : o_.paths);
    scenes_ = golden::filtered(all, o_.globs);
    if (scenes_.empty())
      fail(ExitCode::nothingRan, "no scene to test: {} found, 0 of them match --filter", all.size());
    if (o_.shard.empty()) return;
    if (options_.update == golden::Update::prune)
      fail(ExitCode::usage, "--update=prune needs all scenes, so it cannot be combined with --shard");
    result_.shard = o_.shard;
    const std::size_t whole = scenes_.size();
    scenes_ = golden::shardOf(scenes_, o_.shard);
    result_.notes.push_back(golden::shardNote(o_.shard, scenes_.size(), whole, "scene"));
  }

  /// Tests all scenes in this process, with all processors.
  void testHere() {
    const gl::Context context(o_.on.ofWorker(0));
    const golden::Device device = describeDevice(context, o_.profile);
    setEnvironment(device, result_);
    try {
      for (const golden::SceneFile& scene : scenes_) addOutcome(golden::testScene(scene, options_, device));
    } catch (const frame::Interrupted& interrupted) {
      signal_ = interrupted.signal;
    }
  }

  void testBeside() {
    gl::shareProcessors(jobs_);
    WorkerPool force;
    force.workers = jobs_;
    force.items = scenes_.size();
    force.work = [this](WorkerLine& line) { testAsWorker(line); };
    force.ready = [this](const std::string& text) {
      const auto said = golden::parseReport(text, "worker");
      result_.driver = said.driver;
      result_.processor = said.processor;
      result_.profile = said.profile;
      result_.fingerprint = said.fingerprint;
      result_.drawing = said.drawing;
      result_.memoryPath = said.memoryPath;
    };
    force.done = [this](std::size_t item, const std::string& text) {
      golden::Outcome outcome = golden::parseOutcome(text);
      nameScene(scenes_[item], outcome.scene);  // Sets the name again, because JSON cannot contain names
                                                // that are not valid UTF-8.
      golden::addLosses(losses_[item], outcome);
      addOutcome(std::move(outcome));
    };
    force.again = [this](std::size_t item, const Loss& loss) {
      if (static_cast<int>(losses_[item].size()) >= options_.retries) return false;
      losses_[item].push_back(lossText(item, loss));
      return true;
    };
    force.lost = [this](std::size_t item, const Loss& loss) {
      golden::Outcome outcome;
      nameScene(scenes_[item], outcome.scene);
      outcome.scene.status = golden::Status::error;
      outcome.scene.messages.push_back(lossText(item, loss));
      outcome.error = ExitCode::device;
      golden::addLosses(losses_[item], outcome);
      addOutcome(std::move(outcome));
    };
    force.itemTimeout = o_.timeout;
    // A renamed scene takes over the baseline of a scene that no longer exists. If this may happen, scenes
    // are tested one at a time, in order, so that the first matching scene gets the baseline.
    const bool mayMove = options_.update != golden::Update::none && !options_.orphans.empty();
    force.alone = [this, mayMove](std::size_t item) {
      return mayMove && !pathExists(golden::baselineFolder(scenes_[item].file));
    };
    force.interrupted = [] { return frame::interruptSignal(); };
    runWorkers(force);
    signal_ = frame::interruptSignal();
  }

  [[nodiscard]] std::string lossText(std::size_t item, const Loss& loss) const {
    return fmt::format("the process that tested it {}{} Run it alone: simreel test {}", loss.how,
                       loss.late ? " (--timeout)." : ": out of memory, or a crash of the driver?",
                       scenes_[item].file.generic_string());
  }

  static void nameScene(const golden::SceneFile& scene, golden::SceneResult& result) {
    result.name = scene.name;
    result.file = scene.file.generic_string();
    result.baselines = golden::baselineFolder(scene.file).generic_string();
  }

  void testAsWorker(WorkerLine& line) {
    const gl::Context context(o_.on.ofWorker(line.place()));
    const golden::Device device = describeDevice(context, o_.profile);
    golden::SuiteResult about;
    setEnvironment(device, about);
    line.ready(golden::reportText(about));
    while (const auto task = line.next()) {
      const auto outcome = golden::testScene(scenes_[task->item], options_, device, task->losses);
      line.answer(task->item, golden::outcomeText(outcome));
    }
  }

  void addOutcome(golden::Outcome&& outcome) {
    tally_.add(outcome.scene.status, options_.allowFlaky && !outcome.hardFailed, outcome.error);
    result_.stale.insert(result_.stale.end(), outcome.stale.begin(), outcome.stale.end());
    o_.outputs.print(outcome.scene, result_.unit, o_.allowFlaky);
    result_.scenes.push_back(std::move(outcome.scene));
  }

  /// Reports baselines of scenes that no longer exist, if no renamed scene took over the baseline.
  void addOrphans() {
    for (const fs::path& folder : options_.orphans) {
      if (!pathExists(folder)) continue;
      const auto heir = std::find_if(
          result_.scenes.begin(), result_.scenes.end(),
          [&](const golden::SceneResult& scene) { return scene.renamedFrom == folder.generic_string(); });
      golden::Stale stale{folder.generic_string(), "its scene is gone", false};
      if (heir != result_.scenes.end())
        stale.message = fmt::format(
            "its scene is gone; the pictures are those of {}: --update moves it there", heir->name);
      else if (options_.update == golden::Update::prune &&
               !(stale.removed = golden::removeBaselines(folder)))
        stale.message = "its scene is gone; files that are not baselines were left there";
      result_.stale.push_back(std::move(stale));
    }
  }

  void finish() {
    o_.outputs.write(result_);
    if (signal_ != 0)
      info("simreel: interrupted after {} of {} scenes", result_.scenes.size(), scenes_.size());
    // A shard without scenes counts as passed, because the other shards contain them.
    const ExitCode code = scenes_.empty() ? ExitCode::ok : tally_.exitCode();
    setExitCode(signal_ != 0 ? 128 + signal_ : static_cast<int>(code));
  }

  const TestOptions& o_;
  golden::SuiteOptions options_;
  std::size_t jobs_ = 1;
  std::vector<golden::SceneFile> scenes_;
  /// Messages about processes that ended while they tested a scene, by the scene's index.
  std::map<std::size_t, std::vector<std::string>> losses_;
  golden::Tally tally_;
  golden::SuiteResult result_;
  int signal_ = 0;
};

}  // namespace

void testScenes(const TestOptions& options) {
  SceneRun(options).run();
}

}  // namespace simreel::cli
