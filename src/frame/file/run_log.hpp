#pragma once
#include "frame/file/run_info.hpp"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace simreel::frame {

/// Record of one process that worked on an output: machine, time, and the frames that it drew.
struct RunRecord {
  std::string program;  ///< version of the program
  std::string host;
  long process = 0;
  std::string began;  ///< start time in UTC, such as 2026-11-25T03:24:06.123Z
  double seconds = 0;
  std::string driver, processor, fingerprint;
  std::string command;
  std::vector<std::string> folders;
  std::set<int> frames;

  /// True if both records describe the same process.
  [[nodiscard]] bool isOf(const RunRecord& other) const {
    return host == other.host && process == other.process && began == other.began;
  }
  /// Returns processor and driver as text, or an empty text if the processor is unknown.
  [[nodiscard]] std::string machine() const;
};

/// Content of run.json, the file next to a manifest with everything that differs between runs of one scene.
struct RunLog {
  std::vector<RunRecord> runs;  ///< records of all runs, sorted by the time of their first write

  /// Returns the machine that drew a frame, or an empty text if unknown.
  [[nodiscard]] std::string machineOf(int frame) const;
  /// Inserts the record, or replaces the earlier record of the same run. Removes the record's frames from
  /// all other records, and removes records without frames.
  void put(const RunRecord& record);
};

/// Returns a record for this process with the current time as start.
[[nodiscard]] RunRecord beginRecord(const RunInfo& run);
[[nodiscard]] std::string runLogText(const RunLog& log);
/// Parses run.json. On failure, throws UserError(usage), whose message contains the file's `name` and the
/// mistake.
[[nodiscard]] RunLog parseRunLog(const std::string& text, const std::string& name);
/// Reads run.json. Returns an empty log if the file is missing or unreadable, because the log is only
/// documentation.
[[nodiscard]] RunLog readRunLog(const std::filesystem::path& file);

}  // namespace simreel::frame
