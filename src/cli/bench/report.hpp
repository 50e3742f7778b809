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

/// One row of the benchmark's report, for one case.
struct BenchRow {
  BenchCase asked;
  glm::ivec2 size{0, 0};  ///< picture size in pixels
  std::string sceneHash;
  frame::FrameTimes times;
};

struct BenchReport {
  std::string scene;  ///< path of the scene file
  std::string device, driver, memoryPath;
  bool software = false;
  std::size_t processors = 1;  ///< number of processors that this process may use
  frame::Timing timing = frame::Timing::wait;
  int frames = 0, warmUp = 0, rounds = 0;  ///< numbers of frames that the user requested
  bool interrupted = false;
  std::vector<BenchRow> rows;
};

/// Median times of one stage, in ms.
struct StageFigures {
  std::string name;
  double cpu = 0;  ///< median time on the CPU; with Timing::wait, the stage's whole time
  double gpu = 0;
  std::vector<std::pair<std::string, double>> parts;
};

/// Statistics of one row of the benchmark.
struct RowFigures {
  frame::Statistics frame;  ///< statistics of frame times, ms
  frame::Outliers outliers;
  double perSecond = 0;   ///< frames per second, computed from all frames including outliers
  double processors = 0;  ///< average number of processors that this process kept busy
  std::vector<StageFigures> stages;
  double cpu = 0, gpu = 0;  ///< sum of the stages' median times, ms
  /// The stage that limits the frame time: "surfaces, 61%", "GPU: shadow, 40%", "CPU: step a, 90%" or
  /// "waiting". Empty if stages were not timed. Percentages are relative to the median frame time.
  std::string bound;
};

[[nodiscard]] RowFigures figuresOf(const frame::FrameTimes& times, frame::Timing timing);

/// Returns the stages that take at least 0.5% of the frame in some row, in execution order.
[[nodiscard]] std::vector<std::string> shownStages(const std::vector<RowFigures>& rows);

/// Returns two tables as text: frame times and stage times. The text ends with a newline.
[[nodiscard]] std::string benchText(const BenchReport& report);

/// Returns the statistics and all samples as JSON. Times are milliseconds; a "spread" is {"median", "p5",
/// "p95", "mean", "least", "most"}:
///
///     "bench": 1                      version of this format
///     "version", "scene", "device", "driver", "memoryPath", "command"
///     "software": true                true if the driver draws on the CPU
///     "processors": n                 number of processors that this process may use
///     "timing": "wait", "query" or "whole"   wait: "gpu" is null; whole: "stages" is empty
///     "framesAsked", "warmUp", "rounds", "interrupted"
///     "rows": [{
///       "name", "set": {path: value}, "size": [w, h], "sceneHash",
///       "frames": n                   measured; fewer than requested if interrupted
///       "framesPerSecond", "frame": spread, "waited": spread,
///       "processor": spread           user and system time of all threads
///       "processorsBusy"              fraction: "processor" over "frame" times "processors"
///       "outliers": {"bound", "count", "worst": {"frame", "ms"} or null},   beyond 3 medians
///       "boundBy",
///       "stages": [{"name", "cpu": spread, "gpu": spread or null, "parts": {name: spread}}],
///       "samples": {"frame": [number...], "ms": [...]}}]
///
/// The means of "cpu" over all stages sum to at most the mean of "frame"; the same holds for "gpu". With
/// "query" the sums can be off by the two frames that are in flight at the start and the end of the
/// measurement.
[[nodiscard]] nlohmann::ordered_json benchJson(const BenchReport& report);

}  // namespace simreel::cli
