#pragma once
#include "batch/sweep/measurements.hpp"
#include "golden/result.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace simreel::batch {

/// How a job of a sweep ended: result.json in its folder, which is written last. Holds no time and nothing
/// of the machine: it is the same wherever the job ran.
struct JobResult {
  std::string hash;  ///< of the job in its plan
  int code = 0;      ///< exit code; 0: all frames are there
  std::string message;
  int frames = 0;
  std::vector<golden::CheckResult> checks;
  std::vector<MeasuredQuantity> quantities;
  std::vector<std::pair<std::string, std::string>> counts;  ///< last row of the table of counts

  [[nodiscard]] bool checksPassed() const;
};

[[nodiscard]] std::string resultText(const JobResult& result);
/// Throws UserError(usage) naming the file and what is wrong in it.
[[nodiscard]] JobResult parseResult(const std::string& text, const std::string& name);

/// Results of checks alone, for a run that goes on later.
[[nodiscard]] std::string checksText(const std::vector<golden::CheckResult>& checks);
/// Empty where the file is not there or cannot be read.
[[nodiscard]] std::vector<golden::CheckResult> readChecks(const std::filesystem::path& file);

}  // namespace simreel::batch
