// Output of a scene's test: updated baselines, and the files that the report and `simreel accept` need.
#include "base/file.hpp"
#include "base/text.hpp"
#include "golden/baseline/stale.hpp"
#include "golden/compare/difference_image.hpp"
#include "golden/suite/scene_test.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace simreel::golden {

namespace fs = std::filesystem;

namespace {

std::string listOf(const std::set<int>& frames) {
  std::string text;
  for (const int frame : frames) text += (text.empty() ? "" : ", ") + std::to_string(frame);
  return text;
}

/// Returns text such as "run 2" or "runs 1, 3".
std::string runsText(const std::vector<int>& numbers) {
  return fmt::format("run{} {}", numbers.size() == 1 ? "" : "s", fmt::join(numbers, ", "));
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
  if (exactPictures_) return sharedProfile;
  if (!options_.profile.empty()) return options_.profile;
  return profileToWrite(reference_.folder, device_.profile, device_.origin.numerics);
}

void SceneTest::update() {
  if (result_.status == Status::pass) {
    // The output of a pass may have changed without changing the picture.
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
  if (missing && !result_.renamedFrom.empty()) return takeFormerBaseline();
  const std::string profile = profileToPromote();
  std::set<int> written;
  for (const FrameResult& frame : result_.frames)
    if ((missing && frame.expectedPixels.empty()) || (changed && failedPictures_.contains(frame.frame)))
      written.insert(frame.frame);
  const bool writeState =
      (changed && (stateIs("different") || damagedSteps_)) || (missing && stateIs("missing"));
  if (written.empty() && !writeState) return;
  // The next run uses only this profile, so a new profile must contain all frames.
  if (!written.empty() && profile != result_.profile) written.insert(frames_.begin(), frames_.end());

  Candidate made = candidate(writeState);
  if (!writeState) made.state.frames.clear();
  for (const RunFrame& frame : run_.frames)
    if (written.contains(frame.frame)) made.png[frame.frame] = frame::encodePng(frame.image, {});
  promote(reference_.folder, profile, made, {options_.reason, false, !changed});

  judgeAgain(profile);
  result_.notes.push_back(
      fmt::format("wrote {}{}{} to {}", written.empty() ? "" : "frames " + listOf(written),
                  !written.empty() && writeState ? " and " : "", writeState ? "the state" : "",
                  (reference_.folder / profile).generic_string()));
}

fs::path SceneTest::artifacts() const {
  const fs::path folder = options_.artifacts / result_.name;
  return options_.retries > 0 ? folder / fmt::format("attempt{}", attempt_) : folder;
}

/// Judges all frames again with the baseline that was just written. All frames must now pass.
void SceneTest::judgeAgain(const std::string& profile) {
  const auto before = std::exchange(result_.frames, {});
  const scene::Tolerance tolerance = reference_.tolerance;
  reference_ = findReference(reference_.folder, profile, reference_.exact, origin_);
  reference_.tolerance = tolerance;
  describeBaseline();
  result_.divergence.reset();
  result_.messages.clear();
  result_.status = Status::pass;
  failedPictures_.clear();
  damagedSteps_ = damaged_ = false;
  judge();
  for (std::size_t i = 0; i < before.size(); ++i)
    if (before[i].status != Status::pass && result_.frames[i].status == Status::pass)
      result_.frames[i].status = Status::updated;
  if (result_.status == Status::pass) result_.status = Status::updated;
}

/// Moves the baselines of the scene's former name to the new name, with their alternates, tolerances and
/// reasons.
void SceneTest::takeFormerBaseline() {
  makeFolders(reference_.folder.parent_path());
  std::error_code error;
  fs::rename(result_.renamedFrom, reference_.folder, error);
  if (error)
    fail(ExitCode::inputOutput, "cannot move {} to {}: {}", result_.renamedFrom, result_.baselines,
         error.message());
  judgeAgain(profile_);
  result_.notes.push_back(fmt::format("moved {} to {}", result_.renamedFrom, result_.baselines));
}

std::string SceneTest::keep(const std::string& name, const frame::Image& image) const {
  const fs::path file = artifacts() / name;
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
    if (error.code() != ExitCode::inputOutput) throw;  // An unreadable baseline has already been reported.
  }
}

/// Stores each different picture of one frame that runs of this program produced. Returns false if all
/// these pictures are equal.
bool SceneTest::keepRuns(std::size_t index) {
  struct Made {
    const RunFrame* frame;
    std::vector<int> runs;
  };
  std::vector<Made> all = {{&run_.frames[index], likeFirst_}};
  for (const OtherRun& other : others_) {
    const RunFrame& made = other.run.frames[index];
    const auto known = std::find_if(all.begin(), all.end(),
                                    [&](const Made& one) { return one.frame->pixels == made.pixels; });
    if (known == all.end())
      all.push_back({&made, other.numbers});
    else
      known->runs.insert(known->runs.end(), other.numbers.begin(), other.numbers.end());
  }
  if (all.size() < 2) return false;
  FrameResult& frame = result_.frames[index];
  const std::string number = fmt::format("{:06}", frame.frame);
  for (const Made& one : all)
    frame.others.push_back({runsText(one.runs),
                            keep(fmt::format("{}.run{}.png", number, one.runs.front()), one.frame->image)});
  frame.status = Status::nondeterministic;
  frame.message = fmt::format("runs of this program differ; shown are {} and {}", all[0].runs.front(),
                              all[1].runs.front());
  frame.expectedImage = frame.others[0].image;
  frame.actualImage = frame.others[1].image;
  frame.differenceImage =
      keep(number + ".difference.png", differenceImage(all[0].frame->image, all[1].frame->image));
  return true;
}

void SceneTest::keepPictures() {
  if (options_.artifacts.empty()) return;
  for (std::size_t i = 0; i < result_.frames.size(); ++i) {
    FrameResult& frame = result_.frames[i];
    const frame::Image& made = run_.frames[i].image;
    if (keepRuns(i)) continue;
    if (frame.status != Status::pass && frame.status != Status::updated) keepPicture(frame, made);
  }
}

/// Stores everything that `simreel accept` would promote, in the layout of a baseline folder.
void SceneTest::keepCandidate() {
  const bool acceptable = result_.status == Status::fail || result_.status == Status::missing;
  // A damaged baseline must be restored, not replaced.
  if (!acceptable || checkFails() || damaged_) return;
  const bool withState = stateIs("different") || stateIs("missing");
  Candidate made = candidate(withState);
  for (const RunFrame& frame : run_.frames) made.png[frame.frame] = frame::encodePng(frame.image, {});
  const std::string profile = profileToPromote();
  const fs::path folder = artifacts() / "candidate";
  promote(folder, profile, made, {"", false, false});
  result_.candidate = folder.lexically_relative(options_.reportFolder).generic_string();
  result_.inputs = inputs_;
  for (FrameResult& frame : result_.frames)
    if (frame.status != Status::pass)
      frame.actualImage = result_.candidate + "/" + profile + "/" + pictureName(frame.frame);
}

}  // namespace simreel::golden
