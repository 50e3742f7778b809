#pragma once
#include "golden/result.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace simreel::golden {

/// The report of a part of a run.
struct PartReport {
  std::filesystem::path file;  ///< report.json
  SuiteResult suite;
};

/// Reads report.json, or that of a folder. Throws UserError(usage).
[[nodiscard]] PartReport readPart(const std::filesystem::path& report);

struct Merged {
  SuiteResult suite;  ///< scenes by name
  /// "3/4": parts that no report is of, though the others are parts of as many.
  std::vector<std::string> missingShards;
};

/// One report of the scenes of several, each of which one report holds. Their pictures are copied below
/// `folder`/files; one that is gone is noted. Throws UserError(usage) for a scene or a shard that two
/// reports hold, and for reports that do not belong together.
[[nodiscard]] Merged mergeReports(const std::vector<PartReport>& parts,
                                  const std::filesystem::path& folder);

}  // namespace simreel::golden
