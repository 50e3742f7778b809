#include "cli/bench/report.hpp"

#include "base/text.hpp"
#include "base/version.hpp"
#include "cli/commands.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace simreel::cli {

namespace {

using nlohmann::ordered_json;
constexpr std::array timingNames = {"wait", "query", "whole"};

using Lines = std::vector<std::vector<std::string>>;

/// Aligns the columns of a table. The first column is aligned to the left, the others to the right. `tail`:
/// true to leave the last column unaligned.
std::string aligned(const Lines& lines, bool tail) {
  std::vector<std::size_t> width;
  for (const auto& line : lines) {
    width.resize(std::max(width.size(), line.size()));
    for (std::size_t i = 0; i < line.size(); ++i) width[i] = std::max(width[i], line[i].size());
  }
  std::string text;
  for (const auto& line : lines) {
    std::string row;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (i > 0) row += "  ";
      if (i == 0)
        row += fmt::format("{:<{}}", line[i], width[i]);
      else if (tail && i + 1 == width.size())
        row += line[i];
      else
        row += fmt::format("{:>{}}", line[i], width[i]);
    }
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + "\n";
  }
  return text;
}

/// Formats a time with three significant digits, so that microseconds on a GPU are visible.
std::string ms(double value) {
  return value >= 100  ? fmt::format("{:.0f}", value)
         : value >= 10 ? fmt::format("{:.1f}", value)
         : value >= 1  ? fmt::format("{:.2f}", value)
                       : fmt::format("{:.3f}", value);
}

std::string outlierText(const RowFigures& row, const frame::FrameTimes& times) {
  if (row.outliers.count == 0) return "none";
  const auto worst = static_cast<std::size_t>(row.outliers.worst);
  return fmt::format("{}, worst {} ms in frame {}", row.outliers.count, ms(times.wall[worst]),
                     times.frames[worst]);
}

std::string frameTable(const BenchReport& report, const std::vector<RowFigures>& rows) {
  Lines lines = {{"frames, ms", "measured", "median", "5th", "95th", "frames/s", "processors busy",
                  "beyond 3 medians", "bounded by"}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const RowFigures& row = rows[i];
    if (row.frame.count == 0) {
      lines.push_back({oneLine(report.rows[i].asked.name), "0"});
      continue;
    }
    lines.push_back({oneLine(report.rows[i].asked.name), fmt::format("{}", row.frame.count),
                     ms(row.frame.median), ms(row.frame.p5), ms(row.frame.p95),
                     fmt::format("{:.1f}", row.perSecond),
                     fmt::format("{:.0f}%", 100 * row.processors / static_cast<double>(report.processors)),
                     outlierText(row, report.rows[i].times), row.bound});
  }
  return aligned(lines, true);
}

/// One column of the stage table. It shows a whole stage if `part` is empty, and otherwise one part of the
/// stage.
struct Column {
  std::string stage, part;
};

std::vector<Column> columnsOf(const std::vector<RowFigures>& rows) {
  std::vector<Column> columns;
  for (const std::string& name : shownStages(rows)) {
    columns.push_back({name, ""});
    std::vector<std::string> parts;
    for (const RowFigures& row : rows)
      for (const StageFigures& stage : row.stages)
        for (const auto& part : stage.parts)
          if (stage.name == name && std::find(parts.begin(), parts.end(), part.first) == parts.end())
            parts.push_back(part.first);
    for (const std::string& part : parts) columns.push_back({name, part});
  }
  return columns;
}

std::string cell(const RowFigures& row, const Column& column, double StageFigures::*side) {
  for (const StageFigures& stage : row.stages) {
    if (stage.name != column.stage) continue;
    if (column.part.empty()) return ms(stage.*side);
    // A step reports its parts only once, not for CPU and GPU separately. The table shows the parts on the
    // side (CPU or GPU) with the longer time.
    if (stage.*side < std::max(stage.cpu, stage.gpu)) return "";
    for (const auto& [name, value] : stage.parts)
      if (name == column.part) return ms(value);
  }
  return "-";
}

std::string stageTable(const BenchReport& report, const std::vector<RowFigures>& rows) {
  const auto columns = columnsOf(rows);
  if (columns.empty()) return "";
  Lines lines = {{"stages, median ms"}};
  for (const Column& column : columns)
    lines[0].push_back(column.part.empty() ? column.stage : "of it " + column.part);
  lines[0].emplace_back("rest");
  const auto add = [&](const std::string& name, const RowFigures& row, double StageFigures::*side) {
    std::vector<std::string> line = {name};
    double rest = row.frame.median;
    for (const Column& column : columns) {
      line.push_back(cell(row, column, side));
      for (const StageFigures& stage : row.stages)
        if (stage.name == column.stage && column.part.empty()) rest -= stage.*side;
    }
    line.push_back(ms(std::max(rest, 0.0)));
    lines.push_back(std::move(line));
  };
  const bool queried = report.timing == frame::Timing::query;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string name = oneLine(report.rows[i].asked.name);
    if (rows[i].frame.count == 0) continue;
    if (queried) add(name + ", GPU", rows[i], &StageFigures::gpu);
    add(queried ? name + ", CPU" : name, rows[i], &StageFigures::cpu);
  }
  return "\n" + aligned(lines, false);
}

/// Rounds milliseconds to nanoseconds, the resolution of the clocks.
double rounded(double value) {
  return std::round(value * 1e6) / 1e6;
}

ordered_json spread(std::span<const double> values) {
  const auto s = frame::statisticsOf(values);
  return {{"median", rounded(s.median)}, {"p5", rounded(s.p5)},     {"p95", rounded(s.p95)},
          {"mean", rounded(s.mean)},     {"least", rounded(s.min)}, {"most", rounded(s.max)}};
}

ordered_json outliersJson(const RowFigures& row, const frame::FrameTimes& times) {
  ordered_json worst;
  if (row.outliers.worst >= 0) {
    const auto at = static_cast<std::size_t>(row.outliers.worst);
    worst = {{"frame", times.frames[at]}, {"ms", rounded(times.wall[at])}};
  }
  return {{"bound", rounded(row.outliers.bound)}, {"count", row.outliers.count}, {"worst", worst}};
}

ordered_json stageJson(const frame::StageSeries& stage, frame::Timing timing) {
  ordered_json parts = ordered_json::object();
  for (const auto& part : stage.parts) parts[part.name] = spread(part.values);
  return {{"name", stage.name},
          {"cpu", spread(stage.cpu)},
          {"gpu", timing == frame::Timing::query ? spread(stage.gpu) : ordered_json(nullptr)},
          {"parts", parts}};
}

ordered_json rowJson(const BenchRow& row, const BenchReport& report) {
  const frame::Timing timing = report.timing;
  const RowFigures figures = figuresOf(row.times, timing);
  ordered_json set = ordered_json::object();
  for (const scene::Override& change : row.asked.changes) set[change.path] = change.value;
  ordered_json stages = ordered_json::array();
  for (const frame::StageSeries& stage : row.times.stages) stages.push_back(stageJson(stage, timing));
  ordered_json samples = ordered_json::array();
  for (const double value : row.times.wall) samples.push_back(rounded(value));
  return {{"name", row.asked.name},
          {"set", set},
          {"size", {row.size.x, row.size.y}},
          {"sceneHash", row.sceneHash},
          {"frames", figures.frame.count},
          {"framesPerSecond", figures.perSecond},
          {"frame", spread(row.times.wall)},
          {"waited", spread(row.times.waited)},
          {"processor", spread(row.times.processor)},
          {"processorsBusy", rounded(figures.processors / static_cast<double>(report.processors))},
          {"outliers", outliersJson(figures, row.times)},
          {"boundBy", figures.bound},
          {"stages", stages},
          {"rays", row.times.rays},
          {"samples", {{"frame", row.times.frames}, {"ms", samples}}}};
}

/// Returns the line about ray counts of pictures with quality "high". The time of their shading stage is
/// proportional to the number of rays.
std::string raysText(const BenchReport& report, const std::vector<RowFigures>& rows) {
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto rays = static_cast<double>(report.rows[i].times.rays);
    if (rays == 0) continue;
    text += fmt::format("\n{}: {:.4g} million rays in the last frame", oneLine(report.rows[i].asked.name),
                        1e-6 * rays);
    for (const StageFigures& stage : rows[i].stages) {
      const double took = report.timing == frame::Timing::query ? stage.gpu : stage.cpu;
      if (stage.name == "surfaces" && took > 0)
        text += fmt::format(", with all that shades it {:.4g} million a second", 1e-3 * rays / took);
    }
    text += "\n";
  }
  return text;
}

}  // namespace

std::string benchText(const BenchReport& report) {
  std::vector<RowFigures> rows;
  for (const BenchRow& row : report.rows) rows.push_back(figuresOf(row.times, report.timing));
  const glm::ivec2 size = report.rows.front().size;
  const bool oneSize = std::all_of(report.rows.begin(), report.rows.end(),
                                   [&](const BenchRow& row) { return row.size == size; });
  std::string text = fmt::format(
      "{}, {}{}; {}\n", report.scene, oneSize ? fmt::format("{}x{}", size.x, size.y) : "several sizes",
      report.timing == frame::Timing::whole ? ", frames as a whole" : "", report.device);
  text += frameTable(report, rows) + stageTable(report, rows) + raysText(report, rows);
  if (report.timing == frame::Timing::wait)
    text +=
        "Each stage is waited for, so that it can be told apart; with --timing whole they overlap as in "
        "`render`.\n";
  return text;
}

ordered_json benchJson(const BenchReport& report) {
  ordered_json rows = ordered_json::array();
  for (const BenchRow& row : report.rows) rows.push_back(rowJson(row, report));
  return {{"bench", 1},
          {"version", version()},
          {"scene", report.scene},
          {"device", report.device},
          {"driver", report.driver},
          {"memoryPath", report.memoryPath},
          {"software", report.software},
          {"processors", report.processors},
          {"command", commandLine()},
          {"timing", timingNames.at(static_cast<std::size_t>(report.timing))},
          {"framesAsked", report.frames},
          {"warmUp", report.warmUp},
          {"rounds", report.rounds},
          {"interrupted", report.interrupted},
          {"rows", rows}};
}

}  // namespace simreel::cli
