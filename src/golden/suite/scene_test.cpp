#include "golden/suite/scene_test.hpp"

#include "base/file.hpp"
#include "base/version.hpp"
#include "golden/baseline/tolerance.hpp"
#include "golden/compare/compare.hpp"
#include "golden/compare/difference_image.hpp"
#include "golden/trace/file.hpp"
#include "golden/trace/stream.hpp"
#include "golden/trace/trace.hpp"
#include "scene/words.hpp"
#include "sim/world/list.hpp"

#include <algorithm>
#include <utility>

namespace simreel::golden {

namespace fs = std::filesystem;

namespace {

/// steps.bin stays below what a repository should hold.
constexpr std::size_t maxTraceBytes = std::size_t{96} << 10;

std::string listOf(const std::set<int>& frames) {
  std::string text;
  for (const int frame : frames) text += (text.empty() ? "" : ", ") + std::to_string(frame);
  return text;
}

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
  locatePasses();
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
    result_.notes.push_back(fmt::format("{} (written anew)", error.what()));
    reference_ = {result_.baselines, std::nullopt, std::nullopt, exact, origin_, {}};
  }
  resolveTolerance();
  describeBaseline();
  if (exactPictures_) noteUnused();
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
  std::optional<Asked> min;
  for (const auto& [frame, stored] : pictures.frames) {
    const Asked one = asked(stored.origin, origin_);
    if (min && one <= *min) continue;
    min = one;
    result_.asked = askedName(one);
    result_.baselineProcessor = stored.origin.processor;
  }
}

/// What exact pictures have no use for: bounds that somebody gave, and baselines of one family of drivers.
void SceneTest::noteUnused() {
  for (const auto& [field, bound] : result_.tolerance)
    if (bound.origin != "default")
      result_.notes.push_back(fmt::format(
          "tolerance without need: {} ({}), exact pictures have to be equal", field, bound.origin));
  std::error_code error;
  std::set<std::string> profiles;
  for (const auto& entry : fs::directory_iterator(reference_.folder, error))
    if (pathExists(entry.path() / "baseline.json")) profiles.insert(entry.path().filename().string());
  profiles.erase(sharedProfile);
  for (const std::string& profile : profiles)
    result_.notes.push_back(
        fmt::format("the baseline {} is not used: exact pictures have one for all machines",
                    (reference_.folder / profile).generic_string()));
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
    origins[field] = "--" + scene::apart(field, '-');
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

/// Where pictures first leave the baselines' whose state is the same.
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

// What is written: baselines when asked, and what a report and `simreel accept` need.

bool SceneTest::stateIs(const char* what) const {
  return std::any_of(result_.frames.begin(), result_.frames.end(),
                     [&](const FrameResult& f) { return f.state == what; });
}

bool SceneTest::checkFails() const {
  return std::any_of(result_.checks.begin(), result_.checks.end(),
                     [](const CheckResult& check) { return !check.passed; });
}

std::string SceneTest::profileToPromote() const {
  if (exactPictures_) return sharedProfile;
  if (!options_.profile.empty()) return options_.profile;
  return profileToWrite(reference_.folder, device_.profile, device_.origin.numerics);
}

void SceneTest::update() {
  if (result_.status == Status::pass) {
    // A pass may have changed without showing in the picture.
    if (exactPictures_ && renewPasses(reference_.folder, profile_, passes()))
      result_.notes.push_back("wrote hashes of passes; the pictures are the same");
    return;
  }
  if (!result_.xfail.empty() || checkFails()) {
    result_.notes.push_back(result_.xfail.empty() ? "not updated: a check fails"
                                                  : "not updated: the scene is expected to fail");
    return;
  }
  const bool changed = options_.update != Update::missing;
  const bool missing = options_.update != Update::changed;
  const std::string profile = profileToPromote();
  std::set<int> written;
  for (const FrameResult& frame : result_.frames)
    if ((missing && frame.expectedPixels.empty()) || (changed && failedPictures_.contains(frame.frame)))
      written.insert(frame.frame);
  const bool writeState = (changed && stateIs("different")) || (missing && stateIs("missing"));
  if (written.empty() && !writeState) return;
  // A profile has to be complete: the next run compares with nothing else.
  if (!written.empty() && profile != result_.profile) written.insert(frames_.begin(), frames_.end());

  Candidate made = candidate(writeState);
  if (!writeState) made.state.frames.clear();
  for (const RunFrame& frame : run_.frames)
    if (written.contains(frame.frame)) made.png[frame.frame] = frame::encodePng(frame.image, {});
  promote(reference_.folder, profile, made, {options_.reason, false, !changed});

  // Held against what was just written, every frame has to pass.
  const auto before = std::exchange(result_.frames, {});
  const scene::Tolerance tolerance = reference_.tolerance;
  reference_ = findReference(reference_.folder, profile, reference_.exact, origin_);
  reference_.tolerance = tolerance;
  describeBaseline();
  result_.divergence.reset();
  result_.messages.clear();
  result_.status = Status::pass;
  failedPictures_.clear();
  judge();
  for (std::size_t i = 0; i < before.size(); ++i)
    if (before[i].status != Status::pass && result_.frames[i].status == Status::pass)
      result_.frames[i].status = Status::updated;
  if (result_.status == Status::pass) result_.status = Status::updated;
  result_.notes.push_back(
      fmt::format("wrote {}{}{} to {}", written.empty() ? "" : "frames " + listOf(written),
                  !written.empty() && writeState ? " and " : "", writeState ? "the state" : "",
                  (reference_.folder / profile).generic_string()));
}

std::string SceneTest::keep(const std::string& name, const frame::Image& image) const {
  const fs::path file = options_.artifacts / result_.name / name;
  makeFolders(file.parent_path());
  writeFileAtomically(file, frame::encodePng(image, {}));
  return file.lexically_relative(options_.reportFolder).generic_string();
}

void SceneTest::keepPicture(FrameResult& frame, const frame::Image& made) {
  const std::string number = fmt::format("{:06}", frame.frame);
  if (frame.actualImage.empty()) frame.actualImage = keep(number + ".actual.png", made);
  if (frame.expectedPixels.empty()) return;
  try {
    const frame::Image expected = referencePicture(reference_, frame.frame, frame.alternate);
    frame.expectedImage = keep(number + ".expected.png", expected);
    if (expected.width == made.width && expected.height == made.height)
      frame.differenceImage = keep(number + ".difference.png", differenceImage(expected, made));
  } catch (const UserError& error) {
    if (error.code() != ExitCode::inputOutput)
      throw;  // an unreadable baseline: the message says so already
  }
}

void SceneTest::keepPictures() {
  if (options_.artifacts.empty()) return;
  for (std::size_t i = 0; i < result_.frames.size(); ++i) {
    FrameResult& frame = result_.frames[i];
    const frame::Image& made = run_.frames[i].image;
    if (other_ && other_->frames[i].pixels != run_.frames[i].pixels) {
      const frame::Image& other = other_->frames[i].image;
      frame.status = Status::nondeterministic;
      frame.message = "two runs of this program differ; shown are the first and the second";
      const std::string number = fmt::format("{:06}", frame.frame);
      frame.expectedImage = keep(number + ".run1.png", made);
      frame.actualImage = keep(number + ".run2.png", other);
      frame.differenceImage = keep(number + ".difference.png", differenceImage(made, other));
    } else if (frame.status != Status::pass && frame.status != Status::updated) {
      keepPicture(frame, made);
    }
  }
}

/// Everything that `simreel accept` would promote, laid out as the baselines are.
void SceneTest::keepCandidate() {
  const bool acceptable = result_.status == Status::fail || result_.status == Status::missing;
  if (!acceptable || checkFails()) return;
  const bool withState = stateIs("different") || stateIs("missing");
  Candidate made = candidate(withState);
  for (const RunFrame& frame : run_.frames) made.png[frame.frame] = frame::encodePng(frame.image, {});
  const std::string profile = profileToPromote();
  const fs::path folder = options_.artifacts / result_.name / "candidate";
  promote(folder, profile, made, {"", false, false});
  result_.candidate = folder.lexically_relative(options_.reportFolder).generic_string();
  for (FrameResult& frame : result_.frames)
    if (frame.status != Status::pass)
      frame.actualImage = result_.candidate + "/" + profile + "/" + pictureName(frame.frame);
}

}  // namespace simreel::golden
