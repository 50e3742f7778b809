#pragma once
#include "golden/result.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace simreel::golden {

/// The report of one part of a run, such as a shard.
struct PartReport {
  std::filesystem::path file;  ///< path of report.json
  SuiteResult suite;
};

/// Reads report.json, given its path or its folder. Throws UserError: usage if the file is missing or not a
/// valid report, inputOutput if it cannot be read.
[[nodiscard]] PartReport readPart(const std::filesystem::path& report);

struct Merged {
  SuiteResult suite;  ///< merged report, with scenes sorted by name
  /// Shards such as "3/4" that have no report, although another shard "k/4" has one.
  std::vector<std::string> missingShards;
};

/// Merges several reports into one. Each scene must be in exactly one report. Copies the pictures below
/// `folder`/files. Adds a note for each missing picture. Throws UserError(usage) if two reports contain the
/// same scene or shard, or if the reports do not belong together.
[[nodiscard]] Merged mergeReports(const std::vector<PartReport>& parts,
                                  const std::filesystem::path& folder);

}  // namespace simreel::golden
