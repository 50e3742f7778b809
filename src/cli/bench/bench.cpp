// simreel bench: measures the time of each stage of a frame, for one scene or several variants of the
// scene.
#include "frame/bench.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/processor.hpp"
#include "cli/bench/chart.hpp"
#include "cli/bench/report.hpp"
#include "cli/bench/rows.hpp"
#include "cli/commands.hpp"
#include "cli/options/device_options.hpp"
#include "cli/options/scene_options.hpp"
#include "frame/interrupt.hpp"
#include "frame/sink/progress.hpp"
#include "gl/context.hpp"
#include "sim/world/list.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

constexpr int maxFrames = 1'000'000;

struct BenchOptions {
  SceneOptions scene;
  std::vector<std::string> vary;
  std::string technique;
  int frames = 200;
  int warmUp = 30;
  int rounds = 3;
  std::string timing;
  std::string json, chart;
  gl::ContextOptions on;
  std::string progress = "auto";
};

void checkCounts(const BenchOptions& o) {
  const auto within = [](const char* flag, int value, int min) {
    if (value < min || value > maxFrames)
      fail(ExitCode::usage, "{} takes a number from {} to {}, not {}", flag, min, maxFrames, value);
  };
  within("--frames", o.frames, 1);
  within("--warm-up", o.warmUp, 0);
  within("--rounds", o.rounds, 1);
}

/// Checks that the output files can be written, so that an error is not reported after minutes of
/// measuring.
void checkFiles(const BenchOptions& o) {
  if (!o.chart.empty() && std::filesystem::path(o.chart).extension() != ".svg")
    fail(ExitCode::usage,
         "--chart {}: charts are SVG; name a file that ends in .svg (rsvg-convert makes PNG of it)",
         o.chart);
  for (const std::string& file : {o.json, o.chart})
    if (!file.empty() && file != "-") checkWritable(file);
}

/// Returns one row per case and stores the scenes of the cases in `scenes`. Errors in values are thrown in
/// this function, before a device starts.
std::vector<BenchRow> rowsOf(const BenchOptions& o, std::vector<scene::Scene>& scenes) {
  std::vector<std::vector<BenchChoice>> lists;
  if (!o.technique.empty())
    lists.push_back(parseTechniques(o.technique, o.scene.load(), sim::kinds().list));
  for (const std::string& text : o.vary) lists.push_back(parseVary(text));
  std::vector<BenchRow> rows;
  for (BenchCase& one : combine(lists, std::filesystem::path(o.scene.file).stem().string())) {
    scenes.push_back(o.scene.load(one.changes));
    rows.push_back({std::move(one), scenes.back().render.size, scenes.back().hash, {}});
  }
  return rows;
}

frame::Timing timingOf(const BenchOptions& o) {
  return o.timing.empty()      ? frame::usualTiming()
         : o.timing == "wait"  ? frame::Timing::wait
         : o.timing == "query" ? frame::Timing::query
                               : frame::Timing::whole;
}

/// Runs `work` for a row. If there are several rows, an error message is prefixed with the row's name.
template <class Work>
void ofRow(const BenchReport& report, const BenchRow& row, frame::Progress& progress, Work work) {
  try {
    work();
  } catch (const UserError& error) {
    progress.finish("failed", {});
    if (report.rows.size() == 1) throw;
    fail(error.code(), "{}: {}", row.asked.name, error.what());
  }
}

/// Measures the rows alternately, so that a disturbance of the machine affects all rows alike.
void measure(BenchReport& report, std::vector<scene::Scene> scenes, const gl::Context& context,
             frame::Progress& progress) {
  constexpr int refill =
      3;  // number of warm-up frames after which caches and pipeline contain only this row's data
  std::vector<frame::BenchRun> runs;
  const int rounds = std::min(report.rounds, report.frames);
  const int rows = static_cast<int>(report.rows.size());
  const int later = std::min(report.warmUp, refill);
  progress.start(rows * (report.warmUp + (rounds - 1) * later + report.frames));
  int done = 0;
  const auto frameDone = [&] {
    progress.frame(done, {});
    ++done;
    return frame::interruptSignal() == 0;
  };
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < report.rows.size(); ++i) {
      if (frame::interruptSignal() != 0) break;
      const int frames = report.frames / rounds + int{round < report.frames % rounds};
      ofRow(report, report.rows[i], progress, [&] {
        if (round == 0) runs.emplace_back(std::move(scenes[i]), context, report.timing);
        runs[i].run(round == 0 ? report.warmUp : later, frames, frameDone);
      });
    }
  report.interrupted = frame::interruptSignal() != 0;
  progress.finish(report.interrupted ? "interrupted" : "ok", {});
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!report.interrupted && runs[i].scene().render.quality == scene::Quality::high) runs[i].countRays();
    report.rows[i].times = runs[i].times();
  }
}

void bench(const BenchOptions& o) {
  checkCounts(o);
  checkFiles(o);
  frame::Progress progress(frame::parseProgressMode(o.progress));
  std::vector<scene::Scene> scenes;
  auto rows = rowsOf(o, scenes);
  frame::catchInterrupts();
  frame::ignoreBrokenPipes();
  const gl::Context context(o.on);
  BenchReport report{.scene = o.scene.file,
                     .device = context.device().name,
                     .driver = context.device().version,
                     .memoryPath = gl::memoryPath() == gl::MemoryPath::texel ? "texel" : "storage",
                     .software = gl::softwareDriver(),
                     .processors = processorCount(),
                     .timing = timingOf(o),
                     .frames = o.frames,
                     .warmUp = o.warmUp,
                     .rounds = o.rounds,
                     .rows = std::move(rows)};
  measure(report, std::move(scenes), context, progress);
  const std::string json = o.json.empty() ? "" : benchJson(report).dump(1, ' ', o.json == "-") + "\n";
  printText(o.json == "-" ? json : benchText(report));
  if (!o.json.empty() && o.json != "-") writeFileAtomically(o.json, json);
  if (!o.chart.empty()) writeFileAtomically(o.chart, benchChart(report));
  if (const int signal = frame::interruptSignal(); signal != 0) {
    info("simreel: interrupted; this is what was measured so far");
    setExitCode(128 + signal);
  }
}

}  // namespace

void addBench(CLI::App& app) {
  auto o = std::make_shared<BenchOptions>();
  auto* command = app.add_subcommand("bench", "Time the frames of a scene and their stages");
  o->scene.add(*command);
  command
      ->add_option("--vary", o->vary,
                   "Measure a row for each value, path=a,b,c; if repeated, a row for each combination")
      ->allow_extra_args(false);
  command->add_option("--technique", o->technique,
                      "Measure a row for each technique (all, or some with commas between), set in every "
                      "object that has techniques");
  command->add_option("--frames", o->frames, "Frames to measure for each row")->capture_default_str();
  command->add_option("--warm-up", o->warmUp, "Frames before these, which are not measured")
      ->capture_default_str();
  command->add_option("--rounds", o->rounds, "Rounds of measurement; each round measures every row once")
      ->capture_default_str();
  command
      ->add_option("--timing", o->timing,
                   "How time is measured: wait for each stage, query the device's clock, or whole frames "
                   "(default: wait on a software driver, else query)")
      ->check(CLI::IsMember({"wait", "query", "whole"}));
  command->add_option("--json", o->json, "File for all results as JSON, or -");
  command->add_option("--chart", o->chart, "File for a chart, .svg");
  addDevice(*command, o->on);
  command->add_option("--progress", o->progress, "auto, tty, ndjson or none");
  command->footer(
      "\"Processors busy\" is the user and system time of all threads, including a software driver's, "
      "divided by the time that the frames took and by the processors that this process may use; with "
      "--timing whole it is as in `render`.");
  command->callback([o] { bench(*o); });
}

}  // namespace simreel::cli
