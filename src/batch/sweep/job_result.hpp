#pragma once
#include "batch/sweep/measurements.hpp"
#include "golden/result.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace simreel::batch {

/// Result of a job of a sweep. It is stored as result.json in the job's folder, which is the last file that
/// the job writes. It contains no times and no data of the machine, so it is the same wherever the job ran.
struct JobResult {
  std::string hash;  ///< hash of the job in its plan
  int code = 0;      ///< exit code of the job; 0 if all frames exist
  std::string message;
  int frames = 0;
  std::vector<golden::CheckResult> checks;
  std::vector<MeasuredQuantity> quantities;
  /// Pairs of column name and value from the last row of the table of counts.
  std::vector<std::pair<std::string, std::string>> counts;

  [[nodiscard]] bool checksPassed() const;
};

[[nodiscard]] std::string resultText(const JobResult& result);
/// Parses a result. Throws UserError(usage) with the file name `name` and the error in the file.
[[nodiscard]] JobResult parseResult(const std::string& text, const std::string& name);

/// Returns the results of checks as JSON, for a run that continues later.
[[nodiscard]] std::string checksText(const std::vector<golden::CheckResult>& checks);
/// Reads the results of checks. Returns an empty list if the file is missing or cannot be read.
[[nodiscard]] std::vector<golden::CheckResult> readChecks(const std::filesystem::path& file);

}  // namespace simreel::batch
