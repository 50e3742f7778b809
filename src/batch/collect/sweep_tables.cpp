#include "batch/collect/sweep_tables.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "frame/file/manifest.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <system_error>
#include <utility>

namespace simreel::batch {

namespace {

namespace fs = std::filesystem;

/// Quotes a cell as in RFC 4180. Text that a spreadsheet would run as a formula gets a leading apostrophe.
std::string cell(std::string text) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  if (text.find_first_of("=+-@\t\r") == 0 && (read.ec != std::errc() || read.ptr != end))
    text.insert(0, 1, '\'');
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string numberText(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : std::string();
}

/// Collects column names in the order of their first use, and the cells of each job.
class Columns {
 public:
  void set(std::size_t job, const std::string& name, std::string value) {
    if (std::find(names_.begin(), names_.end(), name) == names_.end()) names_.push_back(name);
    cells_[{job, name}] = std::move(value);
  }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] std::string at(std::size_t job, const std::string& name) const {
    const auto found = cells_.find({job, name});
    return found == cells_.end() ? std::string() : found->second;
  }

 private:
  std::vector<std::string> names_;
  std::map<std::pair<std::size_t, std::string>, std::string> cells_;
};

}  // namespace

CollectedSweep collect(SweepPlan plan) {
  CollectedSweep sweep{std::move(plan), {}};
  for (std::size_t i = 0; i < sweep.plan.jobs.size(); ++i) sweep.jobs.push_back(statusOf(sweep.plan, i));
  return sweep;
}

fs::path CollectedSweep::pictureOf(std::size_t job, std::optional<int> frame) const {
  const fs::path folder = plan.jobFolder(job);
  try {
    const auto manifest = frame::readManifest(folder / "manifest.json");
    if (!manifest || manifest->frames.empty()) return {};
    const auto found = frame ? manifest->frames.find(*frame) : std::prev(manifest->frames.end());
    if (found == manifest->frames.end() || found->second.file.find('/') != std::string::npos) return {};
    return folder / found->second.file;
  } catch (const UserError&) {
    return {};
  }
}

std::string tableText(const CollectedSweep& sweep) {
  Columns columns;
  for (std::size_t i = 0; i < sweep.jobs.size(); ++i) {
    if (!sweep.jobs[i].result) continue;
    const JobResult& result = *sweep.jobs[i].result;
    std::map<std::string, bool> passed;
    for (const golden::CheckResult& check : result.checks) {
      columns.set(i, "check " + check.what, numberText(check.value));
      const bool all = passed.try_emplace(check.what, true).first->second &= check.passed;
      columns.set(i, "passed " + check.what, all ? "yes" : "no");
    }
    for (const MeasuredQuantity& quantity : result.quantities)
      columns.set(i, quantity.what, numberText(quantity.value));
    for (const auto& [name, value] : result.counts) columns.set(i, name, value);
  }
  std::string text = "job,state";
  for (const std::string& path : sweep.plan.varied) text += "," + cell(path);
  for (const std::string& name : columns.names()) text += "," + cell(name);
  text += "\n";
  for (std::size_t i = 0; i < sweep.jobs.size(); ++i) {
    text += fmt::format("{},{}", sweep.plan.name(i), stateName(sweep.jobs[i].state));
    for (const scene::Override& value : sweep.plan.jobs[i].values) text += "," + cell(value.value);
    for (const std::string& name : columns.names()) text += "," + cell(columns.at(i, name));
    text += "\n";
  }
  return text;
}

std::string countsText(const CollectedSweep& sweep) {
  std::string text;
  for (std::size_t i = 0; i < sweep.jobs.size(); ++i) {
    const fs::path file = sweep.plan.jobFolder(i) / "counts.csv";
    if (sweep.jobs[i].state != JobState::done || !pathExists(file)) continue;
    const std::string table = readFile(file, "table of counts");
    for (std::size_t begin = 0; begin < table.size();) {
      const std::size_t end = std::min(table.find('\n', begin), table.size());
      // The header line is taken from the first table only.
      if (begin > 0 || text.empty())
        text += (begin == 0 ? std::string("job") : sweep.plan.name(i)) + "," +
                table.substr(begin, end - begin) + "\n";
      begin = end + 1;
    }
  }
  return text;
}

}  // namespace simreel::batch
