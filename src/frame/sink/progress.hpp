#pragma once
#include "base/clock.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace simreel::frame {

/// Time (s) spent so far in each stage.
struct StageTimes {
  double simulate = 0;
  double draw = 0;
  double readBack = 0;
  double encode = 0;  ///< CPU time of other threads that encode frames
  double start = 0;   ///< time before the first step, for device, shaders and textures
  double wait = 0;    ///< time spent waiting for encoders, ffmpeg or the disk
};

/// Listener to the events of a run. The functions of this class do nothing.
class RunListener {
 public:
  virtual ~RunListener() = default;
  /// The run begins. `total`: number of its frames.
  virtual void start(int /*total*/) {}
  /// Reports the progress of the pre-roll steps before the first frame.
  virtual void prepare(long /*done*/, long /*total*/) {}
  /// Reports that a frame is done or already existed. `stages`: times of the frame and of preceding frames
  /// that are not written. `stages.encode`: encoding time of any frames since the last call, because
  /// encoding runs in parallel.
  virtual void frame(int /*number*/, const StageTimes& /*stages*/) {}
  /// Reports the current counts. `names` and `row` are comma separated.
  virtual void counts(int /*frame*/, std::string_view /*names*/, std::string_view /*row*/) {}
  /// All frames are delivered, and the files are completed next.
  virtual void clear() {}
  /// The run has ended. `status`: "ok", "interrupted" or "failed". `stages`: times of the whole run.
  virtual void finish(const char* /*status*/, const StageTimes& /*stages*/) {}
};

/// Reports the progress of a run on standard error. Not thread-safe.
class Progress final : public RunListener {
 public:
  enum class Mode { automatic, terminal, ndjson, none };

  /// `automatic`: shows a bar on a terminal, and otherwise nothing. Tests pass another `descriptor`.
  explicit Progress(Mode mode, int descriptor = 2);
  void start(int total) override;
  void prepare(long done, long total) override;
  void frame(int number, const StageTimes& stages) override;
  /// Reports the result of a check of the scene.
  void check(const std::string& what, int frame, std::optional<double> value, bool passed);
  /// Reports the current counts, only in mode ndjson.
  void counts(int frame, std::string_view names, std::string_view row) override;
  /// Writes an event given as a JSON object, only in mode ndjson.
  void event(const std::string& object) const;
  /// True if events are written (mode ndjson).
  [[nodiscard]] bool tellsEvents() const { return mode_ == Mode::ndjson; }
  /// Adds the name of a job to all following events, because several jobs write to the same output.
  void ofJob(std::string job) { job_ = std::move(job); }
  /// Clears the bar, before other messages are printed.
  void clear() override;
  /// Clears the bar and, in mode ndjson, writes the event "end".
  void finish(const char* status, const StageTimes& stages) override;

 private:
  void print();
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

/// Parses "auto", "tty", "ndjson" or "none". Throws UserError(usage).
[[nodiscard]] Progress::Mode parseProgressMode(const std::string& text);

/// Returns the text of the progress bar, at most `width` columns wide.
[[nodiscard]] std::string progressLine(int done, int total, double seconds, int width);

/// Returns the summary line: "120 frames in 9.8 s (12.2 frames/s): start 0.8 s, simulate 2.1 s, draw 5.9 s,
/// read back 0.3 s, encode 1.6 s, wait 0.7 s -> WHERE"
[[nodiscard]] std::string closingLine(int frames, double seconds, const StageTimes& stages,
                                      const std::string& where);

/// Formats a duration: "9.8 s", "3 min 05 s", "2 h 04 min".
[[nodiscard]] std::string formatDuration(double seconds);

}  // namespace simreel::frame
