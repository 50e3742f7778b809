// What a test of a scene writes: baselines when asked, and what a report and `simreel accept` need.
#include "base/file.hpp"
#include "golden/compare.hpp"
#include "golden/scene_test.hpp"

#include <algorithm>

namespace simreel::golden {

namespace fs = std::filesystem;

namespace {

std::string listOf(const std::set<int>& frames) {
  std::string text;
  for (const int frame : frames) text += (text.empty() ? "" : ", ") + std::to_string(frame);
  return text;
}

}  // namespace

bool SceneTest::stateIs(const char* what) const {
  return std::any_of(result_.frames.begin(), result_.frames.end(),
                     [&](const FrameResult& f) { return f.state == what; });
}

bool SceneTest::checkFails() const {
  return std::any_of(result_.checks.begin(), result_.checks.end(),
                     [](const CheckResult& check) { return !check.passed; });
}

std::string SceneTest::profileToPromote() const {
  if (!options_.profile.empty()) return options_.profile;
  return profileToWrite(reference_.folder, device_.profile, device_.origin.numerics);
}

void SceneTest::update() {
  if (result_.status == Status::pass) return;
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
  reference_ = findReference(reference_.folder, profile, reference_.exact, device_.origin);
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
