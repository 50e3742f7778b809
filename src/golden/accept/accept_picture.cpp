#include "golden/accept/accept_picture.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "golden/baseline/inputs.hpp"
#include "golden/files/picture.hpp"

#include <algorithm>
#include <span>

namespace simreel::golden {

namespace fs = std::filesystem;

namespace {

/// True if the path is relative and does not leave the folder to which it is appended.
bool staysBelow(const fs::path& path) {
  return !path.empty() && !path.is_absolute() && std::find(path.begin(), path.end(), "..") == path.end() &&
         path.native().find('\0') == std::string::npos;
}

std::string hashOf(const fs::path& file, const char* what) {
  return pathExists(file) ? pictureHash(readPicture(file, what)) : std::string();
}

void promotePicture(const fs::path& kept, const SceneResult& picture, const fs::path& expected,
                    bool confined, Accepted& result) {
  const FrameResult& frame = picture.frames.front();
  std::string bytes;
  readBytes(kept, "picture", bytes);
  if (pictureHash(decodePicture(bytes, "picture", kept.string())) != frame.pixels)
    fail(ExitCode::inputOutput, "{} does not have the pixels of that run; run the test again",
         kept.string());
  const fs::path baseline = expected / picture.name;
  if (confined && !liesBelow(baseline, {}))
    fail(ExitCode::usage,
         "{} is outside of this folder; if the report may write there, allow it with --expected",
         baseline.string());
  const fs::path former = picture.renamedFrom.empty() ? fs::path() : expected / picture.renamedFrom;
  const std::string now = hashOf(baseline, "baseline");
  result.already = now == frame.pixels && (former.empty() || !pathExists(former));
  if (result.already) return;
  // A renamed picture does not have a baseline under its new name yet.
  const std::string seen = former.empty() ? frame.expectedPixels : std::string();
  if (now != seen && now != frame.pixels)
    fail(ExitCode::usage, "the baseline {} has changed since that run; run the test again",
         baseline.string());
  if (!former.empty() && pathExists(former) && hashOf(former, "baseline") != frame.expectedPixels)
    fail(ExitCode::usage, "the baseline {} has changed since that run; run the test again",
         former.string());
  makeFolders(baseline.parent_path());
  writeFileAtomically(baseline, std::as_bytes(std::span(bytes)));
  if (!former.empty()) removeFile(former);
}

}  // namespace

fs::path expectedFolder(const SuiteResult& suite, const Acceptance& how) {
  if (!how.reason.empty() || how.alternate)
    fail(ExitCode::usage, "--reason and --alternate are for scenes, and this report is of pictures");
  fs::path folder = how.expected.empty() ? suite.expected : how.expected;
  if (how.expected.empty() && !staysBelow(folder))
    fail(
        ExitCode::usage,
        "the baselines of this report are in {}, which is outside of this folder; allow it with --expected",
        suite.expected.empty() ? "no folder" : suite.expected);
  std::error_code unknown;
  if (!fs::is_directory(folder, unknown))
    fail(ExitCode::usage,
         "there is no folder {} here; accept from the folder in which the test ran, or give --expected",
         folder.string());
  return folder;
}

Accepted acceptPicture(const fs::path& reportFolder, const SceneResult& picture, const fs::path& expected,
                       bool confined) {
  Accepted result{picture.name, "", false};
  try {
    if (picture.candidate.empty() || picture.frames.empty())
      fail(ExitCode::usage, "{}: the report contains no picture to accept",
           picture.messages.empty() ? statusName(picture.status) : picture.messages.front());
    if (!staysBelow(picture.name) || !isPictureName(picture.name) ||
        (!picture.renamedFrom.empty() &&
         !(staysBelow(picture.renamedFrom) && isPictureName(picture.renamedFrom))))
      fail(ExitCode::usage, "the report names no picture below {}", expected.string());
    checkUnchanged(picture.inputs);
    promotePicture(reportFolder / picture.candidate / fs::path(picture.name).filename(), picture, expected,
                   confined, result);
  } catch (const UserError& mistake) {
    result.problem = mistake.what();
  }
  return result;
}

}  // namespace simreel::golden
