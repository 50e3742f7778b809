#pragma once
#include "base/error.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::golden {

/// Result of testing a scene or one of its frames. statusName() gives the spelling in JSON reports.
enum class Status {
  pass,
  updated,           ///< baselines were written, as requested by --update
  xfail,             ///< failed, as the scene expects
  flaky,             ///< passed on a retry after it failed first
  fail,              ///< failed: pixels, state or a check differs
  nondeterministic,  ///< nondeterministic: two runs of the same program differ
  missing,           ///< there is no baseline
  xpass,             ///< passed although the scene expects a failure
  error,             ///< scene or baseline is unusable, or the device lost the state
};
inline constexpr int statusCount = 9;
/// Words that describe a status in reports.
struct StatusWords {
  const char* name;     ///< name of the status in reports
  const char* counted;  ///< words used after a number of scenes, such as "failed"
  const char* reason;   ///< message for scenes that have no messages
};
[[nodiscard]] const StatusWords& wordsOf(Status status);
[[nodiscard]] inline const char* statusName(Status status) {
  return wordsOf(status).name;
}
/// Returns the status with this name, or nothing for an unknown name.
[[nodiscard]] std::optional<Status> statusOfName(std::string_view name);
/// True if a scene with this status makes the whole run fail. A flaky scene makes it fail unless
/// `allowFlaky`.
[[nodiscard]] bool isFailure(Status status, bool allowFlaky);

/// Measured differences between two pictures of equal size. Ratios and FLIP errors are from 0 to 1. x grows
/// to the right, y downwards.
struct Metrics {
  /// largest difference of one channel, 0 to 255; fractional for pictures with more than 8 bits per channel
  double worst = 0;
  int worstX = 0, worstY = 0;  ///< coordinates of the pixel with the largest difference
  long differentPixels = 0;    ///< number of pixels with any difference
  /// number of pixels with a channel that differs by more than maxChannelDiff
  long pixelsBeyond = 0;
  double ratioBeyond = 0;          ///< pixelsBeyond divided by the number of pixels
  double windowRatio = 0;          ///< fraction of pixelsBeyond in the densest window
  int windowX = 0, windowY = 0;    ///< pixel coordinates of the top left corner of the densest window
  double psnr = 0;                 ///< PSNR (dB) over R, G and B; infinite if the pictures are equal (null
                                   ///< in JSON)
  std::optional<double> ssim = 1;  ///< structural similarity; empty if not measured (null in JSON)
  std::optional<double> flipMean = 0;
  /// Number of ignored pixels: inside masks, on antialiased edges, or found within the search radius.
  long maskedPixels = 0, antialiasedPixels = 0, movedPixels = 0;
  bool operator==(const Metrics&) const = default;
};

/// First pass and pixel at which a picture differs from its baseline.
struct PassPlace {
  std::string pass;  ///< first pass whose hash differs; empty if the baseline has no pass hashes
  /// Coordinates of the first differing pixel whose samples all show the same object and primitive, or of
  /// the first differing pixel if there is no such pixel.
  int x = 0, y = 0;
  std::string shows;    ///< object and primitive visible at the pixel: "triangle 12 of flag"
  std::string message;  ///< description of the difference in one line
  bool operator==(const PassPlace&) const = default;
};

/// Picture of another attempt or run, shown next to the compared pictures.
struct OtherPicture {
  std::string label;  ///< label such as "attempt 1", "run 3"
  std::string image;  ///< path of the picture, relative to the folder of report.json
  bool operator==(const OtherPicture&) const = default;
};

struct FrameResult {
  int frame = 0;
  double time = 0;  ///< time of the frame in seconds
  Status status = Status::pass;
  std::string message;                 ///< reason for the status in one line; empty if the frame passed
  std::string pixels, expectedPixels;  ///< pixel hashes; `expectedPixels` is empty if there is no baseline
  /// number of the closest accepted alternate, from 1; 0 means the baseline itself
  int alternate = 0;
  std::string state;  ///< "equal", "different", "missing" or "not compared"
  /// How closely the pixels had to match: requiredMatchName() in golden/baseline/origin.hpp. Empty if there
  /// is no baseline.
  std::string asked;
  std::optional<Metrics> metrics;  ///< differences; empty unless the pictures were compared pixel by pixel
  /// place of the first difference, if an exact picture fails although the state is equal
  std::optional<PassPlace> pass;
  /// Paths relative to the folder of report.json. A path is empty if the picture does not exist.
  std::string expectedImage, actualImage, differenceImage;
  std::string flipImage;  ///< path of the FLIP error map
  std::vector<OtherPicture> others;
  bool operator==(const FrameResult&) const = default;
};

struct CheckResult {
  std::string what;  ///< description, such as "energy of flag", "max of flag positions.y", "not-blank"
  int frame = 0;
  std::optional<double> value, min, max;
  bool passed = true;
  std::string message;  ///< message if the check failed: "frame 60: energy of flag is 3.1, above 3"
  bool operator==(const CheckResult&) const = default;
};

/// First position at which the state of a run differs from the state in the baseline.
struct Divergence {
  int frame = 0;  ///< frame in which the state first differs; negative during pre-roll
  int step = 0;   ///< step within the frame, counted from 1; 0 if only the frame is known
  int steps = 0;  ///< number of simulation steps in the frame
  std::string object, buffer;
  /// Range of elements that contains the first difference. Both are equal if the element is known.
  long firstElement = 0, lastElement = 0;
  std::string message;
  bool operator==(const Divergence&) const = default;
};

/// One tolerance bound: its value and its origin ("default", "assets/scenes/flag.json",
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

/// File and line that caused a result.
struct Place {
  std::string file;
  int line = 1;  ///< line number, from 1
  bool operator==(const Place&) const = default;
};

struct SceneResult {
  std::string name;  ///< name that is unique within the run: path of the scene below the folder, without
                     ///< extension
  std::string file;
  std::string baselines;  ///< folder of the scene's baselines
  Status status = Status::pass;
  std::vector<std::string> messages;  ///< reasons for the failure, one line each
  /// remarks, such as a fallback or a tolerance that is much looser than needed
  std::vector<std::string> notes;
  std::string xfail;    ///< reason for the expected failure, from the scene
  std::string profile;  ///< profile whose baselines were used; empty if there were no baselines
  /// weakest requirement on the pixels of any frame; empty if there is no baseline
  std::string asked;
  /// Data of the latest run that wrote the baseline. The processor is empty if unknown.
  std::string baselineDriver, baselineProcessor, baselineVersion, baselineReason;
  std::map<std::string, Bound> tolerance;  ///< bounds that apply, by field name
  double seconds = 0;                      ///< total time for the scene (s)
  double simulateSeconds = 0;              ///< part of `seconds` spent stepping the simulation
  int repeats = 0;
  std::vector<Attempt> attempts;  ///< failed attempts before the last attempt, with --retries
  std::vector<FrameResult> frames;
  std::vector<CheckResult> checks;
  std::optional<Divergence> divergence;
  /// Folder with the data that `simreel accept` would promote, relative to report.json. Empty if there is
  /// nothing to promote.
  std::string candidate;
  /// If there is a candidate: the scene's input files and their hashes (baseline/inputs.hpp).
  std::map<std::string, std::string> inputs;
  std::optional<Place> blame;  ///< file and line that caused the result; set if the scene did not pass
  /// If the picture has no baseline: name of the baseline with equal pixels whose picture no longer exists.
  /// Empty if there is no such baseline.
  std::string renamedFrom;
  bool operator==(const SceneResult&) const = default;
};

/// A baseline that no test used.
struct Stale {
  std::string path;
  std::string message;  ///< reason why the baseline is stale, in one line
  bool removed = false;
  bool operator==(const Stale&) const = default;
};

/// Result of testing one scene.
struct Outcome {
  SceneResult scene;
  ExitCode error = ExitCode::ok;  ///< error that prevented the test, for Status::error
  /// true if any attempt had a pixel beyond the hardFail bound, which neither retries nor xfail permit
  bool hardFailed = false;
  std::vector<Stale> stale;  ///< the scene's baselines that no test used
};

struct SuiteResult {
  std::string version;
  std::string unit = "scene";  ///< kind of the tests: "scene" or "picture"
  std::string expected;        ///< for pictures: folder of the baselines
  /// Properties of the run. `fingerprint`: fingerprint of numerics; `drawing`: fingerprint of drawing.
  std::string driver, processor, profile, fingerprint, drawing, memoryPath;
  std::string command;        ///< command line of the run as typed
  std::string shard;          ///< "2/4" if this is part of a run; empty if it is the whole run
  std::string acceptCommand;  ///< command that accepts the run's results; empty if no results were stored
  bool allowFlaky = false;    ///< true if a flaky scene does not fail the run
  bool strict = false;        ///< true if stale baselines fail the run
  double seconds = 0;
  std::vector<std::string> notes;  ///< remarks about the run as a whole
  std::vector<Stale> stale;
  std::vector<SceneResult> scenes;
  bool operator==(const SuiteResult&) const = default;
};

}  // namespace simreel::golden
