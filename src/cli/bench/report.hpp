#pragma once
#include "cli/bench/rows.hpp"
#include "frame/bench.hpp"
#include "frame/statistics.hpp"

#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>

namespace simreel::cli {

/// One case that was run.
struct BenchRow {
  BenchCase asked;
  glm::ivec2 size{0, 0};  ///< pixels
  std::string sceneHash;
  frame::FrameTimes times;
};

struct BenchReport {
  std::string scene;  ///< file
  std::string device, driver, memoryPath;
  bool software = false;
  std::size_t processors = 1;  ///< that this process may use
  frame::Timing timing = frame::Timing::wait;
  int frames = 0, warmUp = 0, rounds = 0;  ///< asked for
  bool interrupted = false;
  std::vector<BenchRow> rows;
};

/// A stage's medians, ms.
struct StageFigures {
  std::string name;
  double cpu = 0;  ///< with Timing::wait: all of its work
  double gpu = 0;
  std::vector<std::pair<std::string, double>> parts;
};

/// What is said of a row.
struct RowFigures {
  frame::Statistics frame;  ///< ms
  frame::Outliers outliers;
  double perSecond = 0;   ///< frames, outliers included
  double processors = 0;  ///< busy with this process on average
  std::vector<StageFigures> stages;
  double cpu = 0, gpu = 0;  ///< sums of the stages, ms
  /// What bounded it: "surfaces, 61%", "GPU: shadow, 40%", "CPU: step a, 90%", "waiting", or "" where
  /// stages were not timed. Shares are of the median frame.
  std::string bound;
};

[[nodiscard]] RowFigures figuresOf(const frame::FrameTimes& times, frame::Timing timing);

/// Stages worth a column: at least 0.5% of the frame somewhere; in the order in which they run.
[[nodiscard]] std::vector<std::string> shownStages(const std::vector<RowFigures>& rows);

/// Two tables: frames, and what their stages took. Ends in a newline.
[[nodiscard]] std::string benchText(const BenchReport& report);

/// The same and all samples. Times are milliseconds; a "spread" is {"median", "p5", "p95", "mean", "least",
/// "most"}:
///
///     "bench": 1                      this format
///     "version", "scene", "device", "driver", "memoryPath", "command"
///     "software": true                the driver draws on the CPU
///     "processors": n                 that this process may use
///     "timing": "wait", "query" or "whole"   wait: "gpu" is null; whole: "stages" is empty
///     "framesAsked", "warmUp", "rounds", "interrupted"
///     "rows": [{
///       "name", "set": {path: value}, "size": [w, h], "sceneHash",
///       "frames": n                   measured; fewer than asked for when interrupted
///       "framesPerSecond", "frame": spread, "waited": spread,
///       "processor": spread           user and system time of all threads
///       "processorsBusy"              fraction: that over "frame" times "processors"
///       "outliers": {"bound", "count", "worst": {"frame", "ms"} or null},   beyond 3 medians
///       "boundBy",
///       "stages": [{"name", "cpu": spread, "gpu": spread or null, "parts": {name: spread}}],
///       "samples": {"frame": [number...], "ms": [...]}}]
///
/// Means add up: those of "cpu" are together at most the mean of "frame", and so are those of "gpu"; with
/// "query" but for the two frames that are under way where measuring begins and ends.
[[nodiscard]] nlohmann::ordered_json benchJson(const BenchReport& report);

}  // namespace simreel::cli
