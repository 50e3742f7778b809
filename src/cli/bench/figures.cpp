#include "cli/bench/report.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

namespace simreel::cli {

namespace {

/// Returns the longest stage and its fraction of the median frame time, such as "surfaces, 61%". If the
/// stage reports its parts, the text is such as "step mesh (deform), 61%".
std::string largest(const RowFigures& row, double StageFigures::*side) {
  const auto max =
      std::max_element(row.stages.begin(), row.stages.end(),
                       [side](const StageFigures& a, const StageFigures& b) { return a.*side < b.*side; });
  std::string name = max->name;
  const auto part = std::max_element(max->parts.begin(), max->parts.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  if (part != max->parts.end()) name += " (" + part->first + ")";
  return fmt::format("{}, {:.0f}%", name, 100 * (*max).*side / std::max(row.frame.median, 1e-9));
}

/// Returns the text for RowFigures::bound. The threshold is below 1 because stage clocks and GPU queries
/// measure slightly less than the whole frame.
std::string boundOf(const RowFigures& row, frame::Timing timing) {
  constexpr double enough = 0.6;
  if (row.stages.empty() || row.frame.count == 0) return "";
  if (timing == frame::Timing::wait) return largest(row, &StageFigures::cpu);
  if (std::max(row.cpu, row.gpu) < enough * row.frame.median) return "waiting";
  return row.gpu >= row.cpu ? "GPU: " + largest(row, &StageFigures::gpu)
                            : "CPU: " + largest(row, &StageFigures::cpu);
}

}  // namespace

RowFigures figuresOf(const frame::FrameTimes& times, frame::Timing timing) {
  RowFigures row;
  row.frame = frame::statisticsOf(times.wall);
  row.outliers = frame::outliersOf(times.wall);
  const double all = std::accumulate(times.wall.begin(), times.wall.end(), 0.0);
  if (all > 0) {
    row.perSecond = 1e3 * static_cast<double>(times.wall.size()) / all;
    row.processors = std::accumulate(times.processor.begin(), times.processor.end(), 0.0) / all;
  }
  const auto median = [](const std::vector<double>& values) { return frame::statisticsOf(values).median; };
  for (const frame::StageSeries& stage : times.stages) {
    StageFigures figures{stage.name, median(stage.cpu), median(stage.gpu), {}};
    for (const auto& part : stage.parts) figures.parts.emplace_back(part.name, median(part.values));
    row.cpu += figures.cpu;
    row.gpu += figures.gpu;
    row.stages.push_back(std::move(figures));
  }
  row.bound = boundOf(row, timing);
  return row;
}

std::vector<std::string> shownStages(const std::vector<RowFigures>& rows) {
  constexpr double fraction = 0.005;
  std::vector<std::string> all;
  std::vector<std::string> shown;
  const auto add = [](std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const RowFigures& row : rows)
    for (const StageFigures& stage : row.stages) {
      add(all, stage.name);
      if (std::max(stage.cpu, stage.gpu) >= fraction * row.frame.median) add(shown, stage.name);
    }
  std::erase_if(all, [&](const std::string& name) {
    return std::find(shown.begin(), shown.end(), name) == shown.end();
  });
  return all;
}

}  // namespace simreel::cli
