#pragma once
#include "base/error.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::golden {

/// How a scene (or one frame of it) came out. The JSON report spells them as statusName() does.
enum class Status {
  pass,
  updated,           ///< baselines were written, as asked
  xfail,             ///< failed as the scene expects
  flaky,             ///< failed, then passed on a retry
  fail,              ///< pixels, state or a check differ
  nondeterministic,  ///< two runs of the same program differ
  missing,           ///< no baseline
  xpass,             ///< expected to fail, but passed
  error,             ///< scene or baseline cannot be used, or the device lost the state
};
inline constexpr int statusCount = 9;
/// What is said of it.
struct StatusWords {
  const char* name;     ///< in reports
  const char* counted;  ///< after a number of scenes
  const char* reason;   ///< of a scene that has no messages
};
[[nodiscard]] const StatusWords& wordsOf(Status status);
[[nodiscard]] inline const char* statusName(Status status) {
  return wordsOf(status).name;
}
/// Nothing for a word that is no status.
[[nodiscard]] std::optional<Status> statusOfName(std::string_view name);
/// Whether a scene that came out so makes the run fail. A flaky one does unless --allow-flaky was given.
[[nodiscard]] bool isFailure(Status status, bool allowFlaky);

/// What is measured between two pictures of equal size. Ratios and FLIP are 0 to 1; x grows right, y down.
struct Metrics {
  double worst = 0;            ///< largest difference of one channel, 0 to 255; fractions in deep pictures
  int worstX = 0, worstY = 0;  ///< where
  long differentPixels = 0;    ///< with any difference
  long pixelsBeyond = 0;       ///< with a channel further apart than maxChannelDiff
  double ratioBeyond = 0;      ///< pixelsBeyond / pixels
  double windowRatio = 0;      ///< fraction of pixelsBeyond in the densest window
  int windowX = 0, windowY = 0;    ///< its top left corner
  double psnr = 0;                 ///< dB over R, G and B; infinite when equal (null in JSON)
  std::optional<double> ssim = 1;  ///< nothing: not measured (null in JSON), as is
  std::optional<double> flipMean = 0;
  /// Pixels that do not count: inside masks, of smoothed edges, found nearby.
  long maskedPixels = 0, antialiasedPixels = 0, movedPixels = 0;
  bool operator==(const Metrics&) const = default;
};

/// Where a picture leaves its baseline.
struct PassPlace {
  std::string pass;  ///< the first whose hash differs; empty: the baseline knows none
  int x = 0,
      y = 0;  ///< a pixel that differs from the baseline's picture: the first that shows one thing only
  std::string shows;    ///< and what is visible there: "triangle 12 of flag"
  std::string message;  ///< one line
  bool operator==(const PassPlace&) const = default;
};

/// A picture beside those that are compared: of another attempt or run, under its number.
struct OtherPicture {
  std::string label;  ///< "attempt 1", "run 3"
  std::string image;  ///< relative to the folder of report.json
  bool operator==(const OtherPicture&) const = default;
};

struct FrameResult {
  int frame = 0;
  double time = 0;  ///< s
  Status status = Status::pass;
  std::string message;                 ///< one line, empty when it passed
  std::string pixels, expectedPixels;  ///< hashes; expected is empty without a baseline
  int alternate = 0;  ///< 0: the baseline itself; n: its n-th accepted alternate was nearest
  std::string state;  ///< "equal", "different", "missing", "not compared"
  /// Of its pixels: askedName() in golden/baseline/origin.hpp; empty without a baseline.
  std::string asked;
  std::optional<Metrics> metrics;  ///< of pictures that were compared pixel by pixel
  std::optional<PassPlace> pass;   ///< of an exact picture that fails where the state is equal
  /// Relative to the folder of report.json; empty where there is none.
  std::string expectedImage, actualImage, differenceImage;
  std::string flipImage;  ///< FLIP's map
  std::vector<OtherPicture> others;
  bool operator==(const FrameResult&) const = default;
};

struct CheckResult {
  std::string what;  ///< "energy of flag", "max of flag positions.y", "not-blank"
  int frame = 0;
  std::optional<double> value, min, max;
  bool passed = true;
  std::string message;  ///< "frame 60: energy of flag is 3.1, above 3" when it failed
  bool operator==(const CheckResult&) const = default;
};

/// Where a run first leaves the baseline's state.
struct Divergence {
  int frame = 0;  ///< the frame that is being stepped to; negative during pre-roll
  int step = 0;   ///< of the frame, from 1; 0: known to the frame only
  int steps = 0;  ///< steps a frame
  std::string object, buffer;
  /// The first block that differs; equal when one element is known.
  long firstElement = 0, lastElement = 0;
  std::string message;
  bool operator==(const Divergence&) const = default;
};

/// One tolerance bound: its value and who said so ("default", "assets/scenes/flag.json",
/// "--max-diff-ratio").
struct Bound {
  double value = 0;
  std::string origin;
  bool operator==(const Bound&) const = default;
};

struct Attempt {
  Status status = Status::pass;
  std::vector<std::string> messages;
  bool operator==(const Attempt&) const = default;
};

/// What somebody wrote that a result is about.
struct Place {
  std::string file;
  int line = 1;  ///< from 1
  bool operator==(const Place&) const = default;
};

struct SceneResult {
  std::string name;  ///< unique in the run: the scene's path below the folder, without extension
  std::string file;
  std::string baselines;  ///< folder of the scene's baselines
  Status status = Status::pass;
  std::vector<std::string> messages;  ///< why it failed, one line each
  std::vector<std::string> notes;     ///< worth knowing: a fallback, a tolerance much looser than needed
  std::string xfail;                  ///< the scene's reason
  std::string profile;                ///< the one whose baselines were used; empty: none
  std::string asked;                  ///< the least that is asked of a frame's pixels; empty: no baseline
  /// Of the run that wrote last; processor: empty where it is not known.
  std::string baselineDriver, baselineProcessor, baselineVersion, baselineReason;
  std::map<std::string, Bound> tolerance;  ///< by field name, those in force
  double seconds = 0;                      ///< in all
  double simulateSeconds = 0;              ///< of it stepping the simulation
  int repeats = 0;
  std::vector<Attempt> attempts;  ///< failed tries before the last, with --retries
  std::vector<FrameResult> frames;
  std::vector<CheckResult> checks;
  std::optional<Divergence> divergence;
  /// Folder with what `simreel accept` would promote, relative to report.json; or empty.
  std::string candidate;
  /// Of what has a candidate: the files that the scene was made of, and their hashes (baseline/inputs.hpp).
  std::map<std::string, std::string> inputs;
  std::optional<Place> blame;  ///< of a scene that did not pass
  /// Of a picture without a baseline: the baseline without a picture that has its pixels; or empty.
  std::string renamedFrom;
  bool operator==(const SceneResult&) const = default;
};

/// A baseline that nothing was tested against.
struct Stale {
  std::string path;
  std::string message;  ///< one line
  bool removed = false;
  bool operator==(const Stale&) const = default;
};

/// What the test of one scene makes of it.
struct Outcome {
  SceneResult scene;
  ExitCode error = ExitCode::ok;  ///< what kept a scene of Status::error from being tested
  bool hardFailed = false;        ///< on some try: nothing excuses that
  std::vector<Stale> stale;       ///< what of its baselines nothing was tested against
};

struct SuiteResult {
  std::string version;
  std::string unit = "scene";  ///< what was tested: "scene" or "picture"
  std::string expected;        ///< of pictures: the folder of the baselines
  /// Of this run; fingerprints of numerics and of drawing.
  std::string driver, processor, profile, fingerprint, drawing, memoryPath;
  std::string command;        ///< as typed
  std::string shard;          ///< "2/4" where this is a part of a run; empty: all of it
  std::string acceptCommand;  ///< to promote this run; empty where nothing was kept
  bool allowFlaky = false;    ///< a flaky scene does not fail the run
  bool strict = false;        ///< stale baselines fail the run
  double seconds = 0;
  std::vector<std::string> notes;  ///< of the run as a whole
  std::vector<Stale> stale;
  std::vector<SceneResult> scenes;
  bool operator==(const SuiteResult&) const = default;
};

}  // namespace simreel::golden
