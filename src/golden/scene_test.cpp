#include "golden/scene_test.hpp"

#include "base/file.hpp"
#include "base/version.hpp"
#include "golden/compare.hpp"
#include "golden/tolerance.hpp"
#include "golden/trace.hpp"
#include "sim/list.hpp"

#include <algorithm>
#include <utility>

namespace simreel::golden {

namespace {

/// steps.bin stays below what a repository should hold.
constexpr std::size_t mostTraceBytes = std::size_t{96} << 10;

}  // namespace

SceneTest::SceneTest(const SceneFile& file, const SuiteOptions& options, const Device& device)
    : file_(file), options_(options), device_(device) {
  result_.name = file.name;
  result_.file = file.file.generic_string();
  result_.baselines = baselineFolder(file.file).generic_string();
}

SceneTest::~SceneTest() = default;

void SceneTest::run() {
  load();
  run_ = runScene(scene_, frames_);
  result_.simulateSeconds = run_.simulateSeconds;
  result_.repeats = 1;
  result_.checks = run_.checks;
  repeat();
  judge();
  if (result_.status == Status::nondeterministic) return keepPictures();
  locate();
  if (options_.update != Update::none) update();
  if (options_.artifacts.empty()) return;
  keepCandidate();
  keepPictures();
}

void SceneTest::load() {
  scene_ = scene::loadTestScene(file_.file, {}, sim::kinds(), options_.assets);
  result_.xfail = scene_.test.xfail;
  scene_.render.size = scene_.test.size;
  if (scene_.test.samples) scene_.render.samples = *scene_.test.samples;
  frames_ = scene_.testFrames();
  const bool exact = scene_.numerics == scene::Numerics::exact;
  if (exact && !device_.inexact.empty())
    fail(ExitCode::device,
         "this driver does not compute exactly ({}); use another device, or \"numerics\": "
         "\"fast\"",
         device_.inexact);
  try {
    reference_ = findReference(result_.baselines, device_.profile, exact, device_.origin);
  } catch (const UserError& error) {
    if (options_.update != Update::all) throw;
    result_.notes.push_back(fmt::format("{} (written anew)", error.what()));
    reference_ = {result_.baselines, std::nullopt, std::nullopt, exact, device_.origin, {}};
  }
  resolveTolerance();
  describeBaseline();
  if (!reference_.pictures) return;
  for (const auto& [frame, stored] : reference_.pictures->frames)
    if (std::find(frames_.begin(), frames_.end(), frame) == frames_.end())
      result_.notes.push_back(fmt::format("the baseline has frame {}, which is not tested", frame));
}

/// Whose baseline the pictures are held against, and how closely.
void SceneTest::describeBaseline() {
  if (!reference_.pictures) return;
  const PictureBaseline& pictures = *reference_.pictures;
  result_.profile = pictures.profile;
  result_.baselineDriver = pictures.driver;
  result_.baselineVersion = pictures.version;
  result_.baselineReason = pictures.reason;
  std::optional<Asked> least;
  for (const auto& [frame, stored] : pictures.frames) {
    const Asked one = asked(stored.origin, device_.origin);
    if (least && one <= *least) continue;
    least = one;
    result_.asked = askedName(one);
    result_.baselineProcessor = stored.origin.processor;
  }
}

/// The command line wins over the baseline, which wins over the scene, which wins over the defaults.
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
    std::string flag = "--" + field;
    std::replace(flag.begin(), flag.end(), '_', '-');
    origins[field] = flag;
  }
  reference_.tolerance = tolerance;
  for (const auto& [field, value] : boundsInForce(tolerance))
    result_.tolerance[field] = {value, origins.contains(field) ? origins[field] : "default"};
}

void SceneTest::repeat() {
  for (; result_.repeats < options_.repeats; ++result_.repeats) {
    SceneRun again = runScene(scene_, frames_);
    result_.simulateSeconds += again.simulateSeconds;
    const std::string difference = runDifference(run_, again);
    if (difference.empty()) continue;
    result_.status = Status::nondeterministic;
    result_.messages.push_back(
        fmt::format("runs 1 and {} of this program differ: {}", result_.repeats + 1, difference));
    ++result_.repeats;
    other_ = std::move(again);
    return;
  }
}

void SceneTest::judge() {
  for (const RunFrame& made : run_.frames) {
    auto [frame, pictureFails] = judgeFrame(made, reference_);
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
  for (const std::string& loose : looseBounds(result_.frames, reference_.tolerance))
    if (const auto& bound = result_.tolerance[loose.substr(0, loose.find(' '))]; bound.origin != "default")
      result_.notes.push_back(fmt::format("loose tolerance: {} ({})", loose, bound.origin));
}

/// Where the state first leaves the baseline's.
void SceneTest::locate() {
  if (!stateIs("different")) return;
  const auto folder = stateFolder(reference_.folder, result_.profile, reference_.exact);
  const auto steps = readSteps(folder);
  if (steps.empty()) {
    result_.notes.push_back("the baseline has no steps.bin, so the step that differs is not known");
    return;
  }
  result_.divergence = firstDivergence(scene_, decodeTrace(steps, (folder / "steps.bin").string()));
  if (result_.divergence) result_.messages.push_back(result_.divergence->message);
}

Candidate SceneTest::candidate(bool withSteps) const {
  Candidate made;
  made.exact = reference_.exact;
  made.pictures.version = version();
  made.pictures.driver = device_.origin.driver;
  made.pictures.width = scene_.render.size.x;
  made.pictures.height = scene_.render.size.y;
  for (const RunFrame& frame : run_.frames) {
    made.pictures.frames[frame.frame] = {frame.pixels, device_.origin, {}};
    if (!frame.state.empty()) made.state.frames[frame.frame] = frame.state;
  }
  if (withSteps && !made.state.frames.empty())
    made.steps = encodeTrace(traceRun(scene_, frames_.back(), mostTraceBytes));
  return made;
}

bool SceneTest::hardFailed() const {
  const auto& bound = reference_.tolerance.hard_fail;
  return bound && std::any_of(result_.frames.begin(), result_.frames.end(),
                              [&](const FrameResult& f) { return f.metrics && f.metrics->worst > *bound; });
}

}  // namespace simreel::golden
