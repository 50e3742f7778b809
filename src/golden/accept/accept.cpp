#include "golden/accept/accept.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "golden/accept/accept_picture.hpp"
#include "golden/baseline/baseline.hpp"
#include "golden/baseline/inputs.hpp"
#include "golden/files/png_check.hpp"
#include "golden/report/json.hpp"
#include "golden/result.hpp"
#include "golden/suite/scene_set.hpp"

#include <algorithm>

namespace simreel::golden {

namespace fs = std::filesystem;

namespace {

/// Returns the profile of a candidate. This is the name of the only folder in the candidate that has a
/// baseline.json.
std::string profileOf(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (pathExists(entry.path() / "baseline.json")) return entry.path().filename().string();
  fail(ExitCode::inputOutput, "{} is gone or incomplete; run the test again with --report",
       folder.string());
}

Candidate readCandidate(const fs::path& folder, const SceneResult& scene) {
  const std::string profile = profileOf(folder);
  Candidate kept;
  kept.pictures = *readPictures(folder, profile);
  kept.exact = !pathExists(folder / profile / "state.json");
  const fs::path statePlace = stateFolder(folder, profile, kept.exact);
  if (auto state = readState(statePlace)) kept.state = *state;
  kept.steps = readSteps(statePlace);
  for (const FrameResult& frame : scene.frames) {
    const auto listed = kept.pictures.frames.find(frame.frame);
    const fs::path file = folder / profile / pictureName(frame.frame);
    if (listed == kept.pictures.frames.end() || listed->second.pixels != frame.pixels ||
        frame::pixelHash(readPng(file, "picture")) != frame.pixels)
      fail(ExitCode::inputOutput, "{} does not have the pixels of that run; run the test again",
           file.string());
    const std::string bytes = readFile(file, "picture");
    const auto span = std::as_bytes(std::span(bytes.data(), bytes.size()));
    kept.png[frame.frame] = {span.begin(), span.end()};
  }
  return kept;
}

/// Throws UserError(usage) if another update has happened since the run. In that case a frame's baseline is
/// neither the one that the report lists nor the stored picture.
void checkBaseline(const SceneResult& scene, const Candidate& kept) {
  const auto current =
      scene.profile.empty() ? std::nullopt : readPictures(baselineFolder(scene.file), scene.profile);
  for (const FrameResult& frame : scene.frames) {
    std::string now;
    if (current)
      if (const auto found = current->frames.find(frame.frame); found != current->frames.end())
        now = found->second.pixels;
    if (now != frame.expectedPixels && now != kept.pictures.frames.at(frame.frame).pixels)
      fail(ExitCode::usage, "the baseline of frame {} has changed since that run; run the test again",
           frame.frame);
  }
}

/// Removes frames that passed from the candidate, so that they keep their baselines.
void leaveOutPassed(const SceneResult& scene, const std::string& profile, Candidate& kept) {
  // A new profile must be complete, so frames that passed are promoted, too.
  if (profile != scene.profile) return;
  for (const FrameResult& frame : scene.frames)
    if (frame.status == Status::pass || frame.pixels == frame.expectedPixels) kept.png.erase(frame.frame);
}

bool holdsAlready(const fs::path& folder, const std::string& profile, const Candidate& kept) {
  const auto pictures = readPictures(folder, profile);
  const auto state = readState(stateFolder(folder, profile, kept.exact));
  const bool samePictures = std::all_of(kept.png.begin(), kept.png.end(), [&](const auto& entry) {
    return pictures && pictures->frames.contains(entry.first) &&
           pictures->frames.at(entry.first).pixels == kept.pictures.frames.at(entry.first).pixels;
  });
  const bool sameState =
      std::all_of(kept.state.frames.begin(), kept.state.frames.end(), [&](const auto& entry) {
        return state && state->frames.contains(entry.first) &&
               state->frames.at(entry.first) == entry.second;
      });
  return samePictures && sameState;
}

Accepted acceptScene(const fs::path& reportFolder, const SceneResult& scene, const Acceptance& how) {
  Accepted result{scene.name, "", false};
  try {
    if (scene.candidate.empty())
      fail(ExitCode::usage, "{}: the report contains no results to accept",
           scene.messages.empty() ? statusName(scene.status) : scene.messages.front());
    // The baseline folder is derived from the scene. The report must not choose it, because it may come
    // from an untrusted place.
    const fs::path baselines = baselineFolder(scene.file);
    if (!liesBelow(scene.file, how.scenes) || !liesBelow(baselines, how.scenes))
      fail(ExitCode::usage,
           "its baselines would be written to {}, which is outside of {}; if the report may write there, "
           "allow it with --scenes FOLDER",
           baselines.string(), how.scenes.empty() ? "this folder" : how.scenes);
    if (!pathExists(scene.file))
      fail(ExitCode::usage, "there is no {} here; accept from the folder in which the test ran",
           scene.file);
    if (!scene.inputs.contains(scene.file))
      fail(ExitCode::usage, "the report has no hash of {}; run the test again", scene.file);
    checkUnchanged(scene.inputs);
    const fs::path folder = reportFolder / scene.candidate;
    Candidate kept = readCandidate(folder, scene);
    checkBaseline(scene, kept);
    const std::string profile = profileOf(folder);
    leaveOutPassed(scene, profile, kept);
    result.already = holdsAlready(baselines, profile, kept);
    if (!result.already) promote(baselines, profile, kept, {how.reason, how.alternate, how.alternate});
  } catch (const UserError& mistake) {
    result.problem = mistake.what();
  }
  return result;
}

}  // namespace

std::vector<Accepted> acceptReport(const fs::path& report, const Acceptance& how) {
  std::error_code ignored;
  const fs::path file = fs::is_directory(report, ignored) ? report / "report.json" : report;
  const SuiteResult suite = parseReport(readFile(file, "report"), file.string());
  const bool pictures = suite.unit == "picture";
  const char* const idle = pictures               ? !how.reason.empty()   ? "--reason"
                                                    : how.alternate       ? "--alternate"
                                                    : !how.scenes.empty() ? "--scenes"
                                                                          : nullptr
                           : how.expected.empty() ? nullptr
                                                  : "--expected";
  if (idle != nullptr)
    fail(ExitCode::usage, "{} has no effect on {}, a report about {}", idle, file.string(),
         pictures ? "pictures" : "scenes");
  const fs::path expected = pictures ? expectedFolder(suite, how) : fs::path();
  std::vector<Accepted> all;
  for (const SceneResult& scene : suite.scenes) {
    const bool named =
        how.only.empty() || std::any_of(how.only.begin(), how.only.end(),
                                        [&](const auto& glob) { return matches(glob, scene.name); });
    const bool accepted = !isFailure(scene.status, /*allowFlaky=*/true);
    if (!named || accepted) continue;
    all.push_back(pictures ? acceptPicture(file.parent_path(), scene, expected, how.expected.empty())
                           : acceptScene(file.parent_path(), scene, how));
  }
  return all;
}

}  // namespace simreel::golden
