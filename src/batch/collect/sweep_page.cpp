#include "batch/collect/sweep_page.hpp"

#include "base/error.hpp"
#include "batch/sweep/sweep_run.hpp"
#include "golden/report/thumbnail.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>
#include <tbb/parallel_for.h>

namespace simreel::batch {

namespace {

using Json = nlohmann::ordered_json;

std::string fileNamed(std::string_view name) {
  for (const PageFile& file : pageFiles())
    if (file.path == name) return file.text;
  SIMREEL_CHECK(false);
  return {};
}

void replace(std::string& text, std::string_view mark, const std::string& by) {
  const std::size_t at = text.find(mark);
  SIMREEL_CHECK(at != std::string::npos);
  text.replace(at, mark.size(), by);
}

/// Parses CSV text into rows of cells.
std::vector<std::vector<std::string>> rowsOf(const std::string& csv) {
  std::vector<std::vector<std::string>> rows(1, std::vector<std::string>(1));
  bool quoted = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    const char c = csv[i];
    if (c == '"' && quoted && i + 1 < csv.size() && csv[i + 1] == '"')
      rows.back().back() += csv[i++];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      rows.back().emplace_back();
    else if (c == '\n' && !quoted)
      rows.emplace_back(1);
    else
      rows.back().back() += c;
  }
  rows.pop_back();
  return rows;
}

/// Returns the maximum width and height of the small pictures in pixels. It keeps all pictures together
/// below about 20 MB.
int sideOf(std::size_t jobs) {
  return std::clamp(static_cast<int>(3200.0 / std::sqrt(static_cast<double>(jobs))), 64, 320);
}

}  // namespace

std::string sweepPage(const CollectedSweep& sweep, std::optional<int> frame) {
  const auto rows = rowsOf(tableText(sweep));
  // Skips job, state and values, which the page shows separately.
  const std::size_t known = 2 + sweep.plan.varied.size();
  std::vector<std::string> pictures(sweep.jobs.size()), files(sweep.jobs.size());
  tbb::parallel_for(std::size_t{0}, sweep.jobs.size(), [&](std::size_t i) {
    const auto file = sweep.pictureOf(i, frame);
    if (file.empty()) return;
    pictures[i] = golden::dataAddress(file, sideOf(sweep.jobs.size()));
    files[i] = golden::addressOf(file.lexically_relative(sweep.plan.folder).generic_string());
  });
  SweepTally tally;
  Json jobs = Json::array();
  for (std::size_t i = 0; i < sweep.jobs.size(); ++i) {
    const JobStatus& status = sweep.jobs[i];
    tally.add(status);
    std::vector<std::string> values;
    for (const scene::Override& value : sweep.plan.jobs[i].values) values.push_back(value.value);
    jobs.push_back({{"name", sweep.plan.name(i)},
                    {"state", stateName(status.state)},
                    {"message", status.result ? status.result->message : ""},
                    {"passed", !status.result || status.result->checksPassed()},
                    {"values", values},
                    {"picture", pictures[i]},
                    {"file", files[i]},
                    {"cells", std::vector(rows[i + 1].begin() + static_cast<std::ptrdiff_t>(known),
                                          rows[i + 1].end())}});
  }
  const Json data = {
      {"title", "Sweep of " + fmt::format("{} jobs", sweep.jobs.size())},
      {"summary", tally.text()},
      {"names", shortNames(sweep.plan.varied)},
      {"columns", std::vector(rows[0].begin() + static_cast<std::ptrdiff_t>(known), rows[0].end())},
      {"jobs", jobs}};
  std::string json = data.dump(-1, ' ', true, Json::error_handler_t::replace);
  // Escapes "</", so that the JSON cannot end the element that contains it.
  for (std::size_t at = json.find("</"); at != std::string::npos; at = json.find("</", at + 3))
    json.replace(at, 2, "<\\/");
  std::string page = fileNamed("index.html");
  replace(page, "/*STYLE*/", fileNamed("style.css"));
  replace(page, "/*SCRIPT*/", fileNamed("app.js"));
  replace(page, "/*DATA*/", json);
  return page;
}

}  // namespace simreel::batch
