#pragma once
#include "base/clock.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace simreel::frame {

/// Seconds spent so far in each stage.
struct StageTimes {
  double simulate = 0;
  double draw = 0;
  double readBack = 0;
  double encode = 0;  ///< processor time of other threads
  double start = 0;   ///< device, shaders, textures: all before the first step
  double wait = 0;    ///< for encoders, ffmpeg or the disk
};

/// How far a run is, on standard error. Use from one thread.
class Progress {
 public:
  enum class Mode { automatic, terminal, ndjson, none };

  /// `automatic` shows a bar on a terminal and nothing when piped. The descriptor is for tests.
  explicit Progress(Mode mode, int descriptor = 2);
  void start(int total);
  /// How far the steps before the first frame are.
  void prepare(long done, long total);
  /// One frame is done (or was already there). `stages` are its times, and those of frames before it that
  /// are not wanted; encode is that of other frames: it goes on beside, and is what was done since the last
  /// call.
  void frame(int number, const StageTimes& stages);
  /// A check of the scene was made.
  void check(const std::string& what, int frame, std::optional<double> value, bool passed);
  /// Counts as they are now: names and numbers, comma separated.
  void counts(int frame, std::string_view names, std::string_view row);
  /// An event of somebody else's making, a JSON object; ndjson only.
  void event(const std::string& object) const;
  /// Whether anybody reads events: ndjson.
  [[nodiscard]] bool tellsEvents() const { return mode_ == Mode::ndjson; }
  /// From here on each event says that it is of this job of several.
  void ofJob(std::string job) { job_ = std::move(job); }
  /// Clears the bar, before messages that come after it.
  void clear();
  /// Clears the bar. `status` is "ok", "interrupted" or "failed"; `stages` are the times of the whole run.
  void finish(const char* status = "ok", const StageTimes& stages = {});

 private:
  void show();
  void write(const std::string& text) const;

  Mode mode_;
  int descriptor_;
  std::string job_;
  int total_ = 0;
  int done_ = 0;
  bool shown_ = false;
  Clock::time_point begin_;
  Clock::time_point lastShown_;
};

/// "auto", "tty", "ndjson" or "none". Throws UserError(usage).
[[nodiscard]] Progress::Mode parseProgressMode(const std::string& text);

/// The bar, at most `width` columns wide.
[[nodiscard]] std::string progressLine(int done, int total, double seconds, int width);

/// "120 frames in 9.8 s (12.2 frames/s): start 0.8 s, simulate 2.1 s, draw 5.9 s, read back 0.3 s,
/// encode 1.6 s, wait 0.7 s -> WHERE"
[[nodiscard]] std::string closingLine(int frames, double seconds, const StageTimes& stages,
                                      const std::string& where);

/// "9.8 s", "3 min 05 s", "2 h 04 min".
[[nodiscard]] std::string formatDuration(double seconds);

}  // namespace simreel::frame
