#include "golden/suite/scene_test.hpp"

#include "base/version.hpp"
#include "frame/interrupt.hpp"
#include "golden/baseline/stale.hpp"
#include "golden/baseline/tolerance.hpp"
#include "golden/compare/compare.hpp"
#include "golden/trace/file.hpp"
#include "golden/trace/stream.hpp"
#include "golden/trace/trace.hpp"
#include "scene/json/words.hpp"
#include "scene/load.hpp"
#include "sim/world/list.hpp"
#include "sim/world/survey.hpp"

#include <algorithm>
#include <utility>

namespace simreel::golden {

namespace fs = std::filesystem;

namespace {

/// Max size of steps.bin, small enough for a repository.
constexpr std::size_t maxTraceBytes = std::size_t{96} << 10;
/// Max number of differing runs whose pictures are stored.
constexpr std::size_t maxOtherRuns = 7;

}  // namespace

SceneTest::SceneTest(const SceneFile& file, const SuiteOptions& options, const Device& device, int attempt)
    : file_(file), options_(options), device_(device), attempt_(attempt) {
  result_.name = file.name;
  result_.file = file.file.generic_string();
  result_.baselines = baselineFolder(file.file).generic_string();
}

SceneTest::~SceneTest() = default;

void SceneTest::run() {
  load();
  static_cast<void>(sim::frameMotion(scene_, frame::throwIfInterrupted));
  run_ = runScene(scene_, frames_);
  result_.simulateSeconds = run_.simulateSeconds;
  result_.repeats = 1;
  result_.checks = run_.checks;
  repeat();
  judge();
  if (result_.status == Status::nondeterministic) return keepPictures();
  locate();
  locatePasses();
  findFormerName();
  if (options_.update == Update::prune) {
    stale_ = staleParts(result_.baselines, frames_, exactPictures_, true);
  } else {
    if (options_.update != Update::none) update();
    stale_ = staleParts(result_.baselines, frames_, exactPictures_, false);
  }
  if (options_.artifacts.empty()) return;
  keepCandidate();
  keepPictures();
}

void SceneTest::load() {
  scene_ = scene::loadTestScene(file_.file, {}, sim::kinds(), options_.assets);
  if (!options_.artifacts.empty()) inputs_ = inputsOf(file_.file, scene_.files);
  result_.xfail = scene_.test.xfail;
  scene_.render.size = scene_.test.size;
  if (scene_.test.samples) scene_.render.samples = *scene_.test.samples;
  frames_ = scene_.testFrames();
  const bool exact = scene_.numerics == scene::Numerics::exact;
  if (exact && !device_.inexact.empty())
    fail(ExitCode::device,
         "this driver does not compute exactly ({}); use another device, or "
         "\"numerics\": \"fast\"",
         device_.inexact);
  exactPictures_ = scene_.drawsExactly();
  origin_ = exactPictures_ ? exactOrigin : device_.origin;
  profile_ = exactPictures_ ? sharedProfile : device_.profile;
  try {
    reference_ = findReference(result_.baselines, profile_, exact, origin_);
  } catch (const UserError& error) {
    if (options_.update != Update::all) throw;
    checkReplaceable(result_.baselines, profile_, exact);
    checkReplaceable(result_.baselines, sharedProfile, exact);
    result_.notes.push_back(fmt::format("{} (written again)", error.what()));
    reference_ = {result_.baselines, std::nullopt, std::nullopt, exact, origin_, {}};
  }
  resolveTolerance();
  describeBaseline();
  if (exactPictures_) noteUnused();
}

/// Determines the baseline with which the pictures are compared, and how closely they must match.
void SceneTest::describeBaseline() {
  if (!reference_.pictures) return;
  const PictureBaseline& pictures = *reference_.pictures;
  result_.profile = pictures.profile;
  result_.baselineDriver = pictures.driver;
  result_.baselineVersion = pictures.version;
  result_.baselineReason = pictures.reason;
  std::optional<RequiredMatch> min;
  for (const auto& [frame, stored] : pictures.frames) {
    const RequiredMatch one = requiredMatch(stored.origin, origin_);
    if (min && one <= *min) continue;
    min = one;
    result_.asked = requiredMatchName(one);
    result_.baselineProcessor = stored.origin.processor;
  }
}

/// Adds a note for each explicitly set tolerance, because exact pictures do not use tolerances.
void SceneTest::noteUnused() {
  for (const auto& [field, bound] : result_.tolerance)
    if (bound.origin != "default")
      result_.notes.push_back(
          fmt::format("unused tolerance: {} ({}); exact pictures must be equal", field, bound.origin));
}

/// Merges the tolerances: the command line overrides the baseline, which overrides the scene, which
/// overrides the defaults.
void SceneTest::resolveTolerance() {
  scene::Tolerance tolerance = scene_.test.tolerance;
  std::map<std::string, std::string> origins = scene_.test.toleranceOrigin;
  if (const auto& pictures = reference_.pictures)
    for (const auto& [field, value] : pictures->tolerance) {
      setBound(tolerance, field, value);
      origins[field] = (reference_.folder / pictures->profile / "baseline.json").generic_string();
    }
  for (const auto& [field, value] : options_.tolerance) {
    setBound(tolerance, field, value);
    origins[field] = "--" + scene::splitCamelCase(field, '-');
  }
  reference_.tolerance = tolerance;
  for (const auto& [field, value] : boundsInForce(tolerance))
    result_.tolerance[field] = {value, origins.contains(field) ? origins[field] : "default"};
}

void SceneTest::repeat() {
  for (; result_.repeats < options_.repeats; ++result_.repeats) {
    SceneRun again = runScene(scene_, frames_);
    result_.simulateSeconds += again.simulateSeconds;
    const int number = result_.repeats + 1;
    const std::string difference = runDifference(run_, again);
    if (difference.empty()) {
      likeFirst_.push_back(number);
      continue;
    }
    if (result_.status != Status::nondeterministic)
      result_.messages.push_back(
          fmt::format("runs 1 and {} of this program differ: {}", number, difference));
    result_.status = Status::nondeterministic;
    const auto known = std::find_if(others_.begin(), others_.end(), [&](const OtherRun& other) {
      return runDifference(other.run, again).empty();
    });
    if (known != others_.end())
      known->numbers.push_back(number);
    else if (others_.size() < maxOtherRuns)
      others_.push_back({{number}, std::move(again)});
    else
      ++uncounted_;
  }
  if (options_.repeats > 2 && !others_.empty()) {
    std::string groups = fmt::format("{}", fmt::join(likeFirst_, " "));
    for (const OtherRun& other : others_) groups += fmt::format("; {}", fmt::join(other.numbers, " "));
    result_.messages.push_back(
        fmt::format("of {} runs these agree: {}{}", result_.repeats, groups,
                    uncounted_ > 0 ? fmt::format("; {} more came out in other ways", uncounted_) : ""));
  }
}

void SceneTest::judge() {
  for (const RunFrame& made : run_.frames) {
    auto [frame, pictureFails, damaged] = judgeFrame(made, reference_, options_.measures);
    damaged_ = damaged_ || damaged;
    if (pictureFails) failedPictures_.insert(frame.frame);
    if (!frame.message.empty()) frame.message = fmt::format("frame {}: {}", frame.frame, frame.message);
    result_.frames.push_back(frame);
    if (result_.status == Status::nondeterministic) continue;
    if (frame.status == Status::fail) result_.status = Status::fail;
    if (frame.status == Status::missing && result_.status == Status::pass) result_.status = Status::missing;
    if (frame.status != Status::pass) result_.messages.push_back(frame.message);
  }
  for (const CheckResult& check : result_.checks) {
    if (check.passed) continue;
    if (result_.status != Status::nondeterministic) result_.status = Status::fail;
    result_.messages.push_back(check.message);
  }
  readStepsOfBaseline();
  for (const std::string& loose : looseBounds(result_.frames, reference_.tolerance))
    if (const auto& bound = result_.tolerance[loose.substr(0, loose.find(' '))]; bound.origin != "default")
      result_.notes.push_back(fmt::format("loose tolerance: {} ({})", loose, bound.origin));
}

/// Reads steps.bin even if it is not needed now, so that damage is reported early.
void SceneTest::readStepsOfBaseline() {
  if (!reference_.state) return;
  const auto folder = stateFolder(reference_.folder, result_.profile, reference_.exact);
  try {
    if (const auto steps = readSteps(folder); !steps.empty())
      steps_ = decodeTrace(steps, (folder / "steps.bin").string());
  } catch (const UserError& error) {
    damagedSteps_ = damaged_ = true;
    result_.messages.emplace_back(error.what());
    if (result_.status == Status::pass || result_.status == Status::missing) result_.status = Status::fail;
  }
}

/// Finds the first step at which the state differs from the baseline.
void SceneTest::locate() {
  if (!stateIs("different") || damagedSteps_) return;
  if (!steps_) {
    result_.notes.push_back("the baseline has no steps.bin, so the step that differs is not known");
    return;
  }
  result_.divergence = firstDivergence(scene_, *steps_);
  if (result_.divergence) result_.messages.push_back(result_.divergence->message);
}

/// If the scene has no baseline, searches for a baseline whose scene does not exist and whose pictures are
/// equal, because the scene may have been renamed.
void SceneTest::findFormerName() {
  if (result_.status != Status::missing || reference_.pictures || reference_.state) return;
  for (const fs::path& folder : options_.orphans) {
    std::optional<PictureBaseline> pictures;
    try {
      pictures = choosePictures(folder, profile_);
    } catch (const UserError&) {
      continue;  // The unreadable baseline is already reported as stale.
    }
    const bool same =
        pictures && std::all_of(run_.frames.begin(), run_.frames.end(), [&](const RunFrame& made) {
          const auto found = pictures->frames.find(made.frame);
          return found != pictures->frames.end() && found->second.pixels == made.pixels;
        });
    if (!same) continue;
    result_.renamedFrom = folder.generic_string();
    result_.messages.push_back(
        fmt::format("its pictures are those of {}, whose scene is gone: renamed? --update moves that here",
                    result_.renamedFrom));
    return;
  }
}

const std::map<int, PassHashes>& SceneTest::passes() {
  if (!exactPictures_ || !passes_.empty()) return passes_;
  sim::World world(scene_);
  drawPasses(scene_, world, frames_, [&](const PassDump& drawn) {
    passes_[drawn.frame] = hashesOf(drawn.picture);
    if (!failedPictures_.contains(drawn.frame)) return;
    const auto result = std::find_if(result_.frames.begin(), result_.frames.end(),
                                     [&](const FrameResult& f) { return f.frame == drawn.frame; });
    const auto made = std::find_if(run_.frames.begin(), run_.frames.end(),
                                   [&](const RunFrame& f) { return f.frame == drawn.frame; });
    if (result->state == "equal" && !result->expectedPixels.empty())
      result->pass = placeOfDifference(reference_, *made, result->alternate, drawn);
  });
  return passes_;
}

/// Finds the first differing pass of pictures that fail although the state is equal.
void SceneTest::locatePasses() {
  if (!exactPictures_ || failedPictures_.empty() || stateIs("different")) return;
  static_cast<void>(passes());
  for (const FrameResult& frame : result_.frames)
    if (frame.pass) result_.messages.push_back(frame.pass->message);
}

Candidate SceneTest::candidate(bool withSteps) {
  Candidate made;
  made.exact = reference_.exact;
  made.pictures.version = version();
  made.pictures.driver = device_.origin.driver;
  made.pictures.width = scene_.render.size.x;
  made.pictures.height = scene_.render.size.y;
  for (const RunFrame& frame : run_.frames) {
    made.pictures.frames[frame.frame] = {frame.pixels, origin_, {}};
    if (const auto known = passes().find(frame.frame); known != passes().end())
      made.pictures.frames[frame.frame].passes = known->second;
    if (!frame.state.empty()) made.state.frames[frame.frame] = frame.state;
  }
  if (withSteps && !made.state.frames.empty())
    made.steps = encodeTrace(traceRun(scene_, frames_.back(), maxTraceBytes));
  return made;
}

bool SceneTest::hardFailed() const {
  const auto& bound = reference_.tolerance.hardFail;
  return bound && std::any_of(result_.frames.begin(), result_.frames.end(),
                              [&](const FrameResult& f) { return f.metrics && f.metrics->worst > *bound; });
}

}  // namespace simreel::golden
